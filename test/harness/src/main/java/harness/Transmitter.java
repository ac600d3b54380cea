package harness;

import java.time.Duration;
import javino.link.Link;
import javino.link.LinkException;
import javino.vectors.RadioVectors;

/** The board with the sketch {@code Transmitter}, which sends any bytes as a packet. */
public final class Transmitter implements AutoCloseable {

    private static final int SENT = 'k';

    private final Link link;

    private Transmitter(Link link) {
        this.link = link;
    }

    public static Transmitter of(Emulator emulator, String board) throws LinkException {
        return emulator.closing(new Transmitter(Host.link(emulator.port(board)).open()), Transmitter::close);
    }

    /** Sends a payload with the right count and CRC, and waits until it has been on the air. */
    public void send(byte[] payload) throws LinkException {
        sendPacket(RadioVectors.packet(payload));
    }

    /** Sends a packet's bytes as they are, and waits until they have been on the air. */
    public void sendPacket(byte[] packet) throws LinkException {
        sendPacket(packet, new byte[0]);
    }

    /** Sends a packet's bytes and a trailer's (SPEC 6.1) as they are, and waits until they have been on the air. */
    public void sendPacket(byte[] packet, byte[] trailer) throws LinkException {
        byte[] request = new byte[2 + packet.length + trailer.length];
        request[0] = (byte) packet.length;
        request[1] = (byte) trailer.length;
        System.arraycopy(packet, 0, request, 2, packet.length);
        System.arraycopy(trailer, 0, request, 2 + packet.length, trailer.length);
        link.write(request);
        byte[] answer = new byte[1];
        if (link.read(answer, Duration.ofSeconds(240)) != 1 || answer[0] != SENT) {
            throw new AssertionError("the transmitter is silent");
        }
    }

    @Override
    public void close() {
        link.close();
    }
}
