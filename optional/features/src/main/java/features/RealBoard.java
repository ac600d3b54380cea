package features;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.opentest4j.TestAbortedException;

/** A real board, and a person at the terminal who does what the emulator would. */
final class RealBoard extends RealTimeEngine {

    /** The steps of all scenarios that nobody could do or see. */
    static final List<String> UNCHECKED = new ArrayList<>();

    private final Account account;
    private final Supplier<String> step;
    private final Path link;

    /**
     * Puts the board's port where the agents look for it.
     *
     * @param device the port, as {@code /dev/ttyACM0}.
     * @param link   what becomes a symbolic link to it.
     * @param step   tells the text of the step that is played.
     */
    RealBoard(Path device, Path link, Path folder, Account account, Supplier<String> step) throws IOException {
        super(folder, account);
        this.account = account;
        this.step = step;
        this.link = link;
        if (!Files.exists(device)) {
            throw new NoSuchFileException(device.toString());
        }
        Files.createDirectories(folder);
        Files.createDirectories(link.toAbsolutePath().getParent());
        if (Files.isSymbolicLink(link)) {
            Files.delete(link);
        }
        Files.createSymbolicLink(link, device.toAbsolutePath());
    }

    /** Ends the scenario, as nobody can do what this step says. */
    static TestAbortedException unchecked(String step) {
        UNCHECKED.add(step);
        return new TestAbortedException(step);
    }

    @Override
    public long after(long nanos, Runnable action) {
        return nanos();
    }

    /** Has the person do what the step says, which takes time. */
    @Override
    public void command(Map<String, Object> command) throws IOException {
        System.out
                .println(step.get() + "\n  make that so at the board, then press Enter; if it cannot be, n and Enter");
        StringBuilder answer = new StringBuilder();
        int next = System.in.read();
        while (next >= 0 && next != '\n') {
            answer.append((char) next);
            next = System.in.read();
        }
        if (next < 0 || !answer.toString().isBlank()) {
            throw unchecked(step.get());
        }
        account.done();
    }

    @Override
    public void close() {
        super.close();
        try {
            Files.deleteIfExists(link);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
