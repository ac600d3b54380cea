package features;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import lockstep.AgentProgram;

/**
 * The run of one scenario: its boards and agents. The first step that is not of the boards' and agents' choice
 * begins it; it has begun when no agent's start plans go on any more, and the boards' first percepts are believed.
 */
class Run implements AutoCloseable {

    /** A scenario that has not begun in this time will not. */
    private static final long LONGEST_BEGINNING = 30 * Window.SECOND;
    private static final int JACAMO_SLACK = 3;
    /** A sketch that has no percepts begins without. */
    private static final long LONGEST_WAIT_FOR_PERCEPTS = 3 * Window.SECOND;

    private static Run now;

    /** The port of a real board; null for emulated ones. */
    private final String realPort = System.getProperty("javino.port");
    private final String feature;
    final Path folder;
    private final boolean realTime;
    final Account account;
    final Expectations expected;
    final Others others = new Others(this);
    /** None before the run begins. */
    BoardFile boards;
    Engine engine;
    /** The step's text, with its place. */
    String step = "";
    final Map<String, Object> radio = new TreeMap<>();
    Path agentsFile = Path.of(System.getProperty("javino.mas", "robot.mas2j"));
    Path boardsFile = Path.of(System.getProperty("javino.boards", "board.json"));
    long seed = Long.getLong("javino.seed", 1);
    private AgentProgram.Agents agents;
    private boolean begun;
    private boolean broken;
    private String lastBoard = "";
    private String lastAgent = "";
    private long returns = -1;

    /**
     * @param feature  the scenario's file and line, as Cucumber takes them.
     * @param realTime whether it asks for the computer's time.
     * @param account  is told of all; null for one of its own.
     */
    Run(String feature, Path folder, boolean realTime, Account account) {
        this.feature = feature;
        this.folder = folder;
        this.realTime = realTime;
        this.account = account == null ? new Account(this::nanos) : account;
        expected = new Expectations(this, this.account);
    }

    /** Prepares a scenario, whose files go to a folder of its own. */
    static void prepare(String feature, Path folder, boolean realTime) {
        now = WatchedRun.scenario().orElseGet(() -> new Run(feature, folder, realTime, null));
    }

    static Optional<Run> current() {
        return Optional.ofNullable(now);
    }

    /** The run of the scenario that goes on, before or after its beginning. */
    private static Run any() {
        return current().orElseThrow(() -> new IllegalStateException("no scenario goes on"));
    }

    /** The run of the scenario, which begins if it has not begun; all that has happened is known. */
    static Run now() {
        any().begin();
        return any();
    }

    /** The run of the scenario, which has not begun. */
    static Run before() {
        any().choose();
        return any();
    }

    /** Fails if it is too late to choose what the scenario has. */
    void choose() {
        if (engine != null) {
            throw wrong("boards, agents, seed and radio are chosen before the first other step");
        }
    }

    // What the scenario has

    AgentProgram.Agents agents() {
        return agents;
    }

    /** The board that words name; {@code its} is the last one. */
    String board(String words) {
        lastBoard = words.equals("its") ? lastBoard : words.replaceFirst("'s$", "");
        return named("board", lastBoard, boards.names(), boardsFile);
    }

    /** The agent that words name; {@code it} is the last one. */
    String agent(String words) {
        lastAgent = words.equals("it") ? lastAgent : words.replaceFirst("^the agent ", "");
        check(lastAgent);
        return lastAgent;
    }

    void check(String agent) {
        named("agent", agent, agents().agents(), agentsFile);
    }

    private String named(String kind, String name, Collection<String> all, Path file) {
        if (!all.contains(name)) {
            throw wrong(name.isEmpty() ? "no " + kind + " was named before"
                    : file + " has no " + kind + " " + name + "; it has " + String.join(", ", all));
        }
        return name;
    }

    /** The name under which the emulator watches a pin. */
    String watched(Parameters.Pin pin) {
        return boards.watched(pin.board(), pin.name()).orElseThrow(() -> wrong("board.json watches no pin "
                + pin.name() + " of " + pin.board() + ", and its chip has none of that name; a name is one of "
                + boards.watchedNames(pin.board())));
    }

    // How it runs

    /** JaCaMo's threads run in the computer's time. */
    private boolean isJaCaMo() {
        return agentsFile.toString().endsWith(".jcm");
    }

    /** By how much more time something has to happen than the feature says. */
    int slack() {
        return isJaCaMo() ? JACAMO_SLACK : 1;
    }

    long nanos() {
        return engine.nanos();
    }

    /** How long after it has happened something may be told, in ns. */
    long latest() {
        return engine.latest();
    }

    void begin() {
        if (engine != null) {
            runUntil(() -> false, nanos());
            return;
        }
        try {
            boards = BoardFile.read(boardsFile, radio, others.names());
            if (realPort != null && !(boards.names().size() == 1 && radio.isEmpty())) {
                throw RealBoard.unchecked(step);
            }
            engine = realPort == null ? emulator()
                    : new RealBoard(Path.of(realPort), Path.of(boards.ports().get(0)), folder, account, () -> step);
            others.begin();
            agents = engine.start(agentsFile);
        } catch (NoSuchFileException e) {
            throw new StepFailure("the scenario cannot start: there is no file " + e.getMessage());
        } catch (IOException e) {
            throw new StepFailure("the scenario cannot start: " + e.getMessage());
        } catch (IllegalStateException | AssertionError e) {
            throw broken(e);
        }
        if (!runUntil(() -> busy().isEmpty(), nanos() + LONGEST_BEGINNING)) {
            throw failure("the scenario has not begun within " + Seen.seconds(LONGEST_BEGINNING) + ": " + busy().get());
        }
        runUntil(() -> agents().agents().stream().noneMatch(this::lacksPercepts), nanos() + LONGEST_WAIT_FOR_PERCEPTS);
        begun = true;
        pass(0);
        expected.countFromNow();
    }

    private Engine emulator() throws IOException {
        boolean real = realTime || isJaCaMo();
        Path files = folder.toAbsolutePath();
        List<String> command = List.of(System.getProperty("javino.emulator", "javino-emulator"),
                boards.write(files, real).toString(), "--directory", files.toString(), "--keys", files + "/keys");
        return real ? new EmulatedBoards(command, seed, folder, account)
                : new EmulatedTime(command, boards.ports(), seed, folder.resolve("trace.jsonl"), account);
    }

    /** Whether the board is a real one: what the emulator would do is done by hand, and its pins are not seen. */
    boolean isByHand() {
        return engine instanceof RealBoard;
    }

    /** Whether nobody can see what this step expects: then its time passes, and it is told of at the end. */
    boolean isUnseen(Window window) {
        if (isByHand()) {
            RealBoard.UNCHECKED.add(step);
            runUntil(() -> false, nanos() + (window.kind() == Window.Kind.UNSAID ? 0 : window.nanos()));
        }
        return isByHand();
    }

    /** @return whether it is as wanted before that time. */
    boolean runUntil(BooleanSupplier wanted, long end) {
        try {
            return engine.runUntil(wanted, end);
        } catch (IllegalStateException | AssertionError e) {
            throw broken(e);
        }
    }

    /** What ends the run itself; what is wrong with its boards is told of the user's own file. */
    private StepFailure broken(Throwable why) {
        broken = true;
        String text = why.getMessage().replace(folder.toAbsolutePath() + "/board.json", boardsFile.toString())
                .replaceFirst(".*\\[javino-emulator: (.*)\\].*", "$1");
        return new StepFailure("the scenario cannot " + (begun ? "go on: " : "start: ") + text);
    }

    private Optional<String> busy() {
        return agents().agents().stream().map(agent -> "agent " + agent + ": " + agents().busy(agent))
                .filter(each -> !each.endsWith(": ")).findFirst();
    }

    /** Whether an agent has a board, and believes nothing that it perceives. */
    boolean lacksPercepts(String agent) {
        List<String> percepts =
                account.beliefs(agent).stream().filter(belief -> belief.contains("source(percept)")).toList();
        return percepts.stream().anyMatch(belief -> belief.startsWith("port("))
                && percepts.stream().allMatch(belief -> belief.startsWith("port(") || belief.startsWith("openness("));
    }

    /** Lets time pass. */
    void pass(long nanos) {
        runUntil(() -> false, nanos() + nanos);
        account.mark();
    }

    /** When what was taken away has come back, or does; negative if nothing was. */
    long returns() {
        return returns;
    }

    /** What was taken away comes back by itself then. */
    void returnsIn(long nanos) {
        returns = engine.after(nanos, () -> {});
    }

    /** Has a command given after a time, by which what was taken away until then returns. */
    void later(long nanos, Map<String, Object> command) {
        returns = engine.after(nanos, () -> tell(command));
    }

    /** A when: gives the emulator a command, in the words of emulator/README.md. */
    void command(Map<String, Object> command) {
        account.mark();
        tell(command);
    }

    private void tell(Map<String, Object> command) {
        try {
            engine.command(command);
        } catch (IOException refused) {
            throw wrong(refused.getMessage());
        }
    }

    /** A when: gives an agent an event, as {@code +!go}. */
    void give(String agent, String event) {
        account.mark();
        try {
            agents().give(agent, event);
        } catch (IOException wrong) {
            throw wrong(wrong.getMessage());
        }
    }

    // How it fails

    /** The failure of this step, as the feature itself is wrong. */
    StepFailure wrong(String what) {
        return failure(what, false, null);
    }

    /** The failure of this step: what is not as it should be. */
    StepFailure failure(String what) {
        return failure(what, null);
    }

    /** The same, with the answer to a question; null for none. */
    StepFailure failure(String what, Expectations.Question why) {
        return failure(what, true, why);
    }

    private StepFailure failure(String what, boolean seen, Expectations.Question why) {
        String head = step.isEmpty() ? "" : step + "\n";
        if (engine == null) {
            return new StepFailure(head + (step.isEmpty() ? "" : "  ") + what);
        }
        String again = feature + (isByHand() ? " -Pport=" + realPort : " -Pseed=" + seed
                + "\n  its trace: javino watch --trace " + folder.resolve("trace.jsonl")
                + "\n  why: javino why " + folder.resolve("run.jsonl") + " "
                + (why == null ? "WHAT" : "'" + why.what() + "'"));
        String printed = engine instanceof RealTimeEngine
                ? "\n  all that its agents have printed: " + folder.resolve("agents.log") : "";
        return new StepFailure(head + new Explanation(this, account).of(what, seen, why)
                + "  this runs it again: gradle test -Pfeature=" + again + printed);
    }

    /** Checks what was not to happen at all, and ends agents and boards. */
    @Override
    public void close() {
        now = null;
        try {
            expected.end();
        } finally {
            end();
        }
    }

    /** The file of what has happened on boards and in agents until now, of which {@code javino why} asks. */
    Path log() throws IOException {
        Path file = folder.resolve("run.jsonl");
        account.log().write(folder.resolve("trace.jsonl"), file);
        return file;
    }

    private void end() {
        if (engine == null) {
            return;
        }
        try {
            if (!broken) {
                others.close();
            }
        } finally {
            account.log().settle();
            try {
                engine.close();
            } catch (AssertionError again) {
                if (!broken) {
                    throw again;
                }
            }
            try {
                log();
            } catch (IOException failed) {
                throw new StepFailure("there is no run.jsonl: " + failed.getMessage());
            }
        }
    }
}
