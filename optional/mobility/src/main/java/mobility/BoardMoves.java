package mobility;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

import jason.asSemantics.TransitionSystem;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;
import jason.bb.BeliefBase;

import diffuser.BoardService;
import diffuser.Diffuser;
import diffuser.board.BoardName;
import diffuser.board.MoveService;
import diffuser.gate.Policy;
import diffuser.gate.Provenance;
import diffuser.mind.Intentions;
import diffuser.report.Failure;

import javino.board.Transitions;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.Outcome;

/** The moves by one agent's board: what {@link Moves} decides, this does in the MAS around it. */
public final class BoardMoves implements BoardService, MoveService, Mas {

    /** Between two looks at whether a plan lets agents in. */
    private static final long LOOK_NANOS = Duration.ofSeconds(1).toNanos();

    private final Diffuser diffuser;
    private final Time time;
    private final Time.Timer clock;
    private final LocalAgents inhabitants;
    private final MoveInRequest admission;
    private Moves moves;
    private MoveStore folder;
    private boolean admits;
    private long looked;

    /** Found by Java's {@link java.util.ServiceLoader}. */
    public static final class Maker implements BoardService.Maker {

        @Override
        public BoardService of(Diffuser diffuser) {
            return new BoardMoves(diffuser);
        }
    }

    private BoardMoves(Diffuser diffuser) {
        this.diffuser = diffuser;
        time = diffuser.time();
        clock = diffuser.timer();
        inhabitants = new LocalAgents(diffuser);
        admission = new MoveInRequest(diffuser);
        looked = time.nanos() - 2 * LOOK_NANOS;
        if (!MoveStore.records(place()).isEmpty() || !MoveStore.unreadable(place()).isEmpty()) {
            boolean away = LocalAgents.isAway(name());
            if (away) {
                Mobile.empty(ts());
                Mobile.of(ts()).fallAsleep();
            }
            // As soon as the agent runs, the MAS has all its agents.
            ts().runAtBeginOfNextCycle(() -> clock.execute(() -> begin(away)));
        }
    }

    /** @param boardOnly the agent itself is away, and so cannot open its port. */
    private void begin(boolean boardOnly) {
        opened();
        if (boardOnly) {
            folder.board((port, address) -> Intentions.inNextCycle(ts(), () -> {
                diffuser.openPort(port, BoardName.MAIN);
                diffuser.setRfId(address);
                diffuser.openRadio(true);
            }));
        }
    }

    private TransitionSystem ts() {
        return diffuser.getTS();
    }

    private String name() {
        return ts().getAgArch().getAgName();
    }

    private Path place() {
        return LocalAgents.folder(name(), ts().getSettings());
    }

    /** On the thread of the moves. The folder is made when it is needed for the first time. */
    private Moves opened() {
        if (moves == null) {
            folder = new MoveStore(place(), time);
            moves = new Moves(clock, folder, this, inhabitants.limits(), time.secureRandom());
            moves.start();
        }
        return moves;
    }

    // Requests of the agents

    /**
     * Moves an agent that sleeps, or is cloned.
     *
     * @return completes with its name there; fails with what {@link Failure#of} reads.
     */
    CompletableFuture<String> depart(String agent, Protocol protocol, Address to, List<Bytes> texts) {
        return CompletableFuture.supplyAsync(() -> {
            Optional<Address> here = diffuser.address();
            if (!diffuser.hasRadio() || here.isEmpty()) {
                return CompletableFuture.<String>failedFuture((diffuser.hasRadio()
                        ? new Failure("no_rf_id", "the board has no address yet; set one with .setMyRFId")
                        : new Failure("no_radio", "agents move by a board's radio, which this one has not"))
                        .toException());
            }
            try {
                Moves all = opened();
                if (agent.equals(name())) {
                    folder.keepBoard(String.valueOf(diffuser.getStatus().get("port")), here.get());
                }
                return all.depart(agent, protocol, here.get(), to, texts);
            } catch (UncheckedIOException e) {
                return CompletableFuture.<String>failedFuture(
                        new Failure("disk", e.getCause().getMessage()).toException());
            }
        }, clock).thenCompose(end -> end);
    }

    // Calls of the board

    @Override
    public Set<HostMessage.Use> uses() {
        return Set.of(HostMessage.Use.MOVE);
    }

    @Override
    public void received(Address from, HostMessage message) {
        clock.execute(() -> opened().received(from, message));
    }

    @Override
    public boolean admits() {
        if (time.nanos() - looked > LOOK_NANOS) {
            looked = time.nanos();
            admits = admission.isThere();
        }
        return admits;
    }

    @Override
    public Map<String, Object> status() {
        Moves known = moves;
        return BoardService.status("moves", Moves.Count.class, count -> known == null ? 0 : known.counts.of(count));
    }

    @Override
    public void stop() {
        if (moves != null) {
            moves.close();
            folder.close();
        }
    }

    // Air

    @Override
    public CompletableFuture<Outcome> send(Address to, HostMessage message) {
        return diffuser.transmit(to, message).end();
    }

    // MAS

    @Override
    public CompletableFuture<Void> admit(Move move, boolean returns) {
        boolean away = Mobile.find(ts()).filter(Mobile::isAsleep).isPresent();
        boolean itself = away && move.protocol() == Protocol.MUTUALISM && move.name().equals(name());
        Provenance of = move.provenance(diffuser.peer(move.key().peer()), here(), returns).whileAway(away);
        Policy.Decision decision = Policy.decide(itself ? Policy.Act.RETURN : Policy.Act.OFFER, of);
        return switch (decision.verdict()) {
            case ALLOWED -> CompletableFuture.completedFuture(null);
            case IF_A_PLAN_ASKS -> admission.ask(move, of, decision);
            default -> CompletableFuture.failedFuture(new RefusedException("refused", decision.reason()));
        };
    }

    @Override
    public Optional<Address> here() {
        return diffuser.address();
    }

    /** Whether an agent that lives here has come by this board. On any thread. */
    boolean hasBrought(String agent) {
        return MoveStore.records(place()).stream()
                .anyMatch(move -> move.state() == Move.State.HERE && move.name().equals(agent));
    }

    @Override
    public void check(List<Bytes> texts) throws RefusedException {
        LocalAgents.read(texts);
    }

    @Override
    public void wake(Move move, List<Bytes> texts, boolean anew, Consumer<String> named) {
        if (move.isOurs()) {
            remove(move);
        }
        inhabitants.settle(move, texts, folder.records(), Optional.empty(), name -> {
            named.accept(name);
            if (!anew) {
                tell("movedIn", name, move.key().peer());
            }
        });
    }

    @Override
    public void left(Move move) {
        remove(move);
        if (move.name().equals(name())) {
            Intentions.inNextCycle(ts(), diffuser::closeNamed);
        }
        tell("movedOut", move.name(), move.key().peer());
    }

    @Override
    public void stays(Move move, List<Bytes> texts, Failure why) {
        remove(move);
        inhabitants.settle(move, texts, folder.records(), Optional.of(why), name -> {});
    }

    /** Ends what sleeps here of an agent that has left or comes back, unless another of its name is on its way. */
    private void remove(Move move) {
        boolean another = folder.records().stream().anyMatch(each -> each.name().equals(move.name())
                && !each.key().equals(move.key()) && each.isUnderWay());
        if (!another) {
            inhabitants.remove(move.name());
        }
    }

    /** An agent has ended that was awake. For any thread. */
    void ended(String agent) {
        clock.execute(() -> {
            if (moves != null) {
                moves.ended(agent);
            }
        });
    }

    @Override
    public boolean starts(String agent) {
        return LocalAgents.isOfProgram(agent);
    }

    @Override
    public void progress(String agent, Address peer, boolean out, int percent) {
        tell(out ? "movingOut" : "movingIn", agent, peer, ASSyntax.createNumber(percent));
    }

    @Override
    public void reached(String machine, Address peer, String id, Enum<?> state) {
        here().ifPresent(here -> Transitions.log(machine, here, peer, id, state));
    }

    @Override
    public void warn(String what) {
        ts().getLogger().warning(what);
    }

    private void tell(String what, String agent, Address peer, Term... more) {
        Literal event = ASSyntax.createLiteral(what, ASSyntax.createAtom(agent), ASSyntax.createString(peer));
        event.addTerms(more);
        event.addAnnot(BeliefBase.TPercept);
        diffuser.signal(event);
    }
}
