package features;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import features.Seen.Kind;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Frame;
import javino.protocol.Key;
import lockstep.AgentProgram;
import lockstep.Simulation;
import lockstep.TraceFile;

/**
 * The run of one scenario: its boards and agents in emulated time, and what was seen of them. The first step that is
 * not of the boards' and agents' choice begins it; it has begun when no agent's start plans go on any more, and the
 * boards' first percepts are believed.
 */
final class Run implements AgentProgram.Observer, AutoCloseable {

    /** A scenario that has not begun in this time will not. */
    private static final long LONGEST_BEGINNING = 30 * Window.SECOND;
    /** A sketch that has no percepts begins without. */
    private static final long LONGEST_WAIT_FOR_PERCEPTS = 3 * Window.SECOND;
    /** What is counted in each run, by board and by Jason. */
    private static final Pattern OF_EACH_RUN = Pattern.compile("cycle|nb\\w+|serialRequests|radioSent|radioLateMicros");
    /** A sketch whose loop(), percepts or action takes longer is told of. */
    private static final int SLOW_MILLIS = 50;
    /** A board whose loop() waits answers nothing meanwhile. */
    private static final String UNANSWERED =
            "no answer of the board within 10 s (does its loop() wait, as by delay()?)";
    private static final int MOST_SEEN = 25;
    private static final long ASKING_NANOS = 100 * Window.MILLI;

    private static Run now;

    private final String feature;
    private final Path folder;
    private final List<Seen> seen = new ArrayList<>();
    private final List<Standing> standing = new ArrayList<>();
    private BoardFile boards;
    private Path agentsFile = Path.of(System.getProperty("javino.mas", "robot.mas2j"));
    private Path boardsFile = Path.of(System.getProperty("javino.boards", "board.json"));
    private long seed = Long.getLong("javino.seed", 1);
    private final Map<String, Object> radio = new TreeMap<>();
    /** Those that are played, by name; without their boards until the run begins. */
    private final Map<String, Device> devices = new TreeMap<>();
    private final List<Shared> keys = new ArrayList<>();
    /** The last packet of each board, in hexadecimal digits. */
    private final Map<String, String> payloads = new TreeMap<>();
    private Simulation simulation;
    private TraceFile trace;
    private AgentProgram program;
    private boolean begun;
    private boolean broken;
    private String step = "";
    private String lastBoard = "";
    private String lastAgent = "";
    /** Of {@link #seen}, what came after the last when. */
    private int mark;
    private long whenNanos;
    private long returns = -1;
    private final Map<String, CompletableFuture<Map<String, Object>>> countsBefore = new TreeMap<>();

    /** A key of a device and an agent's board; or two that should be one. */
    private record Shared(Parameters.Peer peer, String device, boolean same) {}

    /** Something that is not to happen until the scenario ends. */
    private record Standing(String step, int from, String what, Predicate<Seen> matching) {}

    /** @param feature the scenario's file and line, as Cucumber takes them. */
    private Run(String feature, Path folder) {
        this.feature = feature;
        this.folder = folder;
    }

    /** The run of the scenario that goes on. */
    static Run now() {
        if (now == null) {
            throw new IllegalStateException("no scenario goes on");
        }
        return now;
    }

    /** Prepares a scenario, whose files go to a folder of its own. */
    static void prepare(String feature, Path folder) {
        now = new Run(feature, folder);
    }

    static Optional<Run> current() {
        return Optional.ofNullable(now);
    }

    /** Tells which step comes. */
    void step(String text) {
        step = text;
    }

    // What the scenario has

    private void choose() {
        if (simulation != null) {
            throw failure("boards, agents, seed and radio are chosen before the first other step", List.of());
        }
    }

    void boards(String file) {
        choose();
        boardsFile = Path.of(file);
    }

    void agents(String file) {
        choose();
        agentsFile = Path.of(file);
    }

    void seed(long number) {
        choose();
        seed = number;
    }

    void radio(String key, Object value) {
        choose();
        radio.put(key, value);
    }

    void device(String name) {
        choose();
        devices.put(name, null);
    }

    void key(Parameters.Peer peer, String device, boolean same) {
        choose();
        if (!devices.containsKey(device)) {
            throw failure("there is no device " + device + " yet: 'Given the device " + device + "' goes before",
                    List.of());
        }
        keys.add(new Shared(peer, device, same));
    }

    private Device played(String name) {
        begin();
        Device found = devices.get(name);
        if (found == null) {
            throw failure("there is no device " + name + "; played are " + devices.keySet(), List.of());
        }
        return found;
    }

    /** Has the devices ready, with the keys that they share, before the agents start. */
    private void play() {
        devices.replaceAll((name, none) -> new Device(this, simulation, name, BoardFile.port(name)));
        devices.forEach((name, device) -> device.setId(name));
        for (Shared each : keys) {
            Key key = Key.random(simulation.secureRandom());
            devices.get(each.device).setKey(each.peer.address(), key);
            try (Device host = new Device(this, simulation, each.peer.board(), boards.portOf(each.peer.board()))) {
                host.setId(each.peer.address());
                host.setKey(each.device, each.same ? key : Key.random(simulation.secureRandom()));
            }
        }
        devices.values().forEach(Device::open);
    }

    void send(String device, Address to, Content content) {
        Device sender = played(device);
        mark();
        sender.send(to, content);
    }

    /** Sends a broadcast that nobody has sealed, in the name of another. */
    void inject(Address from, Content content) {
        begin();
        mark();
        inject(new Frame(Address.BROADCAST, from, content.encode()).encode().hex());
    }

    private void inject(String payload) {
        command(Map.of("do", "send", "position", List.of(0, 0), "payload", payload));
    }

    /** Sends the last packet of a board once more. */
    void repeat(String who) {
        begin();
        if (!payloads.containsKey(who)) {
            throw failure(who + " has sent no packet", seen);
        }
        mark();
        inject(payloads.get(who));
    }

    /** The board that words name. */
    String board(String words) {
        if (!words.equals("its")) {
            lastBoard = words.replaceFirst("'s$", "");
        }
        begin();
        if (!boards.names().contains(lastBoard)) {
            throw failure(lastBoard.isEmpty() ? "no board was named before" : boardsFile + " has no board "
                    + lastBoard + "; it has " + String.join(", ", boards.names()), List.of());
        }
        return lastBoard;
    }

    /** The agent that words name. */
    String agent(String words) {
        if (!words.equals("it")) {
            lastAgent = words.replaceFirst("^the agent ", "");
        }
        begin();
        if (!program.agents().agents().contains(lastAgent)) {
            throw failure(lastAgent.isEmpty() ? "no agent was named before" : agentsFile + " has no agent " + lastAgent
                    + "; it has " + String.join(", ", program.agents().agents()), List.of());
        }
        return lastAgent;
    }

    /** The name under which the emulator watches a pin. */
    String watched(Parameters.Pin pin) {
        return boards.watched(pin.board(), pin.name()).orElseThrow(() -> failure("board.json watches no pin "
                + pin.name() + " of " + pin.board() + ", and its chip has none of that name; a name is one of "
                + boards.watchedNames(pin.board()), List.of()));
    }

    // How it runs

    /** Begins the scenario, unless it has begun. */
    void begin() {
        if (simulation != null) {
            return;
        }
        try {
            boards = BoardFile.read(boardsFile, radio, devices.keySet());
            Path scenario = boards.write(folder);
            Path traceFile = folder.resolve("trace.jsonl");
            Files.deleteIfExists(traceFile);
            Files.createFile(traceFile);
            simulation = Simulation.start(List.of(emulator(), scenario.toString(), "--directory", folder.toString(),
                    "--trace", traceFile.toString(), "--keys", folder.resolve("keys").toString()), boards.ports(),
                    seed, Simulation.JITTER);
            trace = TraceFile.follow(simulation, traceFile, this::traced);
            play();
            program = AgentProgram.observe(simulation, agentsFile, this);
        } catch (NoSuchFileException e) {
            throw new StepFailure("the scenario cannot start: there is no file " + e.getMessage());
        } catch (IOException e) {
            throw new StepFailure("the scenario cannot start: " + e.getMessage());
        } catch (IllegalStateException | AssertionError e) {
            throw broken(e);
        }
        if (!runUntil(() -> busy().isEmpty(), LONGEST_BEGINNING)) {
            throw failure("the scenario has not begun within " + Seen.seconds(LONGEST_BEGINNING) + ": " + busy().get(),
                    seen);
        }
        runUntil(this::perceives, simulation.nanos() + LONGEST_WAIT_FOR_PERCEPTS);
        begun = true;
        mark();
        program.agents().agents().forEach(agent -> countsBefore.put(agent, program.agents().counts(agent)));
    }

    private boolean runUntil(BooleanSupplier wanted, long end) {
        try {
            return simulation.runUntil(wanted, end);
        } catch (IllegalStateException | AssertionError e) {
            throw broken(e);
        }
    }

    /** What ends the run itself; what is wrong with its boards is told of the user's own file. */
    private StepFailure broken(Throwable why) {
        broken = true;
        String text = why.getMessage().replace(folder.resolve("board.json").toString(), boardsFile.toString())
                .replaceFirst(".*\\[javino-emulator: (.*)\\].*", "$1");
        return new StepFailure("the scenario cannot " + (begun ? "go on: " : "start: ") + text);
    }

    private static String emulator() {
        return System.getProperty("javino.emulator", "javino-emulator");
    }

    private Optional<String> busy() {
        AgentProgram.Runner agents = program.agents();
        return agents.agents().stream()
                .flatMap(agent -> agents.busy(agent).map(why -> "agent " + agent + ": " + why).stream()).findFirst();
    }

    /** Whether each agent that has a board believes what that perceives. */
    private boolean perceives() {
        return program.agents().agents().stream().noneMatch(this::lacksPercepts);
    }

    private boolean lacksPercepts(String agent) {
        List<String> percepts = beliefs(agent).stream().filter(belief -> belief.contains("source(percept)")).toList();
        return percepts.stream().anyMatch(belief -> belief.startsWith("port("))
                && percepts.stream().allMatch(belief -> belief.startsWith("port(") || belief.startsWith("openness("));
    }

    /** A when: what is expected is to come after it. */
    void mark() {
        mark = seen.size();
        whenNanos = simulation.nanos();
    }

    /** Lets time pass. */
    void pass(long nanos) {
        begin();
        runUntil(() -> false, simulation.nanos() + nanos);
        mark();
    }

    /** Has something done after a time, and that is the return of what was taken away until then. */
    void later(long nanos, Map<String, Object> command) {
        returns = simulation.nanos() + nanos;
        simulation.at(returns, () -> command(command));
    }

    /** What was taken away comes back by itself then. */
    void returnsIn(long nanos) {
        returns = simulation.nanos() + nanos;
    }

    /** Gives the emulator a command, in the words of emulator/README.md. */
    void command(Map<String, Object> command) {
        try {
            simulation.command(BoardFile.json(command));
        } catch (IOException refused) {
            throw failure(refused.getMessage(), List.of());
        }
    }

    /** Gives an agent an event, as {@code +!go}. */
    void give(String agent, String event) {
        mark();
        try {
            program.agents().give(agent, event);
        } catch (IOException wrong) {
            throw failure(wrong.getMessage(), List.of());
        }
    }

    BoardFile boards() {
        begin();
        return boards;
    }

    // What is seen

    private void traced(String line) {
        JsonObject event = JsonParser.parseString(line).getAsJsonObject();
        long nanos = Math.round(event.get("t").getAsDouble() * Window.SECOND);
        String what = text(event, "event");
        String board = text(event, "board");
        switch (what) {
            case "pin" -> see(nanos, Kind.PIN, board, text(event, "name"),
                    event.get("level").getAsInt() == 1 ? "on" : "off");
            case "rf-tx" -> {
                payloads.put(board, text(event, "payload"));
                see(nanos, Kind.PACKET, board, text(event, "kind"),
                        "to " + text(event, "destination") + " " + text(event, "content"));
            }
            case "fault", "crash", "uart", "reset", "port" -> see(nanos, Kind.BOARD, board, what,
                    Stream.of("do", "line", "why", "state").map(field -> text(event, field))
                            .filter(text -> !text.isEmpty()).findFirst().orElse(""));
            default -> {
                // The trace has it.
            }
        }
    }

    private static String text(JsonObject event, String field) {
        return event.has(field) ? event.get(field).getAsString() : "";
    }

    private void see(long nanos, Kind kind, String who, String what, String more) {
        seen.add(new Seen(nanos, kind, who, what, more));
    }

    /** Now. */
    void see(Kind kind, String who, String what, String more) {
        see(simulation.nanos(), kind, who, what, more);
    }

    @Override
    public void printed(String agent, String line) {
        see(simulation.nanos(), Kind.PRINTS, agent, line, "");
    }

    @Override
    public void believes(String agent, String belief, boolean added) {
        see(simulation.nanos(), added ? Kind.BELIEVES : Kind.FORGETS, agent, belief, "");
    }

    @Override
    public void asksFor(String agent, String action) {
        see(simulation.nanos(), Kind.ASKS, agent, action, "");
    }

    @Override
    public void performed(String agent, String action, String error) {
        see(simulation.nanos(), error.isEmpty() ? Kind.PERFORMED : Kind.FAILED, agent, action, error);
    }

    /** What an agent believes now. */
    List<String> beliefs(String agent) {
        Map<String, Boolean> now = new TreeMap<>();
        seen.stream().filter(each -> each.is(Kind.BELIEVES, agent) || each.is(Kind.FORGETS, agent))
                .forEach(each -> now.put(each.what(), each.kind() == Kind.BELIEVES));
        return now.keySet().stream().filter(now::get).toList();
    }

    /** Whether a pin is on now. */
    boolean isOn(Parameters.Pin pin) {
        String name = watched(pin);
        boolean on = false;
        for (Seen each : seen) {
            on = each.is(Kind.PIN, pin.board()) && each.what().equals(name) ? each.more().equals("on") : on;
        }
        return on;
    }

    // What is expected

    /** Expects a state now. */
    void expectNow(boolean as, String what) {
        if (!as) {
            throw failure(what, since());
        }
    }

    /**
     * Expects something to happen, or not to.
     *
     * @param count how often; null if it is enough that it happens.
     * @param what  the failure if it does not happen, as {@code robot's lamp does not go on}.
     */
    void expect(Window window, Window.Count count, Predicate<Seen> matching, String what) {
        begin();
        if (window.ofReturn() && returns < 0) {
            throw failure("nothing was taken away that could return", List.of());
        }
        long from = window.ofReturn() ? returns : whenNanos;
        long end = from + window.nanos();
        Predicate<Seen> wanted = each -> each.nanos() <= end && each.nanos() >= from && matching.test(each);
        boolean not = window.kind() == Window.Kind.NOT_WITHIN || window.kind() == Window.Kind.NEVER;
        if (not && count != null) {
            throw failure("say either how often, or that it does not happen", List.of());
        }
        boolean came = runUntil(() -> count == null && since().stream().anyMatch(wanted), end)
                || since().stream().anyMatch(wanted);
        List<Long> times = since().stream().filter(wanted).map(Seen::nanos).toList();
        if (count != null) {
            count.wrong(times).ifPresent(often -> {
                throw failure("seen " + often, since());
            });
        } else if (came == not) {
            throw failure(not ? "it happens at " + Seen.seconds(times.get(0)) : what, since());
        }
        if (window.kind() == Window.Kind.NEVER) {
            standing.add(new Standing(step, seen.size(), what, matching));
        }
    }

    /** Expects a counter of an agent's board to rise, since the scenario began. */
    void expectCount(Window window, String agent, String counter) {
        begin();
        long before = number(get(countsBefore.get(agent)).get(counter));
        long end = (window.ofReturn() ? returns : whenNanos) + window.nanos();
        boolean not = window.kind() == Window.Kind.NOT_WITHIN || window.kind() == Window.Kind.NEVER;
        boolean rose = false;
        do {
            runUntil(() -> false, Math.min(end, simulation.nanos() + ASKING_NANOS));
            rose = number(get(program.agents().counts(agent)).get(counter)) > before;
        } while (!rose && simulation.nanos() < end);
        if (rose == not) {
            throw failure(counter + (rose ? " rises" : " does not rise"), since());
        }
    }

    /** What was seen since the last when. */
    private List<Seen> since() {
        return seen.subList(mark, seen.size());
    }

    /** What the agents' boards and architectures have counted since they have power. */
    private List<String> counters() {
        List<String> lines = new ArrayList<>();
        for (String agent : program.agents().agents()) {
            get(program.agents().counts(agent)).forEach((name, value) -> {
                long count = number(value);
                if (count >= (name.endsWith("Millis") ? SLOW_MILLIS : 1) && !OF_EACH_RUN.matcher(name).matches()) {
                    lines.add(name.equals(UNANSWERED) ? name : name + " " + count);
                }
            });
        }
        return lines;
    }

    /** The pins that are on now. */
    private List<String> on() {
        Map<String, Boolean> levels = new TreeMap<>();
        seen.stream().filter(each -> each.kind() == Kind.PIN)
                .forEach(each -> levels.put(each.who() + "'s " + each.what(), each.more().equals("on")));
        return levels.keySet().stream().filter(levels::get).toList();
    }

    private static long number(Object value) {
        return value instanceof Number number ? number.longValue() : 0;
    }

    private Map<String, Object> get(CompletableFuture<Map<String, Object>> counts) {
        try {
            return counts == null ? Map.of() : simulation.get(simulation.orTimeout(counts.copy(),
                    Duration.ofSeconds(10)));
        } catch (ExecutionException late) {
            return late.getCause() instanceof TimeoutException ? Map.of(UNANSWERED, 1) : Map.of();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return Map.of();
        }
    }

    /**
     * The failure of this step: what it is, when, what was seen in its place, and how this run is made again.
     *
     * @param instead what is to be told of what was seen.
     */
    StepFailure failure(String what, List<Seen> instead) {
        List<Seen> latest = List.copyOf(instead.subList(Math.max(0, instead.size() - MOST_SEEN), instead.size()));
        StringBuilder text = new StringBuilder(step.isEmpty() ? "" : step + "\n");
        if (simulation == null) {
            return new StepFailure(text.append("  ").append(what).toString());
        }
        text.append("  at ").append(Seen.seconds(simulation.nanos())).append(": ").append(what).append('\n');
        if (!instead.isEmpty()) {
            text.append("  seen since ").append(Seen.seconds(whenNanos)).append(":\n");
            latest.forEach(each -> text.append("    ").append(each).append('\n'));
        }
        if (program != null) {
            program.agents().agents().forEach(agent -> describe(agent, text));
            list(text, "  on: ", on());
            list(text, "  counted: ", counters());
        }
        return new StepFailure(text + "  this runs it again: gradle test -Pfeature=" + feature + " -Pseed=" + seed
                + "\n  its trace: javino watch --trace " + folder.resolve("trace.jsonl"));
    }

    private void describe(String agent, StringBuilder text) {
        list(text, "  " + agent + " believes: ", beliefs(agent).stream().map(Seen::brief).toList());
        if (lacksPercepts(agent)) {
            text.append("  ").append(agent)
                    .append(" has no percepts of its board: its plans need .percepts(open), its sketch percepts\n");
        }
        List<String> never = new ArrayList<>();
        program.agents().planned(agent).forEach((belief, place) -> {
            String name = belief.replaceFirst("/.*", "");
            if (seen.stream().noneMatch(each -> each.is(Kind.BELIEVES, agent) && each.what().split("[(\\[]")[0]
                    .equals(name))) {
                never.add("+" + belief + " (" + place + ")");
            }
        });
        list(text, "  " + agent + " has plans for what it has never believed: ", never);
    }

    private static void list(StringBuilder text, String head, List<String> all) {
        if (!all.isEmpty()) {
            text.append(head).append(String.join(", ", all)).append('\n');
        }
    }

    /** Checks what was not to happen at all, and ends agents and boards. */
    @Override
    public void close() {
        now = null;
        try {
            for (Standing each : standing) {
                List<Seen> after = seen.subList(each.from, seen.size());
                if (after.stream().anyMatch(each.matching)) {
                    step = each.step;
                    throw failure("it happens at " + Seen.seconds(after.stream().filter(each.matching).findFirst()
                            .orElseThrow().nanos()), after);
                }
            }
        } finally {
            end();
        }
    }

    private void end() {
        if (simulation == null) {
            return;
        }
        try {
            if (program != null && !broken) {
                program.close();
            }
            devices.values().stream().filter(device -> device != null && !broken).forEach(Device::close);
        } finally {
            try (TraceFile read = trace) {
                simulation.close();
                read.read();
            } catch (AssertionError again) {
                if (!broken) {
                    throw again;
                }
            }
        }
    }
}
