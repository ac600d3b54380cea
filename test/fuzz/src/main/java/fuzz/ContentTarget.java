package fuzz;

import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.ProtocolException;

/** A content that can be read is written as it was. */
public final class ContentTarget {

    private ContentTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) {
        Bytes bytes = Bytes.copyOf(data);
        try {
            Holds.equal(bytes, Content.decode(bytes).encode(), "content");
        } catch (ProtocolException e) {
            Holds.always(e.error() != null, "a refusal says why");
        }
    }
}
