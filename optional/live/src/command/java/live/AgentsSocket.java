package live;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import javino.JavinoException;
import javino.link.Time;

/**
 * The socket at which agents' programs ({@code live.ObservedMas}) tell of their agents, and take what the page has them
 * do. It is open to its user only.
 */
final class AgentsSocket implements AutoCloseable {

    /** What agents take, by the name in {@code do}. */
    static final List<String> CONTROLS = List.of("goal", "act", "say");
    private static final int SECONDS_TO_ANSWER = 20;

    private final Path socket;
    private final ServerSocketChannel server;
    private final Consumer<JsonObject> events;
    private final Map<String, LineChannel> programs = new ConcurrentHashMap<>();
    private final Map<String, String> boards = new ConcurrentHashMap<>();
    private final Map<Long, CompletableFuture<String>> answers = new ConcurrentHashMap<>();
    private final AtomicLong asked = new AtomicLong();
    private final Set<LineChannel> connected = ConcurrentHashMap.newKeySet();
    private boolean records;

    private AgentsSocket(Path socket, ServerSocketChannel server, Consumer<JsonObject> events) {
        this.socket = socket;
        this.server = server;
        this.events = events;
    }

    /**
     * Begins to listen; an earlier socket of this name is replaced.
     *
     * @param records whether agents are to tell what they decide, too.
     * @param events  takes each event, which names its agent, if it is one agent's, and its board, if that is known.
     */
    static AgentsSocket listen(Path socket, boolean records, Consumer<JsonObject> events) throws IOException {
        Files.deleteIfExists(socket);
        ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
        server.bind(UnixDomainSocketAddress.of(socket));
        if (socket.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            Files.setPosixFilePermissions(socket, PosixFilePermissions.fromString("rw-------"));
        }
        AgentsSocket agents = new AgentsSocket(socket, server, events);
        agents.records = records;
        Time.REAL.thread("agents", agents::accept).start();
        return agents;
    }

    private void accept() {
        try {
            while (true) {
                SocketChannel program = server.accept();
                Time.REAL.thread("agents' events", () -> read(new LineChannel(program))).start();
            }
        } catch (IOException closed) {
            return;
        }
    }

    /** Says whether agents are to tell what they decide, from now on. @param before what is done if they did not. */
    synchronized void record(boolean on, Runnable before) {
        if (on != records) {
            before.run();
            records = on;
            for (LineChannel program : connected) {
                try {
                    program.send(wish());
                } catch (IOException ended) {
                    connected.remove(program);
                }
            }
        }
    }

    private String wish() {
        return Events.json("do", "record", "on", records);
    }

    private synchronized void greet(LineChannel program) throws IOException {
        connected.add(program);
        program.send(wish());
    }

    private void read(LineChannel program) {
        try (program) {
            greet(program);
            for (String line = program.next(); line != null; line = program.next()) {
                take(program, Events.object(line));
            }
        } catch (IOException | JavinoException ended) {
            // So have its agents, which is told below.
        }
        connected.remove(program);
        programs.entrySet().removeIf(each -> {
            if (each.getValue() == program) {
                events.accept(ended(each.getKey()));
            }
            return each.getValue() == program;
        });
    }

    private static JsonObject ended(String agent) {
        JsonObject event = new JsonObject();
        event.addProperty("event", "agent");
        event.addProperty("agent", agent);
        event.addProperty("ended", true);
        return event;
    }

    private void take(LineChannel program, JsonObject event) {
        if (event.has("answer")) {
            CompletableFuture<String> answer = answers.remove(event.get("answer").getAsLong());
            if (answer != null) {
                answer.complete(event.has("error") ? event.get("error").getAsString() : "");
            }
            return;
        }
        if (event.has("agent")) {
            String agent = event.get("agent").getAsString();
            if (event.has("ended")) {
                programs.remove(agent, program);
            } else {
                programs.put(agent, program);
            }
            if (event.has("port")) {
                boards.compute(agent, (of, before) -> board(event.get("port").getAsString()));
            }
            if (boards.containsKey(agent)) {
                event.addProperty("board", boards.get(agent));
            }
        }
        events.accept(event);
    }

    /** A board without a trace has its port's name; null without a port. */
    private static String board(String port) {
        String name = port.substring(Math.max(port.lastIndexOf('/'), port.lastIndexOf('\\')) + 1);
        return name.isEmpty() ? null : name;
    }

    /**
     * Has an agent do something, and waits for its answer.
     *
     * @throws JavinoException if it does not; the message says why.
     */
    void perform(JsonObject command) throws JavinoException {
        LineChannel program = command.has("agent") ? programs.get(command.get("agent").getAsString()) : null;
        if (program == null) {
            throw new JavinoException(command.get("do").getAsString() + " needs an agent that is there: one of "
                    + String.join(", ", programs.keySet()));
        }
        long id = asked.incrementAndGet();
        CompletableFuture<String> answer = new CompletableFuture<>();
        answers.put(id, answer);
        command.addProperty("id", id);
        try {
            program.send(command.toString());
            String error = answer.get(SECONDS_TO_ANSWER, TimeUnit.SECONDS);
            if (!error.isEmpty()) {
                throw new JavinoException(error);
            }
        } catch (IOException | ExecutionException e) {
            throw new JavinoException("the agent cannot be reached: does it still run?", e);
        } catch (TimeoutException e) {
            throw new JavinoException("the agent did not answer within " + SECONDS_TO_ANSWER + " s", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new JavinoException("the page's server is ending", e);
        } finally {
            answers.remove(id);
        }
    }

    @Override
    public void close() {
        try {
            server.close();
            Files.deleteIfExists(socket);
        } catch (IOException e) {
            // What is left of it is replaced at the next start.
            return;
        }
    }
}
