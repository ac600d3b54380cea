package mobility;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.StreamSupport;

import jason.JasonException;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;
import jason.bb.BeliefBase;
import jason.infra.local.BaseLocalMAS;
import jason.infra.local.LocalAgArch;

import diffuser.mind.Intentions;
import diffuser.report.Failure;

import javino.protocol.Address;
import javino.protocol.Bytes;

/** The action {@code .moveOut} in the MAS that agents leave. */
public final class Departures {

    private static final AtomicLong COUNT = new AtomicLong();

    private Departures() {
    }

    /**
     * Begins to move agents, and suspends the intention that says so.
     *
     * @param ts the agent's that says so, on its thread.
     * @throws JasonException if none of them leaves; then nothing has changed.
     */
    public static void begin(TransitionSystem ts, Address to, Protocol protocol, List<String> agents)
            throws JasonException {
        BoardMoves moves = door(ts);
        String self = ts.getAgArch().getAgName();
        if (ts.getAg() instanceof GuestAgent && !agents.equals(List.of(self))) {
            throw new Failure("guest", self + " is a guest here, and moves none but itself").toException();
        }
        List<LocalAgArch> others = new ArrayList<>();
        for (String agent : agents) {
            LocalAgArch arch = Optional.ofNullable(BaseLocalMAS.getRunner().getAg(agent)).orElseThrow(
                    () -> new Failure("no_agent", "this MAS has no agent " + agent).toException());
            expectMobile(arch, protocol);
            if (!agent.equals(self)) {
                others.add(arch);
            }
        }
        boolean also = agents.contains(self);
        Intention mover = ts.getC().getSelectedIntention();
        // Before anything is sent: what cannot travel is said now.
        Image image = also ? image(ts, mover, protocol) : null;
        String key = "moveOut/javino/" + COUNT.incrementAndGet();
        Intentions.await(ts.getC(), key);
        List<CompletableFuture<String>> ends = new ArrayList<>();
        others.forEach(other -> ends.add(move(moves, other.getTS(), protocol, to)));
        if (also) {
            ends.add(depart(moves, ts, protocol, to, image));
        }
        CompletableFuture.allOf(ends.toArray(CompletableFuture[]::new)).whenComplete((done, thrown) -> {
            if (thrown == null) {
                Intentions.resume(ts, key);
            } else {
                Intentions.fail(ts, key, Failure.of(thrown));
            }
        });
    }

    private static BoardMoves door(TransitionSystem ts) throws JasonException {
        return LocalAgents.door(ts.getAgArch())
                .orElseThrow(() -> new Failure("no_diffuser", "no agent of this MAS has a board by which "
                        + ts.getAgArch().getAgName() + " could move; give one the architecture diffuser.Diffuser")
                        .toException());
    }

    /** An agent that the program starts must know, when it is started again, that it is away. */
    private static void expectMobile(LocalAgArch agent, Protocol protocol) throws JasonException {
        boolean mobile = protocol == Protocol.CLONING || !LocalAgents.isOfProgram(agent.getAgName())
                || Mobile.find(agent.getTS()).isPresent() || LocalAgents.board(agent.getFirstAgArch()).isPresent();
        if (!mobile) {
            throw new Failure("not_mobile", "agent " + agent.getAgName() + " cannot move: give it the architecture"
                    + " mobility.Mobile (agentArchClass in a .mas2j, ag-arch in a .jcm), so that it is not started a"
                    + " second time while it is away").toException();
        }
    }

    /** Another agent of this MAS, in its next cycle. */
    private static CompletableFuture<String> move(BoardMoves moves, TransitionSystem ts, Protocol protocol,
            Address to) {
        return CompletableFuture.supplyAsync(() -> {
            try {
                return depart(moves, ts, protocol, to, image(ts, null, protocol));
            } catch (JasonException e) {
                return CompletableFuture.<String>failedFuture(e);
            }
        }, step -> Intentions.inNextCycle(ts, step)).thenCompose(end -> end);
    }

    /** @throws JasonException cannot_travel, if something holds the agent here. */
    private static Image image(TransitionSystem ts, Intention mover, Protocol protocol) throws JasonException {
        Optional<Literal> role = protocol == Protocol.CLONING ? Optional.empty() : role(ts);
        if (role.isPresent()) {
            throw new Failure("cannot_travel", ts.getAgArch().getAgName() + " cannot travel: it plays the role "
                    + role.get().getTerm(1) + " in the group " + role.get().getTerm(2)
                    + " of an organisation; let it call leaveRole first").toException();
        }
        return AgentStateWriter.write(ts, mover);
    }

    /** As JaCaMo's groups tell it to who plays a role there: {@code play(Agent,Role,Group)}. */
    private static Optional<Literal> role(TransitionSystem ts) {
        Term self = ASSyntax.createAtom(ts.getAgArch().getAgName());
        return StreamSupport.stream(ts.getAg().getBB().spliterator(), false)
                .filter(belief -> belief.getFunctor().equals("play") && belief.getArity() == 3
                        && belief.getTerm(0).equals(self) && belief.hasAnnot(BeliefBase.TPercept)
                        && !belief.getAnnots("artifact_id").isEmpty())
                .findFirst();
    }

    private static CompletableFuture<String> depart(BoardMoves moves, TransitionSystem ts, Protocol protocol,
            Address to, Image image) {
        boolean sleeps = protocol != Protocol.CLONING;
        if (sleeps) {
            Mobile.of(ts).fallAsleep();
        }
        String agent = ts.getAgArch().getAgName();
        // The records of the board by which it came tell its home.
        Optional<BoardMoves> bringer = LocalAgents.bringer(agent);
        CompletableFuture<String> end = bringer.isEmpty() && ts.getAg() instanceof GuestAgent
                ? CompletableFuture.failedFuture(GuestAgent.failure(".moveOut without a record").toException())
                : bringer.orElse(moves).depart(agent, protocol, to,
                        List.of(Bytes.ofText(image.program()), Bytes.ofText(image.state())));
        return end.whenComplete((name, thrown) -> {
            if (sleeps && thrown != null) {
                Intentions.inNextCycle(ts, () -> Mobile.of(ts).awaken());
            }
        });
    }
}
