package live;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javino.JavinoException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import trace.TraceEvent;

/** A server for a source that takes note of commands, and browsers that send any bytes. */
abstract class ServerFixture {

    final Hub hub = new Hub();
    final List<JsonObject> commands = new ArrayList<>();
    final List<TraceEvent> log = new ArrayList<>();
    Server server;

    private final class Noting implements Source {
        @Override
        public String kind() {
            return "run";
        }

        @Override
        public boolean isLive() {
            return true;
        }

        @Override
        public List<String> controls() {
            return List.of("reset", "plug");
        }

        @Override
        public void command(JsonObject command) throws JavinoException {
            if (command.has("board")) {
                commands.add(command);
            } else {
                throw new JavinoException("which board?");
            }
        }

        @Override
        public Optional<Log> log() {
            return log.isEmpty() ? Optional.empty() : Optional.of(() -> log);
        }

        @Override
        public void close() {
            // Nothing is open.
        }
    }

    @BeforeEach
    final void start() throws JavinoException {
        server = Server.start(hub, new Noting(), 0);
    }

    @AfterEach
    final void stop() {
        server.close();
    }

    final String token() {
        return server.address().replaceFirst(".*token=", "");
    }

    final String host() {
        return server.address().replaceFirst("http://", "").replaceFirst("/.*", "");
    }

    final int port() {
        return Integer.parseInt(host().replaceFirst(".*:", ""));
    }

    /** An open connection that has sent a request. */
    final Socket connect(String request, String... headers) throws IOException {
        Socket socket = new Socket("127.0.0.1", port());
        String head = request + " HTTP/1.1\r\n" + String.join("\r\n", headers) + "\r\n\r\n";
        socket.getOutputStream().write(head.getBytes(StandardCharsets.UTF_8));
        return socket;
    }

    /** The whole answer to a request, with its head. */
    final String ask(String request, String... headers) throws IOException {
        List<String> all = new ArrayList<>(List.of(headers));
        all.add("Connection: close");
        if (all.stream().noneMatch(header -> header.startsWith("Host:"))) {
            all.add("Host: " + host());
        }
        try (Socket socket = connect(request, all.toArray(String[]::new))) {
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /** Sends a command as the page does. */
    final String command(String body, String... headers) throws IOException {
        return post("/command", body, headers);
    }

    final String post(String path, String body, String... headers) throws IOException {
        List<String> all = new ArrayList<>(List.of(headers));
        all.add("Host: " + host());
        all.add("Connection: close");
        all.add("Content-Length: " + body.length());
        try (Socket socket = connect("POST " + path, all.toArray(String[]::new))) {
            socket.getOutputStream().write(body.getBytes(StandardCharsets.UTF_8));
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
