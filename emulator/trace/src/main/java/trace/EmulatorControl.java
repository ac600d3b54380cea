package trace;

import com.google.gson.Gson;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;

/** The emulator's control socket (emulator/README.md). */
public final class EmulatorControl {

    private EmulatorControl() {}

    /**
     * Gives a command, and waits until it has taken effect.
     *
     * @throws IOException if nobody is there, or it is refused.
     */
    public static void perform(Path socket, Map<String, ?> command) throws IOException {
        try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket))) {
            channel.write(ByteBuffer.wrap((new Gson().toJson(command) + "\n").getBytes(StandardCharsets.UTF_8)));
            String answer = new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8)).readLine();
            if (!"{\"ok\":true}".equals(answer)) {
                throw new IOException(command + ": " + answer);
            }
        }
    }
}
