package live;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;

/** Lines of UTF-8 in both directions between two programs of one user. */
final class LineChannel implements AutoCloseable {

    private final SocketChannel channel;
    private final BufferedReader in;

    LineChannel(SocketChannel channel) {
        this.channel = channel;
        in = new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8));
    }

    /** Waits for the next line; null after the last. For one thread. */
    String next() throws IOException {
        return in.readLine();
    }

    /** Sends a line. (Java's own writer would wait while another thread reads.) */
    synchronized void send(String line) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap((line + "\n").getBytes(StandardCharsets.UTF_8));
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
