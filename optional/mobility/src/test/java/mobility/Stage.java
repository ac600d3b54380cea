package mobility;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.logging.Level;
import java.util.logging.Logger;

import jason.architecture.AgArch;
import jason.asSemantics.ActionExec;
import jason.asSemantics.Agent;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Term;
import jason.runtime.Settings;
import jason.util.Config;

import diffuser.report.Failure;

/** An agent whose cycles the test runs, and which tells the test by its actions. */
final class Stage extends AgArch {

    private static final long serialVersionUID = 1L;

    private static final Logger LOG = Logger.getLogger("jason");

    static {
        Config.get().setProperty(Config.START_WEB_MI, "false");
        // Its complaints of goals without plans are what some tests are about.
        LOG.setLevel(Level.OFF);
    }

    /** Actions that the agent has done. */
    final transient List<String> done = new ArrayList<>();
    final transient TransitionSystem ts;
    /** The intention that has said {@code mobility.leave}. */
    transient Intention mover;

    private Stage(Agent agent) throws Exception {
        ts = new TransitionSystem(agent, null, new Settings(), this);
        agent.setTS(ts);
        agent.initAg();
        insertAgArch(this);
    }

    /** Puts an architecture in front. */
    <A extends AgArch> A front(A arch) {
        insertAgArch(arch);
        arch.setTS(ts);
        return arch;
    }

    static Stage of(String program) {
        try {
            Agent agent = new Agent();
            Stage stage = new Stage(agent);
            agent.parseAS(new StringReader(program), "test.asl");
            agent.loadInitialAS(null);
            return stage;
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    /** An agent as its texts make it. */
    static Stage of(Image image) throws RefusedException {
        return of(AgentStateReader.read(image), new Agent());
    }

    static Stage of(AgentState mind, Agent agent) {
        return of(mind, agent, Optional.empty());
    }

    /** @param why it was to leave and has stayed. */
    static Stage of(AgentState mind, Agent agent, Optional<Failure> why) {
        try {
            Stage stage = new Stage(agent);
            agent.loadInitialAS(null);
            mind.enter(stage.ts, why);
            return stage;
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    Stage run(int cycles) {
        for (int i = 0; i < cycles; i++) {
            ts.reasoningCycle();
        }
        return this;
    }

    /** Runs until it has done so much, and no further for some cycles. */
    Stage untilDone(int much) {
        for (int i = 0; i < 60_000 && done.size() < much; i++) {
            ts.reasoningCycle();
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
        }
        return run(5);
    }

    /** Runs until an intention says {@code mobility.leave}, and writes the agent as it is then. */
    Image leave() throws Exception {
        mover = null;
        for (int i = 0; i < 1000 && mover == null; i++) {
            ts.reasoningCycle();
            mover = ts.getC().getPendingIntentions().get("leave");
        }
        return AgentStateWriter.write(ts, mover);
    }

    /** The agent when it has left and arrived, its texts having been looked at. */
    Stage moved() throws Exception {
        Image image = leave();
        Stage there = of(image);
        Image again = AgentStateWriter.write(there.ts, null);
        org.junit.jupiter.api.Assertions.assertEquals(image.program(), again.program());
        // There it is an intention as any other.
        org.junit.jupiter.api.Assertions.assertEquals(image.state().replaceAll("(?m)^M$", "I"), again.state());
        return there;
    }

    @Override
    public String getAgName() {
        return "traveller";
    }

    @Override
    public boolean isRunning() {
        return true;
    }

    @Override
    public void act(ActionExec action) {
        if (action.getActionTerm().getFunctor().equals("hang")) {
            return;
        }
        StringBuilder text = new StringBuilder();
        for (Term term : action.getActionTerm().getTerms() == null ? List.<Term>of()
                : action.getActionTerm().getTerms()) {
            text.append(text.isEmpty() ? "" : " ")
                    .append(term instanceof StringTerm string ? string.getString() : term.toString());
        }
        done.add(action.getActionTerm().getFunctor() + (text.isEmpty() ? "" : " " + text));
        action.setResult(!action.getActionTerm().getFunctor().equals("stumble"));
        ts.getC().addFeedbackAction(action);
    }
}
