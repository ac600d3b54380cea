package air;

import harness.Table;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The tables beside the picture: who had the air, and why packets collided. */
final class Figures {

    private static final int SLOT_BITS = 16;

    private final List<Packet> packets;
    private final double from;
    private final double to;

    /** @param packets those of this stretch of time */
    Figures(List<Packet> packets, double from, double to) {
        this.packets = packets;
        this.from = from;
        this.to = to;
    }

    /** The figures as plain text. */
    String text(AirTrace trace) {
        return Table.text("%.3f s to %.3f s%n%s%n%n%s%n%s", from, to, use(), shares(trace), causes());
    }

    private String use() {
        double busy = 0;
        double several = 0;
        double until = from;
        double severalUntil = from;
        for (Packet packet : packets) {
            double end = Math.min(packet.end, to);
            double beside = Math.min(end, until);
            busy += Math.max(0, end - Math.max(packet.start, until));
            several += Math.max(0, beside - Math.max(packet.start, severalUntil));
            until = Math.max(until, end);
            severalUntil = Math.max(severalUntil, beside);
        }
        return Table.text("air used: %.1f %% of the time, by more than one at once %.1f %%", 100 * busy / (to - from),
                100 * several / (to - from));
    }

    private double seconds(Packet packet) {
        return Math.min(packet.end, to) - Math.max(packet.start, from);
    }

    private String shares(AirTrace trace) {
        Table table = new Table(Stream.concat(Stream.of("board", "air"), Stream.concat(
                Arrays.stream(Packet.Kind.values()).map(kind -> kind.title),
                Stream.of("parity", "collided", "damaged")))
                .toArray(String[]::new));
        for (String board : trace.boards()) {
            share(table, trace.title(board), packet -> packet.board.equals(board));
        }
        share(table, "together", packet -> true);
        return table.text();
    }

    private void share(Table table, String title, Predicate<Packet> whose) {
        List<Packet> own = packets.stream().filter(whose).toList();
        if (own.isEmpty()) {
            return;
        }
        List<Object> cells = new ArrayList<>();
        cells.add(title);
        cells.add(Table.text("%.1f %%", 100 * own.stream().mapToDouble(this::seconds).sum() / (to - from)));
        for (Packet.Kind kind : Packet.Kind.values()) {
            cells.add(count(own, packet -> packet.kind == kind));
        }
        cells.add(count(own, packet -> packet.trailer.equals("parity")));
        cells.add(count(own, packet -> !packet.met.isEmpty()));
        cells.add(count(own, packet -> !packet.damagedAt.isEmpty()));
        table.row(cells.toArray());
    }

    private static long count(List<Packet> packets, Predicate<Packet> wanted) {
        return packets.stream().filter(wanted).count();
    }

    private String causes() {
        Table table = new Table("cause", "times", "packets damaged", "bits apart");
        List<String> meanings = new ArrayList<>();
        for (Cause cause : Cause.values()) {
            List<Packet> those = packets.stream().filter(packet -> packet.cause == cause).toList();
            if (those.isEmpty()) {
                continue;
            }
            meanings.add(cause.mark + " " + cause.title + ": " + cause.meaning);
            row(table, cause.mark + " " + cause.title, those);
            List<String> sorts = those.stream().map(Figures::sort).distinct().sorted().toList();
            for (String sort : sorts.size() > 1 ? sorts : List.<String>of()) {
                row(table, "  " + sort, those.stream().filter(packet -> sort(packet).equals(sort)).toList());
            }
        }
        return meanings.isEmpty() ? "\nno packet was damaged, and none collided\n"
                : "\n" + table.text() + "\n\n" + String.join("\n", meanings) + "\n";
    }

    private static void row(Table table, String title, List<Packet> those) {
        Set<Packet> damaged =
                those.stream().flatMap(packet -> Stream.concat(Stream.of(packet), packet.earlier().stream()))
                        .filter(packet -> !packet.damagedAt.isEmpty()).collect(Collectors.toSet());
        double[] apart = those.stream().filter(packet -> !packet.earlier().isEmpty()).mapToDouble(Figures::bitsApart)
                .sorted().toArray();
        table.row(title, those.size(), damaged.size(), apart.length == 0 ? "" : Table.text("%.0f…%.0f, median %.0f",
                apart[0], apart[apart.length - 1], apart[apart.length / 2]));
    }

    /** The bits since the packet began that began last before. */
    private static double bitsApart(Packet packet) {
        double before = packet.earlier().stream().mapToDouble(other -> other.start).max().orElse(packet.start);
        return (packet.start - before) / packet.slot * SLOT_BITS;
    }

    private static String sort(Packet packet) {
        if (packet.earlier().isEmpty()) {
            return packet.isAnswer() ? "acknowledgement" : "message";
        }
        long answers = packet.earlier().stream().filter(Packet::isAnswer).count();
        if (packet.isAnswer()) {
            return answers > 0 ? "acknowledgement behind acknowledgement" : "acknowledgement behind message";
        }
        return answers > 0 ? "message behind acknowledgement" : "message behind message";
    }
}
