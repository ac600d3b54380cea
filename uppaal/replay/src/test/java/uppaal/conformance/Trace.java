package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import javino.protocol.Airtime;

/** A trace, line by line, replayed by one check. */
final class Trace {
    private static final double BIT = 1 / 2000.0;
    private static final double RUN = 0.001;

    private final Replay replay;
    private int count;

    Trace(Function<Header, Check> check) {
        replay = new Replay(List.of(check), Optional.empty());
        line("{'t':0,'event':'scenario','version':2,'radio':{'bitRate':2000},"
                + "'boards':[{'name':'a'},{'name':'b'},{'name':'c'}]}");
    }

    Trace line(String line) {
        count++;
        replay.line(line.replace('\'', '"'));
        return this;
    }

    /** A board's point in a run() that begins at that time, 1 ms behind the one before. */
    Trace point(double seconds, String board, String name, String operands) {
        return line(String.format(Locale.ROOT, "{'t':%.6f,'board':'%s','event':'point','name':'%s'%s,'run':%.6f,"
                + "'gap':%.6f}", seconds, board, name, operands.isEmpty() ? "" : "," + operands, seconds, RUN));
    }

    /** A packet of so many bytes that a board begins to send. */
    Trace sends(double seconds, String board, String payload, String fields) {
        return packet("rf-tx", seconds, board, payload, fields);
    }

    /** It reaches another board. */
    Trace hears(double seconds, String board, String payload, String from, String fields) {
        return packet("rf-rx", seconds + 0.00011, board, payload, ",'from':'" + from + "'" + fields);
    }

    private Trace packet(String event, double start, String board, String payload, String fields) {
        int bits = Airtime.bits(payload.length() / 2);
        double end = start + (bits - 1) * BIT;
        return line(String.format(Locale.ROOT, "{'t':%.6f,'board':'%s','event':'%s','payload':'%s','kind':'any',"
                + "'bits':%d,'start':%.6f,'end':%.6f%s}", end, board, event, payload, bits, start, end, fields));
    }

    static double airtime(String payload) {
        return (Airtime.bits(payload.length() / 2) - 1) * BIT;
    }

    void isAccepted() {
        replay.finish();
        assertEquals(Optional.empty(), replay.refusal());
    }

    /** By its last line, or at its end. */
    void isRefused(String why) {
        replay.finish();
        String refusal = replay.refusal().orElse("nothing");
        assertTrue(refusal.contains(why), refusal);
    }
}
