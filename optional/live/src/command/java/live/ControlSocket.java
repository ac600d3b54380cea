package live;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javino.JavinoException;
import trace.BoundedLines;

/** The emulator's control socket: for each command a connection, a line there and a line back. */
final class ControlSocket {

    private static final int SECONDS_TO_ANSWER = 5;

    private final Path socket;

    ControlSocket(Path socket) {
        this.socket = socket;
    }

    /**
     * Sends a command and waits for the answer.
     *
     * @throws JavinoException if the emulator refuses it, and why, or does not answer.
     */
    void send(JsonObject command) throws JavinoException {
        try (SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX)) {
            FutureTask<String> answer = new FutureTask<>(() -> exchange(channel, command + "\n"));
            Thread waiting = new Thread(answer, "control socket");
            waiting.setDaemon(true);
            waiting.start();
            check(answer.get(SECONDS_TO_ANSWER, TimeUnit.SECONDS));
        } catch (TimeoutException e) {
            throw new JavinoException("the emulator did not answer within " + SECONDS_TO_ANSWER + " s", e);
        } catch (ExecutionException e) {
            throw new JavinoException("the emulator cannot be reached by " + socket + ": does the run still go on?",
                    e.getCause());
        } catch (IOException e) {
            throw new JavinoException("no connection to " + socket + ": " + e.getMessage(), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new JavinoException("the page's server is ending", e);
        }
    }

    private String exchange(SocketChannel channel, String line) throws IOException {
        channel.connect(UnixDomainSocketAddress.of(socket));
        ByteBuffer bytes = ByteBuffer.wrap(line.getBytes(StandardCharsets.UTF_8));
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
        String answer = new BoundedLines(Channels.newInputStream(channel)).next();
        if (answer == null) {
            throw new IOException("the connection has ended");
        }
        return answer;
    }

    private static void check(String line) throws JavinoException {
        JsonElement error = Events.object(line).get("error");
        if (error != null) {
            throw new JavinoException(error.isJsonPrimitive() ? error.getAsString() : error.toString());
        }
    }
}
