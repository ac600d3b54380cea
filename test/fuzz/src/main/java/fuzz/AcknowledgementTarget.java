package fuzz;

import java.util.Arrays;
import javino.protocol.Acknowledgement;
import javino.protocol.Acknowledgement.Answered;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.Key;
import javino.protocol.ProtocolError;
import javino.protocol.ProtocolException;

/**
 * Any message is refused as an answer; a true answer opens, and is refused where anything of it was changed: two bytes
 * say where and how, the rest is what it tells.
 */
public final class AcknowledgementTarget {

    private static final int PIECES_LENGTH = 1;
    private static final int STALE_LENGTH = 8;
    private static final Address HOSPITAL = Address.parse("SUHO");
    private static final Answered ANSWERED = new Answered(Key.ofHex("000102030405060708090a0b0c0d0e0f"),
            Address.parse("SUPP"), Bytes.ofHex("000007000009"));

    private AcknowledgementTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) throws ProtocolException {
        Frame genuine = new Acknowledgement.Delivered().frame(ANSWERED, HOSPITAL);
        if (data.length <= Frame.MAX_MESSAGE_LENGTH) {
            refuse(new Frame(genuine.destination(), HOSPITAL, Bytes.copyOf(data)).encode().toArray());
        }
        if (data.length >= 2) {
            Acknowledgement told = told(Bytes.copyOf(Arrays.copyOfRange(data, 2, data.length)));
            Frame frame = told.frame(ANSWERED, HOSPITAL);
            Holds.equal(told, Acknowledgement.open(ANSWERED, frame), "answer");
            byte[] changed = frame.encode().toArray();
            changed[(data[0] & 0xFF) % changed.length] ^= data[1];
            if (data[1] != 0) {
                refuse(changed);
            }
        }
    }

    private static Acknowledgement told(Bytes what) {
        return switch (what.length()) {
            case PIECES_LENGTH -> new Acknowledgement.Pieces(what.at(0));
            case STALE_LENGTH -> new Acknowledgement.Stale(what.slice(0, 6), (int) what.number(6, STALE_LENGTH));
            default -> new Acknowledgement.Delivered();
        };
    }

    private static void refuse(byte[] bytes) {
        try {
            Acknowledgement.open(ANSWERED, Frame.decode(Bytes.copyOf(bytes)));
        } catch (ProtocolException e) {
            Holds.always(e.error() != ProtocolError.BAD_TEXT, "an answer holds no text");
            return;
        }
        throw new AssertionError("opened " + Bytes.copyOf(bytes));
    }
}
