package fuzz;

import javino.protocol.Bytes;
import javino.protocol.ProtocolException;
import javino.protocol.RadioPacket;

/**
 * Bits of the air, each a byte's lowest, or after a first byte of 0xFF those of a packet with that payload: what can be
 * read is what was sent.
 */
public final class RadioPacketTarget {

    private RadioPacketTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) {
        Bytes bytes = Bytes.copyOf(data);
        if (data.length > 1 && data.length <= 1 + RadioPacket.MAX_PAYLOAD_LENGTH && data[0] == -1) {
            checkRoundTrip(bytes.from(1));
        } else {
            checkBits(bytes);
        }
    }

    private static void checkRoundTrip(Bytes payload) {
        try {
            Holds.equal(payload, RadioPacket.decode(RadioPacket.encode(payload)), "payload");
        } catch (ProtocolException e) {
            throw new AssertionError("refused its own packet", e);
        }
    }

    private static void checkBits(Bytes bytes) {
        StringBuilder bits = new StringBuilder();
        for (int i = 0; i < bytes.length(); i++) {
            bits.append(bytes.at(i) & 1);
        }
        try {
            Bytes payload = RadioPacket.decode(bits.toString());
            Holds.always(bits.toString().startsWith(RadioPacket.encode(payload)), "the bits are the payload's");
        } catch (ProtocolException e) {
            Holds.always(e.error() != null, "a refusal says why");
        }
    }
}
