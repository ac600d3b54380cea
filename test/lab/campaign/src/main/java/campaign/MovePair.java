package campaign;

import harness.MovingAgents;
import harness.WalkerLog;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import trace.TraceEvent;

/** Two MAS between which an agent moves, and the faults that befall them, at steps that a seed chooses. */
final class MovePair implements AutoCloseable {

    /** Between two faults: so many events, at least and at most. */
    private static final int LEAST = 10;
    private static final int MOST = 80;
    private static final int REPLAY_EACH = 10;
    private static final int KEPT_PACKETS = 200;
    private static final double CUT_SECONDS = 0.3;
    private static final long UNPLUGGED_MILLIS = 500;
    private static final int KINDS = 5;

    private final Field field;
    private final int cell;
    private final Random random;
    private final ExecutorService performer = Executors.newSingleThreadExecutor();
    private final List<String> packets = new ArrayList<>();
    /** The faults that came behind each step, by kind. */
    private final Map<String, int[]> faults = new TreeMap<>();
    private MovingAgents travels;
    private boolean disturbed;
    private boolean busy;
    private boolean lost;
    private int next;
    private String said = "nothing yet";
    private long replayed;
    private long failures;

    MovePair(Field field, int cell, Random random) {
        this.field = field;
        this.cell = cell;
        this.random = random;
        next = LEAST + random.nextInt(MOST - LEAST);
    }

    /** Starts both MAS, and waits until the agent is awake. */
    void start(String walker) throws IOException, InterruptedException {
        List<Field.Post> posts = field.cell(cell);
        travels = new MovingAgents(field.emulator(), field.folder().resolve("pair" + cell),
                posts.stream().map(Field.Post::name).toList(), posts.stream().map(Field.Post::address).toList(),
                List.of(true, true), walker, line -> {});
        travels.start(MovingAgents.AWAY);
        travels.start(MovingAgents.HOME);
        travels.awaitTicks(1);
    }

    /** Has faults come from now on. */
    synchronized void disturb() {
        disturbed = true;
    }

    /** No more faults from now on; what was broken works again when this returns. */
    void calm() throws InterruptedException {
        synchronized (this) {
            disturbed = false;
        }
        performer.shutdown();
        if (!performer.awaitTermination(1, TimeUnit.MINUTES)) {
            throw new AssertionError("a fault did not end");
        }
    }

    /** Takes notice of an event, on the thread that reads the trace. */
    synchronized void see(TraceEvent event) {
        if (!disturbed || field.cell(cell).stream().noneMatch(post -> post.name().equals(event.board()))) {
            return;
        }
        String type = MovingAgents.said(event);
        if (!type.isEmpty()) {
            said = type;
        }
        if (event.name().equals("rf-tx")) {
            packets.add(event.text("payload"));
            if (packets.size() > KEPT_PACKETS) {
                packets.remove(0);
            }
            if (random.nextInt(REPLAY_EACH) == 0) {
                replayed++;
                String packet = packets.get(random.nextInt(packets.size()));
                perform(() -> field.emulator()
                        .command(Map.of("do", "send", "position", Field.position(cell), "payload", packet)));
            }
        }
        boolean step = event.name().equals("rf-tx") || event.name().equals("rf-rx") || !type.isEmpty();
        if (step && !busy && --next <= 0) {
            next = LEAST + random.nextInt(MOST - LEAST);
            befall(random.nextInt(KINDS), random.nextInt(2));
        }
    }

    private void befall(int kind, int side) {
        busy = true;
        int column = kind;
        if (kind < 2) {
            int here =
                    travels.walk().ticks().stream().reduce((first, last) -> last).map(WalkerLog.Tick::side).orElse(0);
            column = side == here ? 0 : 1;
        }
        faults.computeIfAbsent(said, step -> new int[KINDS])[column]++;
        String board = field.cell(cell).get(side).name();
        perform(() -> {
            switch (kind) {
                case 0, 1 -> {
                    travels.kill(side);
                    travels.start(side);
                }
                case 2 -> field.emulator().command(Map.of("do", "reset", "board", board));
                case 3 -> field.emulator()
                        .command(Map.of("do", "power-cut", "board", board, "duration", CUT_SECONDS));
                default -> {
                    field.emulator().command(Map.of("do", "unplug", "board", board));
                    Thread.sleep(UNPLUGGED_MILLIS);
                    field.emulator().command(Map.of("do", "plug", "board", board));
                }
            }
            synchronized (this) {
                busy = false;
            }
        });
    }

    private interface Act {
        void run() throws IOException, InterruptedException;
    }

    private void perform(Act act) {
        performer.execute(() -> {
            try {
                act.run();
            } catch (IOException | UncheckedIOException | AssertionError failed) {
                System.err.println("campaign: moves: a fault failed: " + failed.getMessage());
                synchronized (this) {
                    failures++;
                    busy = false;
                }
            } catch (InterruptedException closed) {
                Thread.currentThread().interrupt();
            }
        });
    }

    /** Waits until the agent has shown so often that it is awake; else it is lost. */
    void awaitTicks(int more) throws InterruptedException {
        try {
            travels.awaitTicks(more);
        } catch (AssertionError nothing) {
            lost = true;
        }
    }

    boolean isLost() {
        return lost;
    }

    /** How many lines with these words the MAS have printed. */
    long lines(String words) {
        return travels.lines().stream().filter(line -> line.contains(words)).count();
    }

    WalkerLog.Verdict verdict() {
        return travels.walk().verdict();
    }

    /** Arrivals at which the agent did not find what it had taken with it. */
    long wrongMarks() {
        return travels.lines().stream().filter(line -> line.contains("] arrived "))
                .filter(line -> !line.matches(".*arrived \\w+ mark\\(\\d+,\"B\\d+\"\\) kept a b c")).count();
    }

    /** Lines that nobody expects. */
    List<String> complaints() {
        WalkerLog.Verdict verdict = verdict();
        return Stream.of(Stream.concat(verdict.twice().stream(), verdict.changed().stream()).map(Object::toString),
                travels.lines().stream().filter(line -> line.contains("Exception") || line.contains("has failed")))
                .flatMap(lines -> lines).map(line -> "pair " + cell + ": " + line).toList();
    }

    synchronized Map<String, int[]> faults() {
        return new TreeMap<>(faults);
    }

    synchronized long replayed() {
        return replayed;
    }

    synchronized long failures() {
        return failures;
    }

    @Override
    public void close() {
        performer.shutdownNow();
        if (travels != null) {
            travels.close();
        }
    }
}
