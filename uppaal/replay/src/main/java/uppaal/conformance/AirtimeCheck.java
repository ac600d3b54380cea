package uppaal.conformance;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/** A board with an airtime limit (SPEC 7.6) sends for no more than its share of any hour, also over resets. */
final class AirtimeCheck implements Check {
    private static final double HOUR_SECONDS = 3600;
    private static final double PERCENT = 100;
    private static final double ROUNDING_SECONDS = 1e-3;

    /** A board's packets of the last hour. */
    private static final class Limited {
        final Deque<Transmission> packets = new ArrayDeque<>();
        double sum;
        /** Of an hour; over 100 before it declares a limit. */
        double percent = Double.POSITIVE_INFINITY;
    }

    private final Map<String, Limited> boards = new HashMap<>();
    private final Header header;

    AirtimeCheck(Header header) {
        this.header = header;
    }

    @Override
    public void point(Point point) {
        if (point.is("AIRTIME_LIMIT")) {
            boards.computeIfAbsent(point.board(), added -> new Limited()).percent = point.operand("percent");
        }
    }

    @Override
    public void ends(Transmission packet) throws RefusedException {
        Limited board = boards.get(packet.board());
        if (board == null) {
            return;
        }
        double hour = HOUR_SECONDS * header.second(packet.board());
        double from = packet.end() - hour;
        board.packets.add(packet);
        board.sum += packet.seconds();
        while (board.packets.element().end() <= from) {
            board.sum -= board.packets.remove().seconds();
        }
        Transmission first = board.packets.element();
        double used = board.sum - Math.max(0, from - first.start());
        if (used > hour * board.percent / PERCENT + ROUNDING_SECONDS) {
            throw new RefusedException(String.format(Locale.ROOT, "%s has sent for %.3f s of the last hour",
                    packet.board(), used), String.format(Locale.ROOT, "%.0f %% of it at most", board.percent));
        }
    }
}
