package uppaal.conformance;

import java.util.Set;
import javino.protocol.Airtime;
import javino.protocol.Payload;
import trace.TraceEvent;

/**
 * A packet on the air.
 *
 * @param number the emulator's
 * @param declared by which point its board's radio has taken it; null if by none
 * @param trailer {@code mark}, {@code parity} or empty (SPEC 6.1)
 * @param path of SPEC 6
 * @param start of its first bit, in seconds
 * @param end of its last one, and of its trailer's
 */
record Transmission(TraceEvent event, int number, Point declared, Payload payload, int path, String trailer, int bits,
        double start, double end) {

    private static final Set<String> OF_ONE_MESSAGE = Set.of("unicast", "fragment");
    private static final int MARK_BITS = 12;
    private static final int PARITY_BITS = 12 * 17;
    private static final int SHORT_PARITY_BITS = 12 * 13;
    /** The most bytes of payload whose parity is short. */
    private static final int SHORT_PAYLOAD = 45;

    static Transmission of(TraceEvent event, Point declared) {
        Payload payload = Payload.of(javino.protocol.Bytes.copyOf(event.bytes("payload")));
        return new Transmission(event, event.number("packet"), declared, payload, event.path(),
                event.textOrEmpty("trailer"), event.number("bits"), event.real("start"), event.real("end"));
    }

    /** The same with another path. */
    Transmission of(int other) {
        return new Transmission(event, number, declared, payload, other, trailer, bits, start, end);
    }

    /** Whether its board has declared it by a point of this name, or whose name begins so. */
    boolean isDeclared(String point) {
        return declared != null && declared.name().startsWith(point);
    }

    /** Relays behind it. */
    int hops() {
        return path % TraceEvent.HOPS;
    }

    /** One more than the distance that it tells; 0 if it tells none. */
    int told() {
        return path / TraceEvent.HOPS;
    }

    String board() {
        return event.board();
    }

    double seconds() {
        return end - start;
    }

    boolean isOfModule() {
        return event.has("radio");
    }

    /** The bits that its bytes and its trailer need (SPEC 6, 6.1). */
    int expectedBits() {
        return wholeBits() + switch (trailer) {
            case "mark" -> MARK_BITS;
            case "parity" -> payload.bytes().length() <= SHORT_PAYLOAD ? SHORT_PARITY_BITS : PARITY_BITS;
            default -> 0;
        };
    }

    /** Without the trailer. */
    int wholeBits() {
        int length = payload.bytes().length();
        return isOfModule() ? Airtime.moduleBits(length) : Airtime.bits(length);
    }

    boolean mayHaveTrailer() {
        return hops() == 0 && OF_ONE_MESSAGE.contains(payload.kind().toString());
    }

    /** Whether a reset or the trace's end may have taken its last bits. */
    boolean isCut() {
        return event.has("cut");
    }

    @Override
    public String toString() {
        String kind = payload.kind().toString();
        return (hops() == 0 ? payload.isAcknowledgement() ? "an " : "a " : "a copy of a ") + kind + " of "
                + payload.origin();
    }
}
