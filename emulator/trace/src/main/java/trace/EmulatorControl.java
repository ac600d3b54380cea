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

/** Takes commands for an emulator, in the words of emulator/README.md. */
public interface EmulatorControl {

    /**
     * Gives a command, and waits until it has taken effect.
     *
     * @throws IOException if nobody is there, or it is refused.
     */
    void perform(Map<String, ?> command) throws IOException;

    /** By an emulator's control socket. */
    static EmulatorControl at(Path socket) {
        return command -> {
            try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket))) {
                channel.write(ByteBuffer.wrap((new Gson().toJson(command) + "\n").getBytes(StandardCharsets.UTF_8)));
                String answer = new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8)).readLine();
                if (!"{\"ok\":true}".equals(answer)) {
                    throw new IOException(command + ": " + answer);
                }
            }
        };
    }
}
