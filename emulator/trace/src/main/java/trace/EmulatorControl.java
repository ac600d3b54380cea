package trace;

import com.google.gson.Gson;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;

/** Takes commands for an emulator, in the words of emulator/README.md. */
public interface EmulatorControl {

    /**
     * Gives a command, and waits until it has taken effect.
     *
     * @throws IOException if nobody is there, or it is refused.
     */
    void perform(Map<String, ?> command) throws IOException;

    /** A command's text. The trace repeats it: in an order that is the same in each virtual machine. */
    static String json(Map<String, ?> command) {
        return new Gson().toJson(new TreeMap<>(command));
    }

    /** By an emulator's control socket. */
    static EmulatorControl at(Path socket) {
        return command -> {
            try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket))) {
                channel.write(StandardCharsets.UTF_8.encode(json(command) + "\n"));
                String answer = new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8)).readLine();
                if (!"{\"ok\":true}".equals(answer)) {
                    throw new IOException(command + ": " + answer);
                }
            }
        };
    }
}
