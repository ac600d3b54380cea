package fuzz;

import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.ProtocolException;

/** A frame that can be read is written as it was. */
public final class FrameTarget {

    private FrameTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) {
        Bytes bytes = Bytes.copyOf(data);
        try {
            Holds.equal(bytes, Frame.decode(bytes).encode(), "frame");
        } catch (ProtocolException e) {
            Holds.always(e.error() != null, "a refusal says why");
        }
    }
}
