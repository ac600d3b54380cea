package fuzz;

import java.util.Arrays;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Envelope;
import javino.protocol.Frame;
import javino.protocol.Key;
import javino.protocol.Nonce;
import javino.protocol.ProtocolError;
import javino.protocol.ProtocolException;

/**
 * Any frame is refused; a sealed one opens, and is refused where anything of it was changed: two bytes say where and
 * how, the rest is the content.
 */
public final class EnvelopeTarget {

    private static final int MAX_CONTENT = Frame.MAX_MESSAGE_LENGTH - Envelope.OVERHEAD;
    /** Of no vector, so that no frame of the corpus was sealed with it. */
    private static final Key KEY = Key.ofHex("8f2e07b1c45d6a3990fe1823ab7c56d0");
    private static final Address POLICE = Address.parse("SUPO");
    private static final Address GROUP = Address.parse("//SU");
    private static final Nonce NONCE = new Nonce(7, 9);

    private EnvelopeTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) throws ProtocolException {
        refuse(data);
        if (data.length >= 3 && data.length - 3 <= MAX_CONTENT) {
            Bytes content = Bytes.copyOf(Arrays.copyOfRange(data, 3, data.length));
            Frame sealed = Envelope.seal(KEY, POLICE, GROUP, NONCE, content);
            Holds.equal(content, Envelope.open(KEY, sealed).content(), "content");
            byte[] changed = sealed.encode().toArray();
            int at = ((data[0] & 0xFF) << 8 | data[1] & 0xFF) % changed.length;
            if (data[2] != 0) {
                changed[at] ^= data[2];
                refuse(changed);
            }
        }
    }

    private static void refuse(byte[] bytes) {
        try {
            Envelope.open(KEY, Frame.decode(Bytes.copyOf(bytes)));
        } catch (ProtocolException e) {
            Holds.always(e.error() != ProtocolError.BAD_TEXT, "an envelope holds no text");
            return;
        }
        throw new AssertionError("opened " + Bytes.copyOf(bytes));
    }
}
