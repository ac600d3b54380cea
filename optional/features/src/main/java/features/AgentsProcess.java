package features;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javino.link.Time;
import lockstep.AgentProgram.Agents;
import lockstep.RunningEmulator;

/** Agents in a Java virtual machine of their own ({@link RealAgents}), as the state of their platforms is static. */
final class AgentsProcess implements AutoCloseable {

    private static final long LONGEST_SECONDS = 120;
    private static final String ENDED = "ended";
    private static final Pattern PRINTED = Pattern.compile("\\[(\\w+)\\] (.*)");
    private static final String LOG = """
            handlers = java.util.logging.ConsoleHandler
            java.util.logging.ConsoleHandler.filter = diffuser.StartFailures
            java.util.logging.ConsoleHandler.formatter = jason.runtime.MASConsoleLogFormatter
            """;

    private final Process process;
    private final Consumer<Object[]> told;
    private final ObjectOutputStream questions;
    private final BlockingQueue<Object[]> answers = new LinkedBlockingQueue<>();
    private volatile String lastLine = "the agents have ended";
    private volatile boolean closing;

    /**
     * Starts the agents.
     *
     * @param program a {@code .mas2j}, or a {@code .jcm} of JaCaMo.
     * @param folder  takes what they print: {@code agents.log}.
     * @param told    takes what is told of them, in the words of {@link RealAgents}, on other threads.
     * @throws IOException why they cannot start, in one line.
     */
    AgentsProcess(Path program, Path folder, Consumer<Object[]> told) throws IOException {
        this.told = told;
        List<String> command = new ArrayList<>(List.of(System.getProperty("java.home") + "/bin/java"));
        command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), RealAgents.class.getName(),
                program.toString().endsWith(".jcm") ? "jacamo.infra.JaCaMoLauncher" : "jason.infra.local.RunLocalMAS",
                program.toString(), "--no-net", "--log-conf",
                Files.writeString(folder.resolve("logging.properties"), LOG + RunningEmulator.logging(folder))
                        .toString()));
        process = new ProcessBuilder(command).start();
        questions = new ObjectOutputStream(process.getOutputStream());
        questions.flush();
        Thread lines = Time.REAL.thread("agents", () -> readLines(folder.resolve("agents.log")));
        lines.start();
        Time.REAL.thread("agents", () -> read(lines)).start();
        try {
            next();
        } catch (AssertionError failed) {
            close();
            throw new IOException(failed.getMessage(), failed);
        }
    }

    private void readLines(Path log) {
        try (PrintWriter all = new PrintWriter(Files.newBufferedWriter(log))) {
            process.errorReader(StandardCharsets.UTF_8).lines().filter(line -> !line.isBlank()).forEach(line -> {
                all.println(line);
                lastLine = line;
                Matcher printed = PRINTED.matcher(line);
                if (printed.matches()) {
                    told.accept(new Object[] {"printed", printed.group(1), printed.group(2)});
                }
            });
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void read(Thread lines) {
        try (ObjectInputStream in = new ObjectInputStream(process.getInputStream())) {
            while (true) {
                Object[] message = (Object[]) in.readObject();
                if (message[0].equals(RealAgents.ANSWER)) {
                    answers.add(message);
                } else {
                    told.accept(message);
                }
            }
        } catch (IOException | ClassNotFoundException ended) {
            try {
                lines.join();
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
            }
            Object[] message = {ENDED, lastLine};
            answers.add(message);
            if (!closing) {
                told.accept(message);
            }
        }
    }

    private Object next() {
        try {
            Object[] next = answers.poll(LONGEST_SECONDS, TimeUnit.SECONDS);
            if (next == null || next[0].equals(ENDED)) {
                throw new AssertionError(next == null ? "the agents do not answer" : next[1]);
            }
            return next[1];
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new AssertionError("the test was interrupted", interrupted);
        }
    }

    /** The agents; each method asks them, and waits for the answer. */
    Agents agents() {
        return (Agents) Proxy.newProxyInstance(Agents.class.getClassLoader(), new Class<?>[] {Agents.class},
                (proxy, method, words) -> {
                    Object answer = ask(RealAgents.message(method.getName(), words));
                    if (method.getReturnType() == CompletableFuture.class) {
                        return answer instanceof Throwable failed ? CompletableFuture.failedFuture(failed)
                                : CompletableFuture.completedFuture(answer);
                    } else if (answer instanceof Throwable failed) {
                        throw failed;
                    }
                    return answer;
                });
    }

    private Object ask(Object[] question) {
        try {
            questions.writeObject(question);
            questions.flush();
        } catch (IOException ended) {
            // So does its output, which says why.
        }
        return next();
    }

    @Override
    public void close() {
        closing = true;
        process.toHandle().destroy();
        Time.REAL.join(process.onExit());
    }
}
