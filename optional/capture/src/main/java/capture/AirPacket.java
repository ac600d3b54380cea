package capture;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import javino.Printable;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.Payload;
import javino.protocol.ProtocolException;
import javino.protocol.HostMessage;
import trace.TraceEvent;

/**
 * A packet on the air, as one board sent it or as it came to that board.
 *
 * @param micros  when its CRC was there, in microseconds.
 * @param board   the board's name.
 * @param sent    whether the board sent it.
 * @param how     it came; intact where it was sent.
 * @param trailer the part that followed it.
 * @param path    its hops, and the distance that it tells (SPEC 6); {@link #UNKNOWN_PATH} where it is not known.
 * @param reason  why it is damaged; empty where that is not known, or it is not.
 * @param payload 0…77 bytes: a {@link Frame} as a rule.
 */
record AirPacket(long micros, String board, boolean sent, How how, Trailer trailer, int path, String reason,
        Bytes payload) {

    /** A board that overhears does not tell it. */
    static final int UNKNOWN_PATH = 255;

    private static final int VERSION = 1;
    private static final int MOST_BYTES_OF_A_TEXT = 255;
    private static final double MICROS_A_SECOND = 1e6;

    /** How a packet came, in the order of the numbers of SPEC 10.1. */
    enum How {
        /** As it was sent. */
        INTACT,
        /** Damaged, and the board has mended it. */
        MENDED,
        /** Damaged beyond mending: the payload may be wrong anywhere. */
        DAMAGED,
        /** It did not come undamaged; the payload is the one that was sent. */
        AS_SENT
    }

    /** The part that follows a packet on the air: SPEC 6.1. */
    enum Trailer {
        NONE(0), MARK(1), PARITY(2), UNKNOWN(255);

        private final int number;

        Trailer(int number) {
            this.number = number;
        }
    }

    /** The bytes that stand for it in a file: SPEC 10.1. They have neither count nor CRC, which no source tells. */
    Bytes record() {
        return Bytes.join(Bytes.of(VERSION, sent ? 0 : 1, how.ordinal(), trailer.number, path, 0),
                counted(board), counted(reason), payload);
    }

    /** A text behind its length. */
    private static Bytes counted(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        int length = Math.min(bytes.length, MOST_BYTES_OF_A_TEXT);
        return Bytes.join(Bytes.of(length), Bytes.copyOf(Arrays.copyOf(bytes, length)));
    }

    /** It in a line for people. @param start when the capture began, in microseconds. */
    String line(long start) {
        String came = sent ? "sent" : how == How.AS_SENT ? "damaged" : how.toString().toLowerCase(Locale.ROOT);
        String why = reason.isEmpty() ? "" : " (" + reason + ")";
        return Printable.of(String.format(Locale.ROOT, "%12.6f s  %-10s  %-8s %s%s%s",
                (micros - start) / MICROS_A_SECOND, board, came, described(), told(), why));
    }

    private String told() {
        if (path == UNKNOWN_PATH) {
            return "";
        }
        return (path % TraceEvent.HOPS == 0 ? "" : ", hops " + path % TraceEvent.HOPS)
                + (path < TraceEvent.HOPS ? "" : ", distance " + (path / TraceEvent.HOPS - 1));
    }

    private String described() {
        Frame frame;
        try {
            frame = Frame.decode(payload);
        } catch (ProtocolException e) {
            return payload.length() + " bytes that are no frame: " + e.error();
        }
        Address.Kind kind = frame.destination().kind();
        return frame.origin() + " -> " + frame.destination() + "  " + kind.toString().toLowerCase(Locale.ROOT) + "  "
                + switch (kind) {
                    case BROADCAST -> HostMessage.isHostMessage(frame.message())
                            ? "host message, " + frame.message().length() + " bytes"
                            : new String(frame.message().toArray(), StandardCharsets.UTF_8);
                    case FRAGMENT -> fragment(frame.destination());
                    case DEVICE, MULTICAST -> "sealed, "
                            + (frame.message().length() - Payload.NONCE_LENGTH - Payload.TAG_LENGTH) + " bytes";
                    default -> frame.message().length() + " bytes";
                };
    }

    private String fragment(Address to) {
        Payload fragment = Payload.of(payload);
        return fragment.index() + " of " + to.member().charAt(0) + (fragment.asks() ? ", asks" : "");
    }
}
