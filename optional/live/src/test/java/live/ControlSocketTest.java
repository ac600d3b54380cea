package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import javino.JavinoException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Tag("newerJava")
@Timeout(120)
class ControlSocketTest {

    @TempDir
    private Path folder;
    private ServerSocketChannel emulator;

    @BeforeEach
    void listen() throws IOException {
        emulator = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
        emulator.bind(UnixDomainSocketAddress.of(folder.resolve("control")));
    }

    @AfterEach
    void close() throws IOException {
        emulator.close();
    }

    /** The next command; it is answered so. */
    private CompletableFuture<String> answer(String line) {
        return CompletableFuture.supplyAsync(() -> {
            try (SocketChannel channel = emulator.accept()) {
                String command = new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8)).readLine();
                channel.write(ByteBuffer.wrap(line.getBytes(StandardCharsets.UTF_8)));
                return command;
            } catch (IOException e) {
                return e.toString();
            }
        });
    }

    private void send(String command) throws JavinoException {
        new ControlSocket(folder.resolve("control")).send(JsonParser.parseString(command).getAsJsonObject());
    }

    @Test
    void command_taken_isOneLine() throws Exception {
        CompletableFuture<String> command = answer("{\"ok\":true}\n");

        send("{\"do\":\"jam\",\n\"duration\":2}");

        assertEquals("{\"do\":\"jam\",\"duration\":2}", command.get());
    }

    @Test
    void command_refused_saysWhy() {
        answer("{\"error\":\"there is no board nix\"}\n");

        assertEquals("there is no board nix",
                assertThrows(JavinoException.class, () -> send("{\"do\":\"reset\"}")).getMessage());
    }

    @Test
    void connection_endedWithoutAnswer_isSaid() {
        answer("");

        String message = assertThrows(JavinoException.class, () -> send("{\"do\":\"reset\"}")).getMessage();
        assertTrue(message.contains("does the run still go on?"), message);
    }

    @Test
    void socket_notThere_isSaid() throws IOException {
        emulator.close();

        String message = assertThrows(JavinoException.class, () -> send("{\"do\":\"reset\"}")).getMessage();
        assertTrue(message.contains("control"), message);
    }
}
