package campaign;

import harness.MovingAgents;
import harness.WalkerLog;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Random;
import java.util.TreeMap;
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
    private static final double UNPLUGGED_SECONDS = 0.5;
    private static final int KINDS = 5;

    private final Field field;
    private final int cell;
    private final EmulatedTime time;
    private final Random random;
    /** To be done once the event is over because of which they are. */
    private final Queue<Act> acts = new ArrayDeque<>();
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

    MovePair(Field field, int cell, EmulatedTime time, Random random) {
        this.field = field;
        this.cell = cell;
        this.time = time;
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
    void disturb() {
        disturbed = true;
    }

    /** No more faults from now on; what was broken works again when this returns. */
    void calm() throws InterruptedException {
        disturbed = false;
        act();
        time.pause(UNPLUGGED_SECONDS);
    }

    /** Takes notice of an event, while nothing can be done about it. */
    void see(TraceEvent event) {
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
                acts.add(() -> field.emulator()
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
        acts.add(() -> {
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
                    time.at(time.now() + UNPLUGGED_SECONDS, () -> {
                        field.emulator().command(Map.of("do", "plug", "board", board));
                        busy = false;
                    });
                }
            }
            busy = kind > 3;
        });
    }

    private interface Act {
        void run() throws IOException, InterruptedException;
    }

    /** Whether there is something to do. */
    boolean hasActs() {
        return !acts.isEmpty();
    }

    /** Does what events have led to, on the thread that started the emulator. */
    void act() throws InterruptedException {
        for (Act act = acts.poll(); act != null; act = acts.poll()) {
            try {
                act.run();
            } catch (IOException | UncheckedIOException failed) {
                System.err.println("campaign: moves: a fault failed: " + failed.getMessage());
                failures++;
                busy = false;
            }
        }
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

    Map<String, int[]> faults() {
        return new TreeMap<>(faults);
    }

    long replayed() {
        return replayed;
    }

    long failures() {
        return failures;
    }

    @Override
    public void close() {
        if (travels != null) {
            travels.close();
        }
    }
}
