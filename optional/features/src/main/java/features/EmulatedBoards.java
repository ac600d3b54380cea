package features;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import javino.link.Time;

/** Emulated boards that go by the clock. */
final class EmulatedBoards extends RealTimeEngine {

    private static final long LONGEST = 60 * Window.SECOND;

    private final List<String> complaints = Collections.synchronizedList(new ArrayList<>());
    private final Path socket;
    private final Account account;
    private final Process emulator;
    private volatile boolean closing;
    private boolean begun;

    /**
     * Starts the boards.
     *
     * @param command the emulator with its scenario and options.
     * @param folder  takes the files of the run, among them {@code trace.jsonl}.
     * @param account is told of all.
     */
    EmulatedBoards(List<String> command, long seed, Path folder, Account account) throws IOException {
        super(folder, account);
        this.account = account;
        socket = folder.resolve("control");
        List<String> whole = new ArrayList<>(command);
        whole.addAll(List.of("--seed", "" + seed, "--trace", "-", "--control", socket.toString()));
        emulator = new ProcessBuilder(whole).start();
        Runtime.getRuntime().addShutdownHook(new Thread(emulator.toHandle()::destroy));
        CompletableFuture<Void> complained = new CompletableFuture<>();
        Time.REAL.thread("emulator", () -> {
            try {
                emulator.errorReader().lines().forEach(complaints::add);
            } finally {
                complained.complete(null);
            }
        }).start();
        PrintWriter trace = new PrintWriter(Files.newBufferedWriter(folder.resolve("trace.jsonl")));
        Time.REAL.thread("emulator", () -> {
            try (trace) {
                emulator.inputReader(StandardCharsets.UTF_8).lines().forEach(line -> {
                    trace.println(line);
                    tell(() -> traced(line));
                });
            }
            Time.REAL.join(complained);
            tell(this::ended);
        }).start();
        if (!runUntil(() -> begun, LONGEST)) {
            throw new AssertionError("the emulator does not begin");
        }
    }

    private void traced(String line) {
        begun = true;
        account.traced(line, own -> nanos());
    }

    private void ended() {
        if (!closing) {
            throw new AssertionError("the emulator has ended: " + complaints);
        }
    }

    @Override
    public void command(String json) throws IOException {
        try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket))) {
            channel.write(StandardCharsets.UTF_8.encode(json + "\n"));
            String answer = new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8)).readLine();
            if (!"{\"ok\":true}".equals(answer)) {
                throw new IOException(json + ": " + answer);
            }
        }
    }

    @Override
    public void close() {
        super.close();
        closing = true;
        emulator.toHandle().destroy();
        int status = Time.REAL.join(emulator.onExit()).exitValue();
        if (status != 0) {
            throw new AssertionError("the emulator ended with " + status + ": " + complaints);
        }
    }
}
