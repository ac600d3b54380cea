package mobility;

import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;

import jason.architecture.AgArch;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Event;
import jason.asSemantics.TransitionSystem;
import jason.infra.local.BaseLocalMAS;
import jason.infra.local.LocalAgArch;
import jason.mas2j.AgentParameters;
import jason.runtime.RuntimeServices;
import jason.runtime.RuntimeServicesFactory;
import jason.runtime.Settings;

import diffuser.Diffuser;
import diffuser.mind.Intentions;
import diffuser.report.Failure;

import javino.link.Time;
import javino.protocol.Bytes;
import javino.protocol.ProtocolException;

/** The agents of the MAS: makes those that come, ends those that have gone. */
record LocalAgents(Diffuser diffuser) {

    private static final String FOLDER = "moves";
    private static final String ARCHITECTURES = "newcomers";
    private static final String LENGTH = "movesLength";
    private static final String AGENTS = "movesAgents";
    /** For Jason to end an agent; far more than it takes. */
    private static final long END_NANOS = Duration.ofSeconds(5).toNanos();
    private static final long LOOK_NANOS = Duration.ofMillis(1).toNanos();
    /** Set while an agent is made here, which is not away, whatever its record says. */
    private static final ThreadLocal<Boolean> MAKING = ThreadLocal.withInitial(() -> false);

    /** The folder for the moves of an agent's board, as its {@code .mas2j} says, or by default. */
    static Path folder(String agent, Settings settings) {
        return Path.of(parameter(settings, FOLDER).orElse(FOLDER + "/" + agent));
    }

    private static Optional<String> parameter(Settings settings, String name) {
        return Optional.ofNullable(settings.getUserParameter(name))
                .map(text -> text.replaceAll("^\"(.*)\"$", "$1"));
    }

    /** The limits of the MAS, as the {@code .mas2j} says; by default where it says no number. */
    Moves.Limits limits() {
        return new Moves.Limits(number(LENGTH, Moves.Limits.USUAL.length()),
                (int) number(AGENTS, Moves.Limits.USUAL.agents()));
    }

    private long number(String option, long usual) {
        String given = parameter(diffuser.getTS().getSettings(), option).orElse("" + usual);
        if (given.matches("\\d{1,9}")) {
            return Long.parseLong(given);
        }
        diffuser.getTS().getLogger().warning("the option " + option + " is no number: " + given + "; " + usual
                + " is taken");
        return usual;
    }

    static AgentState read(List<Bytes> texts) throws RefusedException {
        if (texts.size() != 2) {
            throw new RefusedException("damaged", "an agent has two texts, not " + texts.size());
        }
        try {
            return AgentStateReader.read(new Image(texts.get(0).text(), texts.get(1).text()));
        } catch (ProtocolException e) {
            throw new RefusedException("damaged", e.getMessage());
        }
    }

    /**
     * Lets an agent live here.
     *
     * @param records the records of all moves.
     * @param why     the failure of its plan, if it was to leave and stays.
     * @param named   is told the name that it gets, before it does anything.
     */
    void settle(Move move, List<Bytes> texts, List<Move> records, Optional<Failure> why, Consumer<String> named) {
        boolean guest = move.isGuest(records);
        try {
            AgentState state = read(texts);
            boolean isPredator = move.protocol() == Protocol.PREDATION && !move.key().out();
            if (isPredator) {
                endOthers();
            }
            if (isPredator || move.isOurs() && move.name().equals(own()) && !guest) {
                named.accept(own());
                takeBody(state, why);
                return;
            }
            RuntimeServices services = RuntimeServicesFactory.get();
            // A guest has nothing of what its program had here.
            Optional<AgentParameters> ours = parameters(move.name()).filter(known -> move.isOurs() && !guest);
            MAKING.set(true);
            String name = services.createAgent(freeName(move, records), null,
                    guest ? GuestAgent.class.getName() : ours.map(known -> known.agClass.getClassName()).orElse(null),
                    architectures(ours, guest), null, ours.map(LocalAgents::settings).orElseGet(Settings::new), null);
            enter(state, agent(name).orElseThrow().getTS(), why);
            named.accept(name);
            services.startAgent(name);
        } catch (RefusedException e) {
            throw new IllegalStateException("what was checked can be read no longer: " + e.getMessage(), e);
        } catch (Exception e) {
            throw new IllegalStateException("the agent " + move.name() + " cannot live here: " + e.getMessage(), e);
        } finally {
            MAKING.remove();
        }
    }

    /** A newcomer takes the name of no agent that is away; Jason sees to those that are here. */
    private static String freeName(Move move, List<Move> records) {
        String name = move.name();
        for (int i = 1; isTaken(name, move, records); i++) {
            name = move.name() + "_" + i;
        }
        return name;
    }

    private static boolean isTaken(String name, Move move, List<Move> records) {
        return !move.isOurs() && (isOfProgram(name)
                || records.stream().anyMatch(other -> other.isUnderWay() && other.name().equals(name)));
    }

    private List<String> architectures(Optional<AgentParameters> ours, boolean guest) {
        List<String> all = new ArrayList<>(List.of(Mobile.class.getName()));
        if (ours.isPresent()) {
            return new ArrayList<>(ours.get().getAgArchClasses());
        }
        if (!guest) {
            parameter(diffuser.getTS().getSettings(), ARCHITECTURES)
                    .ifPresent(more -> all.addAll(List.of(more.trim().split("\\s*,\\s*"))));
        }
        return all;
    }

    /**
     * Lets a state enter an agent. An architecture may have a goal before all others already, as that of JaCaMo has to
     * focus on artifacts. Jason has one place for such a goal, in which the state's own would replace it: then it waits
     * its turn.
     */
    private static void enter(AgentState state, TransitionSystem ts, Optional<Failure> why) {
        Circumstance circumstance = ts.getC();
        Event first = circumstance.removeAtomicEvent();
        state.enter(ts, why);
        if (first != null) {
            if (circumstance.hasAtomicIntention() || circumstance.getAtomicEvent() != null) {
                first.getIntention().setAtomic(0);
            }
            circumstance.addEvent(first);
        }
    }

    /** As the program says, for its architectures as well: JaCaMo's have from there what the agent focuses on. */
    private static Settings settings(AgentParameters ours) {
        Settings settings = ours.getAsSetts(false, false);
        // It comes with a state.
        settings.removeUserParameter(Settings.INIT_BELS);
        settings.removeUserParameter(Settings.INIT_GOALS);
        return settings;
    }

    private String own() {
        return diffuser.getTS().getAgArch().getAgName();
    }

    private void endOthers() throws RemoteException {
        RuntimeServices services = RuntimeServicesFactory.get();
        for (String other : List.copyOf(services.getAgentsNames())) {
            if (!other.equals(own())) {
                services.killAgent(other, own(), 0);
            }
        }
    }

    /** A state lives on in the agent with the board, in the place of what was there. */
    private void takeBody(AgentState state, Optional<Failure> why) {
        Intentions.inNextCycle(diffuser.getTS(), () -> {
            Mobile.find(diffuser.getTS()).ifPresent(Mobile::awaken);
            Mobile.empty(diffuser.getTS());
            if (why.isEmpty()) {
                diffuser.closeNamed();
            }
            state.enter(diffuser.getTS(), why);
            Mobile.perceiveAnew(diffuser.getTS());
        });
    }

    /** Ends an agent that sleeps: one that has moved away, or that was not to start. */
    void remove(String name) {
        agent(name).map(LocalAgArch::getTS).filter(asleep -> asleep != diffuser.getTS()
                && Mobile.find(asleep).filter(Mobile::isAsleep).isPresent()).ifPresent(asleep -> {
                    try {
                        RuntimeServicesFactory.get().killAgent(name, name, 0);
                    } catch (RemoteException e) {
                        throw new IllegalStateException(e);
                    }
                    awaitEnd(name);
                });
    }

    /** Jason ends an agent on a thread of its own; until then another one of that name would get a new name. */
    private void awaitEnd(String name) {
        Time time = diffuser.time();
        long end = time.nanos() + END_NANOS;
        while (agent(name).isPresent() && time.nanos() < end) {
            time.pause(LOOK_NANOS);
        }
    }

    /** Whether the records say that an agent which the program starts is elsewhere, or is to be made anew. */
    static boolean isAway(String name) {
        return !MAKING.get() && isOfProgram(name) && project().stream()
                .filter(each -> each.getAgArchClasses().stream().anyMatch(LocalAgents::isDiffuser))
                .anyMatch(each -> isAway(name, each.name, folder(each.name, each.getAsSetts(false, false))));
    }

    private static boolean isAway(String name, String door, Path records) {
        // Any of them may be about this agent, but about the one with the board only if it has ever left.
        boolean unknown =
                !MoveStore.unreadable(records).isEmpty() && (!name.equals(door) || MoveStore.hasBoard(records));
        return unknown || MoveStore.records(records).stream()
                // Under whatever name it may live here since it came back.
                .anyMatch(move -> move.isOurs() && List.of(move.name(), move.identity().name()).contains(name)
                        && move.state() != Move.State.READY && move.state() != Move.State.LEFT);
    }

    private static boolean isDiffuser(String architecture) {
        try {
            return Diffuser.class.isAssignableFrom(Class.forName(architecture));
        } catch (ClassNotFoundException e) {
            return false;
        }
    }

    /** Whether the program of the MAS has an agent of that name. */
    static boolean isOfProgram(String name) {
        return parameters(name).isPresent();
    }

    private static Optional<AgentParameters> parameters(String name) {
        return project().stream().filter(each -> each.name.equals(name)
                || each.getNbInstances() > 1 && name.matches(each.name + "\\d+")).findFirst();
    }

    /** The agents that the program of the MAS starts; none where there is no program, as in tests. */
    static List<AgentParameters> project() {
        BaseLocalMAS mas = BaseLocalMAS.getRunner();
        return mas == null || mas.getProject() == null ? List.of() : mas.getProject().getAgents();
    }

    private static Optional<LocalAgArch> agent(String name) {
        return Optional.ofNullable(BaseLocalMAS.getRunner()).map(mas -> mas.getAg(name));
    }

    /** The board by which an agent moves: its own, or that of the first one of this MAS that has one. */
    static Optional<BoardMoves> door(AgArch first) {
        return board(first)
                .or(() -> all(BaseLocalMAS.getRunner()).filter(moves -> moves.here().isPresent()).findFirst());
    }

    /** By its own board. */
    static Optional<BoardMoves> board(AgArch first) {
        return Diffuser.find(first).flatMap(each -> each.service(BoardMoves.class));
    }

    /** An agent that was awake has ended; where the MAS goes on, it tells those by whose board it may have come. */
    static void ended(String name) {
        BaseLocalMAS mas = BaseLocalMAS.getRunner();
        if (mas != null && mas.isRunning()) {
            all(mas).forEach(moves -> moves.ended(name));
        }
    }

    /** The board by which an agent that lives here has come; none if it is from here. */
    static Optional<BoardMoves> bringer(String name) {
        return all(BaseLocalMAS.getRunner()).filter(moves -> moves.hasBrought(name)).findFirst();
    }

    private static Stream<BoardMoves> all(BaseLocalMAS mas) {
        return mas.getAgs().entrySet().stream().sorted(Map.Entry.comparingByKey())
                .flatMap(each -> board(each.getValue().getFirstAgArch()).stream());
    }
}
