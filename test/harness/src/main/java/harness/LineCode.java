package harness;

import java.nio.charset.StandardCharsets;
import java.util.List;
import javino.vectors.RadioVectors;
import trace.TraceEvent;

/** VirtualWire's line code by the maker of the vectors, which shares nothing with library, firmware and emulator. */
public final class LineCode {

    private LineCode() {}

    /** The bits that a transmit pin is to show of a payload between its first rise and its last fall. */
    public static String bits(String payload) {
        return RadioVectors.bits(payload.getBytes(StandardCharsets.US_ASCII)).replaceAll("^0+|0+$", "");
    }

    /** The bits that it showed, {@code bitSeconds} each. */
    public static String bits(List<TraceEvent> pinEvents, double bitSeconds) {
        StringBuilder bits = new StringBuilder();
        for (int i = 0; i + 1 < pinEvents.size(); i++) {
            long count = Math.round((pinEvents.get(i + 1).seconds() - pinEvents.get(i).seconds()) / bitSeconds);
            bits.append(String.valueOf(pinEvents.get(i).number("level")).repeat((int) count));
        }
        return bits.toString();
    }
}
