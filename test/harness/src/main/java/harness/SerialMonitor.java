package harness;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import javino.link.Link;
import javino.link.LinkException;

/** A serial monitor, as the Arduino IDE has one: lines of text to and from a board. */
public final class SerialMonitor implements AutoCloseable {

    private static final Duration PATIENCE = Duration.ofSeconds(240);

    private final Link link;

    private SerialMonitor(Link link) {
        this.link = link;
    }

    public static SerialMonitor of(Emulator emulator, String board) throws LinkException {
        return new SerialMonitor(Host.link(emulator.port(board)).open());
    }

    public void type(String text) throws LinkException {
        link.write(text.getBytes(StandardCharsets.UTF_8));
    }

    /** The next line that the board prints, without its end. */
    public String line() throws LinkException {
        ByteArrayOutputStream line = new ByteArrayOutputStream();
        byte[] next = new byte[1];
        while (link.read(next, PATIENCE) == 1) {
            if (next[0] == '\n') {
                return line.toString(StandardCharsets.UTF_8).stripTrailing();
            }
            line.write(next[0]);
        }
        throw new AssertionError("the board prints no line; so far: " + line.toString(StandardCharsets.UTF_8));
    }

    @Override
    public void close() {
        link.close();
    }
}
