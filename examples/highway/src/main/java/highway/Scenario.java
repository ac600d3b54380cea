package highway;

import features.WatchedRun;
import highway.Observation.Kind;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import trace.MalformedEventException;
import trace.TraceEvent;
import uppaal.conformance.Replay;

/**
 * One run: boards, keys, agents, and what is seen of them. Everything that is started here is ended by {@link #close}.
 *
 * <p>All that the child processes print becomes an observation, which this class' one thread takes from a queue.
 */
final class Scenario implements AutoCloseable {

    /** The run cannot go on; the message says why. */
    static final class BrokenOffException extends Exception {
        private static final long serialVersionUID = 1L;

        BrokenOffException(String message) {
            super(message);
        }
    }

    /** All events, for a second look: {@code gradle checkTrace -Ptrace=FILE}, {@code javino watch --trace FILE}. */
    private static final Path TRACE = Path.of("build", "trace.jsonl");

    private static final Path MOVES = Path.of("build", "moves");

    private static final Path KEYRING = Path.of("build", "keyring");

    /** The folder of the authority: its own file, requests and certificates. */
    private static final Path AUTHORITY = Path.of("build", "authority");

    private static final Path EEPROM = Path.of("build", "eeprom");

    private static final Path BROKER = Path.of("build", "mosquitto.conf");

    /** Each cell has the name of its gateway's board. */
    private static final List<String> CELLS = List.of("west", "east");

    private static final int SECONDS_FOR_A_VIEWER = 30;
    /** The part of its own speed at which a first viewer can follow the story. */
    private static final double TOLD_AT = 0.3;
    /** Words with which agents begin, and which tell nothing of the story. */
    private static final List<String> ASIDE = List.of("I am a Diffuser agent", "Ready");
    private static final Pattern SAID = Pattern.compile("\\[(\\w+)] (.*)");

    private static final Path PICTURE = Path.of("build", "highway.svg");

    private final Options options;
    private final Timeline timeline;
    private final SequenceDiagram chart = new SequenceDiagram();
    private final Replay model = new Replay(KEYRING);
    private final BlockingQueue<Runnable> happenings = new LinkedBlockingQueue<>();
    private final List<Path> features;
    /** What is missing of each; empty if it was observed. */
    private final Map<String, String> behaviours = new LinkedHashMap<>();
    private final Set<Device> ready = EnumSet.noneOf(Device.class);
    private final Set<Device> connected = EnumSet.noneOf(Device.class);
    private int joined;
    private int events;
    /** Emulated time of the last event: what happens outside of the emulator is not earlier than that. */
    private double seconds;
    private final List<ChildProcess> children = new ArrayList<>();
    private FileChannel lock;
    private EventLog log;
    /** The lines about the page: its address is the last one. */
    private final List<String> page = new ArrayList<>();
    private boolean pageEnded;
    private boolean introduced;
    private WatchedRun watched;
    private boolean followed;
    private boolean viewed;
    private String verdict = "";
    private String failure;
    private boolean agentsStarted;
    private volatile boolean closed;

    Scenario(Options options, Timeline timeline) {
        this.options = options;
        this.timeline = timeline;
        features = options.features();
        WatchedRun.scenarios(features).forEach(name -> behaviours.put(name, "not reached"));
    }

    /** A line of the launcher itself. */
    void note(String text) {
        timeline.note(text);
        tell("note", "text", text);
    }

    /** A line about what went wrong. */
    void warn(String text) {
        timeline.warn(text);
        tell("note", "text", text);
    }

    private void tell(String event, Object... fields) {
        if (log != null) {
            log.tell(seconds, event, fields);
        }
    }

    /** What is missing of each; empty if it was observed. */
    Map<String, String> behaviours() {
        return behaviours;
    }

    boolean allObserved() {
        return behaviours.values().stream().allMatch(String::isEmpty);
    }

    /** Whether there is anything that a table could tell. */
    boolean agentsStarted() {
        return agentsStarted;
    }

    /** Switches the boards on and waits until the emulator has made their ports. */
    void startBoards() throws IOException, InterruptedException, BrokenOffException {
        lockFolder();
        log = new EventLog(TRACE);
        if (options.live()) {
            startPage();
        }
        timeline.note("five emulated boards, one radio");
        Files.deleteIfExists(KEYRING);
        deleteAll(Options.IDENTITIES);
        if (options.certificates()) {
            // Boards have the keys of earlier runs.
            deleteAll(EEPROM);
        }
        Files.createDirectories(EEPROM);
        // Moves of a run that was broken off.
        deleteAll(MOVES);
        watched = new WatchedRun(options.scenario());
        start("emulator", options.emulatorCommand(KEYRING), this::readTrace);
        waitFor("the boards' ports", () -> Arrays.stream(Device.values())
                .allMatch(device -> Files.exists(Path.of("ports", device.id()))));
    }

    /** Joins the cells, if there are two, by a broker on this computer and a gateway in each. */
    void joinCells() throws IOException, InterruptedException, BrokenOffException {
        if (!options.twoCells()) {
            return;
        }
        note("two cells, 5 km from each other; a broker, and a gateway without any key in each");
        int port;
        try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
        Files.writeString(BROKER, "listener " + port + " 127.0.0.1\nallow_anonymous true\n");
        start("the broker", Options.brokerCommand(BROKER), line -> joined += line.contains(" running") ? 1 : 0);
        waitFor("the broker", () -> joined == 1);
        for (String cell : CELLS) {
            start("the gateway of " + cell, options.gatewayCommand(cell, port), line -> {
                note(cell + ": " + line);
                joined += line.endsWith("is joined") ? 1 : 0;
            });
        }
        waitFor("the gateways", () -> joined == 1 + CELLS.size());
    }

    private static void deleteAll(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> files = Files.walk(folder)) {
                for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    /** A second run in this folder would mix up ports, EEPROM files and keys. The lock goes with this process. */
    private void lockFolder() throws IOException, BrokenOffException {
        Files.createDirectories(Path.of("build"));
        lock = FileChannel.open(Path.of("build", "lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        if (lock.tryLock() == null) {
            throw new BrokenOffException("another run in this folder has not ended yet");
        }
    }

    /** Starts the page's server; where that ends, the run goes on. */
    private void startPage() throws IOException {
        Files.deleteIfExists(Options.LIVE);
        // Its address has a token, which belongs to the user only: it is shown, and not recorded.
        log.show(launch(options.watchCommand(), this::readPage,
                status -> {
                    pageEnded = true;
                    warn("the page has ended with status " + status + "; the run goes on");
                }));
    }

    private void readPage(String line) {
        if (!line.startsWith("http://") && !line.contains("ssh -L")) {
            timeline.note(line);
            return;
        }
        page.add(line);
        if (agentsStarted) {
            // The server was late.
            timeline.plain(line);
        }
    }

    /** Shows where the page is, if there is one: behind what would scroll it away. */
    void showPage() {
        page.forEach(timeline::plain);
    }

    private void readTrace(String line) {
        TraceEvent event;
        Optional<Observation> seen;
        try {
            event = TraceEvent.parse(events + 1, line);
            seen = Trace.read(event);
        } catch (MalformedEventException noEvent) {
            // A message of the emulator, or cut off.
            warn(line);
            return;
        }
        events++;
        seconds = event.seconds();
        log.line(seconds, line);
        watched.traced(line);
        viewed |= event.is("command") && event.text("do").equals("speed");
        if (!introduced) {
            introduced = true;
            introduce();
        }
        seen.ifPresent(this::see);
        model.event(event);
        if (model.refusal().isPresent()) {
            judge();
        }
    }

    /** Says who takes part, and what is to be observed; the page knows nothing of highways. */
    private void introduce() {
        tell("about", "text", "Each vehicle has an agent, a board and a radio. There is no network: what they tell"
                + " each other, everybody near can hear.", "roads", List.of(0), "aside",
                Stream.concat(ASIDE.stream(),
                        Arrays.stream(Device.values()).map(device -> "My board at ports/" + device.id() + " is on"))
                        .toList());
        for (Device device : Device.values()) {
            tell("device", "board", device.id(), "address", device.address, "title", device.title(), "colour",
                    device.hue);
        }
        behaviours.keySet().forEach(this::tell);
    }

    private void tell(String behaviour) {
        tell("behaviour", "number", List.copyOf(behaviours.keySet()).indexOf(behaviour) + 1, "text", behaviour,
                "observed", behaviours.get(behaviour).isEmpty());
    }

    /** Tells what the model says up to now, if it says something new. */
    private void judge() {
        boolean accepted = model.refusal().isEmpty();
        // An acceptance counts the events, and so would be another each time.
        String now = accepted ? "model: trace accepted" : model.verdict();
        if (!now.equals(verdict)) {
            verdict = now;
            tell("verdict", "text", now, "accepted", accepted);
        }
    }

    /** Draws what was seen, and says what the model says of it. */
    void draw() throws IOException {
        judge();
        chart.write(PICTURE);
        note("the run as a picture: " + PICTURE.toAbsolutePath());
    }

    /** Whether the model allows what the boards did; after the end. */
    Replay model() {
        model.finish();
        return model;
    }

    /** Makes fresh keys and gives each board its id and those that it needs, by the commands that a user has. */
    void provision() throws IOException, InterruptedException, BrokenOffException {
        if (options.certificates()) {
            certify();
            return;
        }
        note("fresh keys, provisioned over serial");
        runToEnd("keygen", Map.of("", options.keygenCommand(KEYRING)));
        runToEnd("provision", Arrays.stream(Device.values())
                .collect(Collectors.toMap(device -> device.title() + ": ",
                        device -> options.provisionCommand(device, KEYRING))));
    }

    /** Gives each device a certificate, and no board a key, by the commands that a user has. */
    private void certify() throws IOException, InterruptedException, BrokenOffException {
        note("fresh certificates, and no keys");
        deleteAll(AUTHORITY);
        Files.createDirectories(AUTHORITY);
        Path file = AUTHORITY.resolve("authority");
        runToEnd("ca init", Map.of("", options.authorityCommand(file)));
        for (Device device : Device.values()) {
            Path request = AUTHORITY.resolve(device.address + ".request");
            Path certificate = AUTHORITY.resolve(device.address + ".certificate");
            String title = device.title() + ": ";
            runToEnd("enroll", Map.of(title, options.requestCommand(device, request)));
            runToEnd("ca issue", Map.of(title, options.issueCommand(file, device, request, certificate)));
            runToEnd("enroll", Map.of(title, options.enrollCommand(device, certificate)));
        }
    }

    /** Starts the agents; the bus last, when all others have said that they are ready and that their boards are on. */
    void startAgents() throws IOException, InterruptedException, BrokenOffException {
        agentsStarted = true;
        note("five agents, each in a Java virtual machine of its own");
        showPage();
        if (options.live()) {
            waitFor("the page", () -> pageEnded || Files.exists(Options.LIVE));
        }
        awaitViewer();
        for (Device device : Device.values()) {
            if (device != Device.BUS) {
                startAgent(device);
            }
        }
        Set<Device> hearers = EnumSet.complementOf(EnumSet.of(Device.BUS));
        waitFor("four agents and their boards to be ready",
                () -> ready.containsAll(hearers) && connected.containsAll(hearers));
        startAgent(Device.BUS);
    }

    /** The page of the first viewer slows the run down. Where nobody comes, the story is told all the same. */
    private void awaitViewer() throws InterruptedException, BrokenOffException {
        if (!options.awaitsViewer()) {
            return;
        }
        timeline.note("the story waits up to " + SECONDS_FOR_A_VIEWER + " s for somebody who looks at the page");
        tell("story", "speed", TOLD_AT);
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(SECONDS_FOR_A_VIEWER);
        while (!viewed && System.nanoTime() < end) {
            takeHappening(TimeUnit.MILLISECONDS.toNanos(50));
        }
        if (!viewed) {
            timeline.note("nobody looks at the page yet: the story begins");
        }
        tell("story", "begun", true);
    }

    /** Follows the run until the features have ended, or the time is over. */
    void follow() throws InterruptedException, BrokenOffException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(options.timeout());
        watched.play(features, wanted -> goOn(wanted, end), ended -> {
            behaviours.put(ended.scenario(), ended.missing());
            tell(ended.scenario());
        });
        followed = true;
        // A page that has slowed the run down lets it go on at the speed of life.
        tell("story", "speed", 1);
        takeHappening(0);
    }

    /** What breaks the run off is told behind the features, which have no time then. */
    private boolean goOn(BooleanSupplier wanted, long end) {
        try {
            return until(wanted, end);
        } catch (BrokenOffException brokenOff) {
            return false;
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    /** Keeps the boards running until the launcher is ended. */
    void stay() throws InterruptedException, BrokenOffException {
        while (true) {
            takeHappening(Long.MAX_VALUE);
        }
    }

    private void startAgent(Device device) throws IOException {
        start(device.id(), options.agentCommand(device), line -> see(printed(device, line)));
    }

    /** A line that Jason marks with an agent's name is the agent's. */
    private Observation printed(Device device, String line) {
        Matcher said = SAID.matcher(line);
        if (!said.matches()) {
            return new Observation(seconds, Kind.WARNS, device.address, "", line);
        }
        watched.printed(said.group(1), said.group(2));
        // Another agent of that MAS has its name before what it says.
        return new Observation(seconds, Kind.SAYS, device.address, "",
                said.group(1).equals(device.id()) ? said.group(2) : line);
    }

    /** Starts a process that is to run as long as the scenario does. */
    private void start(String name, List<String> command, Consumer<String> line) throws IOException {
        launch(command, line, status -> failure = name + " has ended with status " + status).input().close();
    }

    /** Runs commands side by side until all have ended well; what they print is shown, each behind its title. */
    private void runToEnd(String name, Map<String, List<String>> commands)
            throws IOException, InterruptedException, BrokenOffException {
        AtomicInteger running = new AtomicInteger(commands.size());
        for (Map.Entry<String, List<String>> command : commands.entrySet()) {
            launch(command.getValue(), line -> note(command.getKey() + line), status -> {
                running.decrementAndGet();
                if (status != 0) {
                    failure = name + " has ended with status " + status;
                }
            }).input().close();
        }
        waitFor(name + " to end", () -> running.get() == 0);
    }

    private synchronized ChildProcess launch(List<String> command, Consumer<String> line, IntConsumer ended)
            throws IOException {
        if (closed) {
            throw new IOException("the run is being ended");
        }
        ChildProcess child = ChildProcess.start(command,
                text -> happenings.add(() -> line.accept(text)),
                status -> happenings.add(() -> ended.accept(status)));
        children.add(child);
        return child;
    }

    private void see(Observation seen) {
        // A run that goes on after its end would fill the terminal; the page shows it.
        if (!(options.live() && followed)) {
            timeline.show(seen);
        }
        chart.add(seen);
        Device.withAddress(seen.who()).ifPresent(device -> {
            switch (seen.kind()) {
                case SAYS -> {
                    Matcher another = SAID.matcher(seen.text());
                    boolean isAnother = another.matches();
                    log.note(seconds, "said", "board", device.id(), "agent",
                            isAnother ? another.group(1) : device.id(), "text",
                            isAnother ? another.group(2) : seen.text());
                    if (seen.text().equals("Ready")) {
                        ready.add(device);
                    } else if (seen.text().matches("My board at .* is on")) {
                        connected.add(device);
                    }
                }
                case WARNS -> log.note(seconds, "warned", "board", device.id(), "text", seen.text());
                default -> {
                    // The trace has it.
                }
            }
        });
    }

    private void waitFor(String what, BooleanSupplier condition)
            throws InterruptedException, BrokenOffException {
        if (!until(condition, System.nanoTime() + TimeUnit.SECONDS.toNanos(options.timeout()))) {
            throw new BrokenOffException("waited " + options.timeout() + " s for " + what + " in vain");
        }
    }

    /** Whether the condition came true in time; a run that is watched has any time, since it can be paused. */
    private boolean until(BooleanSupplier condition, long end) throws InterruptedException, BrokenOffException {
        while (!condition.getAsBoolean()) {
            if (!options.live() && System.nanoTime() >= end) {
                return false;
            }
            takeHappening(TimeUnit.MILLISECONDS.toNanos(50));
        }
        return true;
    }

    private void takeHappening(long nanos) throws InterruptedException, BrokenOffException {
        Runnable happening = happenings.poll(nanos, TimeUnit.NANOSECONDS);
        if (happening != null) {
            happening.run();
        }
        // Processes that end after close() were ended by it.
        if (failure != null && !closed) {
            throw new BrokenOffException(failure);
        }
    }

    /** Ends all that runs; called at the end, and by the virtual machine where that comes first (Ctrl-C). */
    @Override
    public synchronized void close() {
        closed = true;
        children.forEach(ChildProcess::end);
        children.forEach(ChildProcess::awaitEnd);
        if (log != null) {
            if (agentsStarted) {
                model.finish();
                judge();
            }
            log.close();
        }
    }
}
