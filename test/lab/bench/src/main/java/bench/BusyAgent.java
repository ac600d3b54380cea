package bench;

import diffuser.Diffuser;
import jason.infra.local.LocalAgArch;
import java.io.File;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.LongSupplier;
import javino.fake.FakeBoard;
import javino.link.LinkOpener;
import trace.why.RunLog;

/** How fast an agent that always has something to do goes on reasoning, with boards of different quickness. */
public final class BusyAgent implements Subject {

    private static final String PROGRAM = "!work. +!work <- !!work.";
    private static final String BELIEVING = "!start. +!start <- .wait(300); +port(on); +light(1). " + PROGRAM;
    private static final String WITH_BOARD = "!start. +!start <- .percepts(open); .port(\"memory\"). " + PROGRAM;
    private static final String COUNTING = """
            limit(1000000000000). below(N) :- limit(L) & N < L. last(0). !work(1).
            +!work(N) : below(N) & last(M) & M < N <- -+last(N); !!work(N + 1).
            """;
    private static final String CYCLES = "%.0f cycles/s";
    private static final String PLAIN_AGENT = "plain agent";
    private static final Duration WARM_UP = Duration.ofSeconds(4);
    private static final Duration WINDOW = Duration.ofMillis(500);
    private static final int WINDOWS = 4;
    private static final int ROUNDS = 4;

    /**
     * How the board behaves; plain: there is none, nor an architecture; believing: as plain, but the agent has waited
     * once, and believes as much as with a board; changing: as at once, with a new percept at each reading. Without a
     * port: counting, with beliefs, a rule and a context; loop; recorded: all that it decides is kept.
     */
    private enum Kind {
        PLAIN, BELIEVING, AT_ONCE, LATE, SILENT, CHANGING, COUNTING, COUNTING_RECORDED, LOOP, LOOP_RECORDED
    }

    /** The architecture under test with a board in memory, chosen by the process's argument. */
    public static final class MemoryDiffuser extends Diffuser {

        private static final long serialVersionUID = 1L;
        /** How often a sketch reads its sensors by default. */
        private static final Duration SAMPLE = Duration.ofMillis(20);
        private static Kind kind;

        @Override
        public void init() throws Exception {
            super.init();
            if (kind == Kind.LOOP_RECORDED || kind == Kind.COUNTING_RECORDED) {
                record(new RunLog(0)::add);
            }
        }

        @Override
        protected LinkOpener link(String port) {
            FakeBoard board = new FakeBoard("memory").perceive("light(1)");
            switch (kind) {
                case LATE -> board.line.setDelay(Duration.ofMillis(50));
                case SILENT -> board.line.setSilent(true);
                case CHANGING -> {
                    AtomicInteger light = new AtomicInteger();
                    new Timer("sensor", true).schedule(new TimerTask() {
                        @Override
                        public void run() {
                            board.perceive("light(" + light.incrementAndGet() % 1024 + ")");
                        }
                    }, 0, SAMPLE.toMillis());
                }
                default -> {
                }
            }
            return board.port;
        }
    }

    @Override
    public String name() {
        return "busy";
    }

    @Override
    public String method() {
        return """
            an agent whose only plan posts its own goal again, in a Java virtual machine of its own; reasoning cycles a
            second, the best of 4 starts and 4 half seconds each, after 4 s of warming up. We take the best, since
            results of Java's compiler differ by a third from start to start, and other work of the machine only makes
            it slower. With the Diffuser it also has a board in memory that answers at once, after 50 ms, or never, and
            that has one percept, which stays, or changes at each reading, fifty times a second. The reference is the
            same agent without the architecture. The first row is a control: no board and no architecture either, but
            the agent has once waited and holds two beliefs; what that costs is not the board's. The last two
            rows keep what the agent decides, for javino why: of an agent whose plan has a context by a rule and
            replaces a belief, and of the bare loop, the worst case: its cycle takes a quarter of a microsecond, and
            has three lines. Their seconds are those of the agent's thread on a CPU.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        Map<Kind, Double> best = new EnumMap<>(Kind.class);
        for (int round = 0; round < ROUNDS; round++) {
            for (Kind kind : Kind.values()) {
                best.merge(kind, cyclesOf(kind), Math::max);
            }
        }
        double plain = best.get(Kind.PLAIN);
        return List.of(
                Row.against("busy agent, no board, has waited once", CYCLES, best.get(Kind.BELIEVING), plain,
                        PLAIN_AGENT),
                row("at once", best.get(Kind.AT_ONCE), plain), row("after 50 ms", best.get(Kind.LATE), plain),
                row("never", best.get(Kind.SILENT), plain).claim(),
                row("at once, another percept at each reading", best.get(Kind.CHANGING), plain),
                recorded("busy agent with beliefs and a rule", best.get(Kind.COUNTING_RECORDED),
                        best.get(Kind.COUNTING)),
                recorded("busy agent", best.get(Kind.LOOP_RECORDED), best.get(Kind.LOOP)));
    }

    private static Row row(String answers, double ours, double plain) {
        return Row.against("busy agent, board answers " + answers, CYCLES, ours, plain, PLAIN_AGENT)
                .goal("≥ 0.97");
    }

    private static Row recorded(String what, double recorded, double alone) {
        return Row.against(what + ", recorded", CYCLES, recorded, alone, "not recorded").goal("≥ 0.9");
    }

    private static double cyclesOf(Kind kind) throws Exception {
        String java = System.getProperty("java.home") + File.separator + "bin" + File.separator + "java";
        List<String> lines = Command.run(java, "-Djava.awt.headless=true", "-cp", System.getProperty("java.class.path"),
                BusyAgent.class.getName(), kind);
        return Double.parseDouble(lines.get(lines.size() - 1));
    }

    /** Prints how many cycles a second an agent of the kind given does. */
    public static void main(String[] kinds) throws Exception {
        MemoryDiffuser.kind = Kind.valueOf(kinds[0]);
        LocalAgArch agent = switch (MemoryDiffuser.kind) {
            case PLAIN -> Agents.start("busy", PROGRAM);
            case BELIEVING -> Agents.start("busy", BELIEVING);
            case LOOP, LOOP_RECORDED -> Agents.start("busy", PROGRAM, MemoryDiffuser.class);
            case COUNTING, COUNTING_RECORDED -> Agents.start("busy", COUNTING, MemoryDiffuser.class);
            default -> Agents.start("busy", WITH_BOARD, MemoryDiffuser.class);
        };
        boolean alone = MemoryDiffuser.kind.compareTo(Kind.COUNTING) >= 0;
        LongSupplier clock = alone ? cpuOf("busy") : System::nanoTime;
        pass(WARM_UP, clock);
        Samples cycles = new Samples();
        for (int i = 0; i < WINDOWS; i++) {
            cycles.add(cyclesASecond(agent, clock));
        }
        System.out.println(cycles.greatest());
        System.exit(0);
    }

    /** The time that a thread has had a CPU: of an agent alone it tells more, as other work of the machine does not. */
    private static LongSupplier cpuOf(String thread) {
        long id = Thread.getAllStackTraces().keySet().stream().filter(each -> each.getName().equals(thread))
                .findFirst().orElseThrow().getId();
        return () -> ManagementFactory.getThreadMXBean().getThreadCpuTime(id);
    }

    private static void pass(Duration time, LongSupplier clock) throws InterruptedException {
        long end = clock.getAsLong() + time.toNanos();
        for (long left = time.toNanos(); left > 0; left = end - clock.getAsLong()) {
            TimeUnit.NANOSECONDS.sleep(left);
        }
    }

    private static double cyclesASecond(LocalAgArch agent, LongSupplier clock) throws InterruptedException {
        int from = agent.getCycleNumber();
        long begun = clock.getAsLong();
        pass(WINDOW, clock);
        return (agent.getCycleNumber() - from) / ((clock.getAsLong() - begun) / 1e9);
    }
}
