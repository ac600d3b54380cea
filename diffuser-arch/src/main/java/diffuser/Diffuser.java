package diffuser;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.logging.Level;

import jason.JasonException;
import jason.ReceiverNotFoundException;
import jason.architecture.AgArch;
import jason.asSemantics.ActionExec;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.Message;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.PlanBody;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;

import diffuser.board.BoardName;
import diffuser.board.BoardSettings;
import diffuser.board.Device;
import diffuser.board.DeviceContext;
import diffuser.board.ExclusivePort;
import diffuser.board.HostMessages;
import diffuser.board.HostService;
import diffuser.board.KeyService;
import diffuser.board.MoveService;
import diffuser.board.SensorMode;
import diffuser.gate.Gate;
import diffuser.gate.Texts;
import diffuser.gate.TrustLevel;
import diffuser.mind.Ability;
import diffuser.mind.CombinedPercepts;
import diffuser.mind.Destinations;
import diffuser.mind.Inbox;
import diffuser.mind.IncomingQuestion;
import diffuser.mind.Infrastructures;
import diffuser.mind.Intentions;
import diffuser.mind.Openness;
import diffuser.mind.Outbox;
import diffuser.mind.OutgoingMessage;
import diffuser.mind.Questions;
import diffuser.mind.Recorder;
import diffuser.report.Failure;
import diffuser.report.Warnings;

import javino.board.AirtimeHour;
import javino.board.BoardConfig;
import javino.board.LegacyBoardException;
import javino.board.Transmission;
import javino.keyring.BoardNotes;
import javino.link.LinkOpener;
import javino.link.SerialLink;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Conversation;
import javino.protocol.Counter;
import javino.protocol.Outcome;

/**
 * An agent with a board. Written as {@code agentArchClass diffuser.Diffuser} in a {@code .mas2j}, or as
 * {@code ag-arch: diffuser.Diffuser} in a {@code .jcm}.
 *
 * <p>It translates between the board on one side and percepts, messages and actions on the other, and passes everything
 * else on to the architectures behind it. A reasoning cycle never waits for the board.
 *
 * <p>Its methods are for the agent's own thread, as Jason calls them.
 */
public class Diffuser extends AgArch {

    /** The longest that a plan waits for a reading. */
    protected static final Duration LONGEST = Duration.ofSeconds(5);

    /** The port by which a board is left and none opened. */
    protected static final String NO_PORT = "none";

    private static final long serialVersionUID = 1L;

    /** About as long as a board that speaks the older protocol takes to be asked. */
    private static final Duration SHORT = Duration.ofMillis(100);

    private transient Warnings warnings;
    private transient Inbox inbox;
    private transient Outbox outbox;
    private transient Intentions intentions;
    private transient Questions questions;
    private transient ActionRouter router;
    private transient Infrastructures infrastructures;
    private transient CombinedPercepts percepts;
    private transient List<BoardService> services;
    private transient Optional<MoveService> moves;
    private transient HostMessages hosts;
    private transient Time time;
    private transient Time.Timer timer;
    private transient BoardSettings settings;
    /** By their names, the main one first. Also asked by threads that stop the agent, or show its status. */
    private transient NavigableMap<String, Device> boards;
    /** Guards {@link #ended}: whoever stops the agent may do so while its own thread opens a port. */
    private transient Object ending;
    private transient boolean ended;
    private transient volatile Consumer<String> printed;
    private transient ActionListener performed;
    private transient Optional<Recorder> recorder;

    public Diffuser() {
        leaveAll();
    }

    /** Without any board, and not in an agent yet. */
    private void leaveAll() {
        services = List.of();
        moves = Optional.empty();
        settings = BoardSettings.NONE;
        boards = new ConcurrentSkipListMap<>();
        ending = new Object();
        printed = text -> {};
        performed = (action, request, outcome) -> {};
        recorder = Optional.empty();
    }

    /** An agent that was written to a stream is read without its boards. */
    private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
        in.defaultReadObject();
        leaveAll();
    }

    /** {@inheritDoc} Called by Jason as soon as the agent around it is made. */
    @Override
    public void init() throws Exception {
        super.init();
        time = TimeSource.behind(this);
        timer = time.timer("hosts of " + getAgName(), this::stepFailed);
        warnings = new Warnings(() -> getTS().getLogger());
        outbox = new Outbox(warnings, this::signal);
        intentions = new Intentions(this::getTS);
        questions = new Questions(intentions, outbox, time.secureRandom().nextInt(Conversation.COUNT));
        services = ServiceLoader.load(BoardService.Maker.class).stream().map(maker -> maker.get().of(this)).toList();
        moves = service(MoveService.class);
        hosts = new HostMessages(services.stream().filter(HostService.class::isInstance).map(HostService.class::cast)
                .toList(), warnings::once);
        inbox = new Inbox(new Gate(this::getTS, warnings), questions, intentions, warnings);
        infrastructures = new Infrastructures();
        percepts = new CombinedPercepts();
        router = new ActionRouter(this, super::act, warnings);
    }

    /**
     * The Diffuser among an agent's architectures.
     *
     * @throws JasonException no_diffuser if it has none.
     */
    public static Diffuser of(TransitionSystem ts) throws JasonException {
        return find(ts.getAgArch()).orElseThrow(() -> new Failure("no_diffuser", "agent "
                + ts.getAgArch().getAgName() + " can have no board; give it the"
                + " architecture diffuser.Diffuser (agentArchClass in a .mas2j, ag-arch in a .jcm)").toException());
    }

    /** The Diffuser among an agent's architectures, from the first one on, if it has any. */
    public static Optional<Diffuser> find(AgArch first) {
        for (AgArch arch = first; arch != null; arch = arch.getNextAgArch()) {
            if (arch instanceof Diffuser diffuser) {
                return Optional.of(diffuser);
            }
        }
        return Optional.empty();
    }

    /** Opens a port; override it for another kind of link or another baud rate. */
    protected LinkOpener link(String port) {
        return time.port(port);
    }

    /** Whether {@code port(P,on)} is believed only with the first reading of the sensors: no, unless overridden. */
    protected boolean portWithSensors() {
        return false;
    }

    /** The term for a port in beliefs: a string, unless a subclass overrides it. */
    protected Term portTerm(String port) {
        return ASSyntax.createString(port);
    }

    /** The settings of the session with the board; override it for other times, or other notes of its epochs. */
    protected BoardConfig boardConfig() {
        return BoardConfig.create(config -> config.setNotes(BoardNotes.ofHost()));
    }

    /**
     * Looks for a board on a port, and leaves the port that it had before.
     *
     * @param board its name; a board beside the main one has percepts and actions only.
     * @param port a path or a system's name of a port, as {@link SerialLink#opener(String)} takes it;
     *             {@code none} only leaves a board that is not the main one.
     * @return completes when the agent believes whether a board is there and what it perceives, or when another port is
     *         opened; never fails, since a board may come later. An agent that was stopped opens none.
     */
    public CompletableFuture<Void> openPort(String port, String board) {
        boolean main = board.equals(BoardName.MAIN);
        if (port.equals(NO_PORT) && !main) {
            closePort(board);
            return CompletableFuture.completedFuture(null);
        }
        PlainLines.of(getAgName());
        if (!Charset.defaultCharset().equals(StandardCharsets.UTF_8)) {
            warnings.once("Java reads programs as " + Charset.defaultCharset() + " here, and letters beyond ASCII go"
                    + " wrong; start it with -Dfile.encoding=UTF-8");
        }
        synchronized (ending) {
            if (ended) {
                return CompletableFuture.completedFuture(null);
            }
            BoardSettings wanted = main ? settings
                    : device(board).map(Device::settings).orElseGet(settings::withoutRadio);
            ExclusivePort link = new ExclusivePort(link(port),
                    getAgName() + (main ? "" : " (board " + board + ")"), closePort(board), time);
            Device opened = Device.open(link, portTerm(port), boardConfig().in(time), wanted,
                    new DeviceContext(getAgName(), board, (message, peer) -> inbox.put(message, peer, getAgName()),
                            hosts, warnings, this::wakeAgent, text -> printed.accept(text),
                            service(KeyService.class), portWithSensors()));
            boards.put(board, opened);
            recordSettings();
            Duration patience = patience();
            return opened.decided().thenCompose(decided -> reading(Optional.of(board), patience));
        }
    }

    /** Leaves the port of that board, if it was opened; completes when it is free for another. */
    public CompletableFuture<Void> closePort(String board) {
        Device left = boards.remove(board);
        return left == null ? CompletableFuture.completedFuture(null) : left.close();
    }

    /** Leaves all boards but the main one: a mind that comes in the agent's place does not know them. */
    public void closeNamed() {
        boards.keySet().stream().filter(board -> !board.equals(BoardName.MAIN)).forEach(this::closePort);
    }

    /** The board of that name, or all. */
    private Map<String, Device> boards(Optional<String> board) {
        return board.map(name -> boards.subMap(name, true, name, true)).orElse(boards);
    }

    /** Completes when the agent believes what there is to perceive now. For any thread. */
    private CompletableFuture<Void> believed() {
        CompletableFuture<Void> belief = percepts.belief();
        wakeAgent();
        return belief;
    }

    /**
     * Sets whether the sensors' percepts are beliefs.
     *
     * @param board of which board; of all, also of those that come, if there is none.
     * @return completes when the agent believes a reading that is due within the {@link #patience()} of its plan; at
     *         once without a board; never fails.
     */
    public CompletableFuture<Void> sense(Optional<String> board, SensorMode wanted) {
        change(board, old -> old.withPercepts(wanted));
        return reading(board, patience());
    }

    /**
     * How long the selected intention may wait for a reading: 5 s if its next step asks what is believed, else 100 ms.
     */
    protected Duration patience() {
        Intention intention = getTS().getC().getSelectedIntention();
        boolean none = intention == null || intention.isFinished();
        PlanBody next = none ? null : intention.peek().getCurrentStep().getBodyNext();
        return next != null && next.getBodyType() == PlanBody.BodyType.test ? LONGEST : SHORT;
    }

    /**
     * The longest wait for sensors that take their time.
     *
     * @param patience the plan's.
     */
    protected Duration longestReading(Duration patience) {
        return patience;
    }

    /**
     * Waits for a reading of the sensors that begins after this. For any thread.
     *
     * @param board    of which board; of all if there is none.
     * @param patience how much later than now the reading may begin. There is no wait if its limit delays
     *                 it longer, if sensors are not read, or if there is no board.
     * @return completes when the agent believes the reading, or after {@link #longestReading}; never fails.
     */
    protected CompletableFuture<Void> reading(Optional<String> board, Duration patience) {
        CompletableFuture<Void> read = CompletableFuture.allOf(boards(board).values().stream()
                .map(each -> each.reading(patience)).toArray(CompletableFuture[]::new));
        return time.completeOnTimeout(read, null, longestReading(patience)).thenCompose(done -> believed());
    }

    /**
     * Changes what is wished of a board: now if it is there, or else as soon as it comes.
     *
     * @param board which; all, also those that are opened later, if there is none.
     */
    public void change(Optional<String> board, UnaryOperator<BoardSettings> change) {
        if (board.orElse(BoardName.MAIN).equals(BoardName.MAIN)) {
            settings = change.apply(settings);
        }
        boards(board).forEach((name, each) -> each
                .apply(name.equals(BoardName.MAIN) ? settings : change.apply(each.settings())));
        recordSettings();
    }

    /**
     * Says who is told what the sketch prints on the board's line (some of it at a time, perhaps several lines); on a
     * thread of the board's.
     */
    public void onPrinted(Consumer<String> listener) {
        printed = listener;
    }

    /** Is told each action that the board is asked for. */
    public interface ActionListener {

        /** @param request its number in the lines of {@link #record}; 0 if nothing is recorded. */
        void asked(String action, int request, CompletableFuture<?> outcome);
    }

    /** Says who is told each action that the board is asked for, with the future that {@link #perform} gives. */
    public void onPerformed(ActionListener listener) {
        performed = listener;
    }

    /**
     * Has all that the agent decides told from now on, as {@link Recorder} does; without it the agent does nothing for
     * that. Several can be told. Before the agent's first cycle, or on its own thread.
     *
     * @param lines takes each line of JSON as {@link Recorder} gives it; its time {@code t} is {@link #time()}'s, in s.
     */
    public void record(Consumer<Supplier<String>> lines) {
        Recorder one = recorder.orElseGet(() -> new Recorder(getTS(), time));
        one.begin(lines);
        record(Optional.of(one));
        one.watch();
        recordSettings();
    }

    /** Ends what {@link #record} has begun. On the agent's own thread. */
    public void endRecord(Consumer<Supplier<String>> lines) {
        if (recorder.isPresent() && recorder.get().end(lines)) {
            record(Optional.empty());
        }
    }

    private void record(Optional<Recorder> by) {
        recorder = by;
        inbox.record(by);
        outbox.record(by);
    }

    private void recordSettings() {
        recorder.ifPresent(each -> each.settings(settings, device().map(Device::port).orElse("")));
    }

    /** Sets the abilities that an infrastructure other than the board's radio gives from now on. */
    public void setInfrastructure(String name, Set<Ability> allows) {
        infrastructures.set(name, Set.copyOf(allows));
    }

    /**
     * The openness of the MAS, by this agent's board and the infrastructures that it knows, as it last perceived it.
     */
    public Openness openness() {
        return infrastructures.openness();
    }

    /** Sets the device's address: now if a board is there, or else as soon as one comes. */
    public CompletableFuture<Void> setRfId(Address id) {
        change(Optional.of(BoardName.MAIN), old -> old.withRfId(id));
        return whereThere(board -> board.setRfId(id));
    }

    /** Switches the reception of radio messages on or off: now if a board is there, or else as soon as one comes. */
    public CompletableFuture<Void> openRadio(boolean open) {
        change(Optional.of(BoardName.MAIN), old -> old.withRadio(open));
        return whereThere(board -> board.radio(open));
    }

    /**
     * An action as the board reads it: what a string holds, or a literal.
     *
     * @return nothing if the term is no action.
     * @throws JasonException wrong_arguments if a variable in it has no value.
     */
    public Optional<String> action(Term term) throws JasonException {
        if (term instanceof StringTerm string) {
            return Optional.of(string.getString()).filter(text -> !text.isEmpty());
        }
        return term.isLiteral() ? Optional.of(Texts.action((Literal) term)) : Optional.empty();
    }

    /**
     * Makes a board perform an action.
     *
     * @param action {@code name} or {@code name(arguments)}; within the name of a board that is not the main one.
     * @return the number that the action returns, if it returns one; fails with an exception that {@link Failure#of}
     *         reads.
     * @throws JasonException no_port if no port was opened; too_long if the action fits no request.
     */
    public CompletableFuture<OptionalInt> perform(String action) throws JasonException {
        String name = boardOf(action);
        Device board = requireDevice(name);
        String own = name.equals(BoardName.MAIN) ? action : action.substring(name.length() + 1, action.length() - 1);
        if (!own.equals(action) && device().map(main -> main.hasAction(name)).orElse(false)) {
            warnings.once("the sketch on " + device().get().port() + " has an action " + name + ", too; " + action
                    + " goes to the board " + name);
        }
        try {
            CompletableFuture<OptionalInt> outcome = board.act(own);
            int request = recorder.map(each -> each.asks(action, outcome)).orElse(0);
            performed.asked(action, request, outcome);
            return outcome;
        } catch (IllegalArgumentException e) {
            throw new Failure("too_long", e.getMessage()).toException();
        }
    }

    /**
     * The same for the number that the action returns; fails with no_value if it returns none, and with legacy_board,
     * and as a rule performs nothing, if the board speaks the older protocol, in which it cannot return any.
     */
    public CompletableFuture<Integer> measure(String action) throws JasonException {
        Device board = requireDevice(boardOf(action));
        if (board.isLegacy()) {
            throw withoutNumber(board, action).toException();
        }
        return perform(action).thenApply(number -> {
            if (number.isEmpty()) {
                throw new CompletionException(withoutNumber(board, action).toException());
            }
            return number.getAsInt();
        });
    }

    private static Failure withoutNumber(Device board, String action) {
        return board.isLegacy() ? Failure.of(new LegacyBoardException("act " + action + ", for a number,"))
                : new Failure("no_value", "act " + action + " was performed, and returned no number of 24 bits; to"
                        + " return one, its function in the sketch calls number() of a JavinoResult");
    }

    /** The board in whose name an action is, as in {@code arm(close)}; the main one if there is none of that name. */
    protected String boardOf(String action) {
        String name = action.substring(0, Math.max(0, action.indexOf('(')));
        return action.endsWith(")") && boards.containsKey(name) ? name : BoardName.MAIN;
    }

    /** A message for the radio, as {@link OutgoingMessage#of} reads it. */
    public OutgoingMessage outgoing(Term to, Term performative, Term content) throws JasonException {
        return OutgoingMessage.of(to, performative, content, questions::next);
    }

    /**
     * Makes the board transmit a message; an event tells the agent how it ended.
     *
     * @return completes as soon as the board has taken the message; fails with what {@link Failure#of} reads.
     * @throws JasonException no_port if no port was opened.
     */
    public CompletableFuture<?> diffuse(OutgoingMessage outgoing) throws JasonException {
        Device board = requireDevice(BoardName.MAIN);
        questions.remember(outgoing);
        return outbox.diffuse(outgoing, board);
    }

    /**
     * Makes the board transmit a message; only the future tells how it ended.
     *
     * @param outgoing a message that is acknowledged.
     * @return completes when the message is delivered; fails with what {@link Failure#of} reads.
     * @throws JasonException no_port if no port was opened.
     */
    public CompletableFuture<?> deliver(OutgoingMessage outgoing) throws JasonException {
        Device board = requireDevice(BoardName.MAIN);
        questions.remember(outgoing);
        return outbox.deliver(outgoing, board);
    }

    /**
     * Asks the board for its counters. For any thread.
     *
     * @return fails with an exception that {@link Failure#of} reads; without a board there are none.
     */
    public CompletableFuture<Map<Counter, Long>> counters() {
        return device().map(Device::counters).orElseGet(() -> CompletableFuture.completedFuture(Map.of()));
    }

    /** How much of the last hour the board's radio has sent; nothing where that is not known. For any thread. */
    public Optional<AirtimeHour.Use> airtime() {
        return device().flatMap(Device::airtime);
    }

    /**
     * Sends a message. For any thread.
     *
     * @return fails with what {@link Failure#of} reads, also where no port was opened.
     */
    public Transmission transmit(Address to, javino.protocol.Message message) {
        return device().map(board -> board.transmit(to, message)).orElseGet(() -> {
            JasonException none = noPort(BoardName.MAIN);
            return new Transmission(CompletableFuture.failedFuture(none), CompletableFuture.failedFuture(none));
        });
    }

    /** The port that was opened, as the program names it. For any thread. */
    public Optional<String> port() {
        return device().map(Device::port);
    }

    /** What the board said of itself, if it is there now. For any thread. */
    public Optional<BoardInfo> board() {
        return device().filter(Device::isOnline).flatMap(Device::info);
    }

    /** The device's address, as far as it is known. For any thread. */
    public Optional<Address> address() {
        return device().flatMap(Device::address);
    }

    /** The time of this agent, its board and the libraries by it; none of them asks the computer. */
    public Time time() {
        return time;
    }

    /** When, and on which thread, libraries do what they do by this board. */
    public Time.Timer timer() {
        return timer;
    }

    private void stepFailed(RuntimeException e) {
        if (e instanceof UncheckedIOException disk) {
            warnings.always("a step waits for the disk: " + disk.getMessage());
        } else {
            getTS().getLogger().log(Level.SEVERE, "a step of a host has failed: " + e, e);
        }
    }

    /** The service of that kind by this board, if a library for it is on the class path. */
    public <T> Optional<T> service(Class<T> kind) {
        return services.stream().filter(kind::isInstance).map(kind::cast).findFirst();
    }

    /** The trust level of a device from which a sealed message came; certified without a board. For any thread. */
    public TrustLevel peer(Address device) {
        return device().map(board -> board.peer(device)).orElse(TrustLevel.CERTIFIED);
    }

    /** The inbox for the board's messages. */
    Inbox inbox() {
        return inbox;
    }

    /**
     * Whether an action of that name is the board's: of a board that speaks the older protocol that is believed of any.
     */
    protected boolean performs(String action) {
        return device().map(board -> board.performs(action)).orElse(false);
    }

    /** Whether the board's sketch names no actions, and reads by itself what it is to do, as far as is known. */
    protected boolean readsActions() {
        return device().map(Device::readsActions).orElse(false);
    }

    /** Whether the board, if one was opened, has a radio, as far as is known. */
    public boolean hasRadio() {
        return device().map(Device::hasRadio).orElse(true);
    }

    /** The main board, if a port was opened. */
    Optional<Device> device() {
        return device(BoardName.MAIN);
    }

    /** @throws JasonException no_port if no board of that name was opened. */
    Device requireDevice(String name) throws JasonException {
        return device(name).orElseThrow(() -> noPort(name));
    }

    Optional<Device> device(String board) {
        return Optional.ofNullable(boards.get(board));
    }

    // The hooks of the reasoning cycle.

    /** {@inheritDoc} Null, as Jason has it, if nothing has changed, neither at the board nor elsewhere. */
    @Override
    public Collection<Literal> perceive() {
        if (percepts == null) {
            initAgain();
        }
        percepts.perceiving();
        return percepts.perceive(super.perceive(), perceivedHere());
    }

    /** An agent that was read from a stream is not initialized by Jason. */
    private void initAgain() {
        try {
            init();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    /** {@inheritDoc} Jason calls it when it has revised its beliefs by what was perceived. */
    @Override
    public void checkMail() {
        percepts.believed();
        super.checkMail();
        recorder.ifPresent(Recorder::watch);
        inbox.handOn();
    }

    @Override
    public void reasoningCycleFinished() {
        super.reasoningCycleFinished();
        recorder.ifPresent(Recorder::cycled);
    }

    @Override
    public void act(ActionExec action) {
        router.act(action);
    }

    /** {@inheritDoc} To an RF address, if no local agent has that name. */
    @Override
    public void sendMsg(Message message) throws Exception {
        Optional<Intentions.Waiting> waiting = waiting(message);
        try {
            super.sendMsg(message);
        } catch (ReceiverNotFoundException e) {
            if (device().isEmpty() || Destinations.find(message.getReceiver()).isEmpty()) {
                intentions.forget(message.getMsgId());
                throw e;
            }
            sendByRadio(message, waiting);
        }
    }

    private Optional<Intentions.Waiting> waiting(Message message) throws JasonException {
        try {
            return message.isAsk() ? intentions.waiting(message.getMsgId()) : Optional.empty();
        } catch (JasonException e) {
            intentions.forget(message.getMsgId());
            throw e;
        }
    }

    private void sendByRadio(Message message, Optional<Intentions.Waiting> waiting) throws JasonException {
        Device device = requireDevice(BoardName.MAIN);
        Optional<IncomingQuestion> question = IncomingQuestion.of(message.getInReplyTo());
        if (message.isAsk()) {
            questions.ask(message, waiting, device);
        } else if (question.isPresent()) {
            outbox.answer(message, question.get(), device);
        } else {
            outbox.post(OutgoingMessage.of(message, questions::next), device);
        }
    }

    @Override
    public boolean canSleep() {
        return super.canSleep() && inbox.isEmpty() && percepts.knows(perceivedHere());
    }

    /**
     * {@inheritDoc} Waits until the port is free, so that the agent can be started anew. Jason stops the architectures
     * behind by itself.
     */
    @Override
    public void stop() {
        timer.execute(() -> {
            timer.close();
            services.forEach(BoardService::stop);
        });
        CompletableFuture<Void> closed;
        synchronized (ending) {
            ended = true;
            closed = CompletableFuture
                    .allOf(boards.values().stream().map(Device::close).toArray(CompletableFuture[]::new));
        }
        ExclusivePort.await(closed, time);
    }

    /** {@inheritDoc} Adds what came from the board, and what was dropped. */
    @Override
    public Map<String, Object> getStatus() {
        Map<String, Object> status = super.getStatus();
        status.put("openness", openness().atom());
        status.put("rfMessages", inbox.received());
        status.put("rfMessagesMalformed", inbox.malformed());
        status.put("rfMessagesRefused", inbox.refused());
        status.put("hostMessagesRefused", hosts.refused());
        services.forEach(service -> status.putAll(service.status()));
        status.put("rfDelivered", outbox.ended(Outcome.DELIVERED));
        status.put("rfUndelivered", outbox.ended(Outcome.UNDELIVERED));
        device().ifPresent(board -> {
            status.put("port", board.port());
            status.put("portOn", board.isOnline());
            status.put("hostMessagesNotSent", board.sender().notSent());
        });
        status.put("perceptsMalformed", boards.values().stream().mapToLong(Device::malformedPercepts).sum());
        return status;
    }

    private CombinedPercepts.Now perceivedHere() {
        return new CombinedPercepts.Now(boards.values().stream().map(Device::perceived).toList(),
                infrastructures.belief(byRadio()));
    }

    private Set<Ability> byRadio() {
        if (!device().map(Device::communicates).orElse(false)) {
            return Set.of();
        }
        boolean mobile = moves.map(MoveService::admits).orElse(false);
        return mobile ? Set.of(Ability.COM, Ability.MOB) : Set.of(Ability.COM);
    }

    private JasonException noPort(String board) {
        boolean main = board.equals(BoardName.MAIN);
        return new Failure("no_port", "agent " + getAgName() + " has no board " + (main ? "yet" : board)
                + "; open one with .port, such as .port(\"/dev/ttyACM0\"" + (main ? ")" : ", " + board + ")"))
                .toException();
    }

    /** Asks the board in any case; waits for its answer only if it is there. */
    private CompletableFuture<Void> whereThere(Function<Device, CompletableFuture<Void>> request) {
        Optional<CompletableFuture<Void>> answer = device().map(request);
        boolean waiting = device().map(Device::isOnline).orElse(false);
        return waiting ? answer.get() : CompletableFuture.completedFuture(null);
    }

    /**
     * Makes an event without a belief, as what happens to messages is not to fill the belief base (Jason: a signal).
     * For any thread.
     */
    public void signal(Literal literal) {
        Event event = new Event(new Trigger(Trigger.TEOperator.add, Trigger.TEType.belief, literal),
                Intention.EmptyInt);
        getTS().runAtBeginOfNextCycle(() -> getTS().updateEvents(event));
        getTS().getAgArch().wakeUpDeliberate();
    }

    private void wakeAgent() {
        getTS().getAgArch().wakeUpSense();
    }
}
