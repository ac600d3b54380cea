package lockstep.agents;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;

import diffuser.Diffuser;
import diffuser.gate.Plans;

import jason.JasonException;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Plan;
import jason.asSyntax.SourceInfo;
import jason.asSyntax.Trigger;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.TokenMgrError;
import jason.infra.local.BaseLocalMAS;

import lockstep.AgentProgram;

/** The agents that a launcher of Jason's runs, in threads of their own or not. */
public final class RunningAgents implements AgentProgram.Agents {

    private static final String FROM_A_BOARD_ACTION = "/javino/";

    private final BaseLocalMAS mas;

    public RunningAgents(BaseLocalMAS mas) {
        this.mas = mas;
    }

    @Override
    public Set<String> agents() {
        return new TreeSet<>(mas.getAgs().keySet());
    }

    private TransitionSystem of(String agent) {
        return mas.getAg(agent).getTS();
    }

    @Override
    public String busy(String agent) {
        Circumstance circumstance = of(agent).getC();
        Stream<String> asked = circumstance.getPendingIntentions().keySet().stream()
                .filter(key -> key.contains(FROM_A_BOARD_ACTION)).map(key -> "." + key.replaceFirst("/.*", ""));
        Stream<String> acting = circumstance.getPendingActions().values().stream()
                .map(action -> action.getActionTerm().toString());
        return Stream.concat(asked, acting).sorted().findFirst().map(each -> each + " goes on")
                .orElse(of(agent).canSleep() ? "" : "its plans go on");
    }

    @Override
    public Map<String, String> planned(String agent) {
        Map<String, String> planned = new TreeMap<>();
        for (Plan plan : Plans.of(of(agent).getAg())) {
            Trigger trigger = plan.getTrigger();
            SourceInfo place = plan.getSrcInfo();
            if (trigger.getType() == Trigger.TEType.belief && trigger.isAddition() && place != null
                    && !trigger.getLiteral().isVar()) {
                planned.putIfAbsent(trigger.getLiteral().getPredicateIndicator().toString(),
                        place.getSrcFile().replaceFirst("^(.*/|file:)+", "") + ":" + place.getBeginSrcLine());
            }
        }
        return planned;
    }

    @Override
    public void give(String agent, String event) throws IOException {
        Trigger trigger;
        try {
            trigger = ASSyntax.parseTrigger(event);
        } catch (ParseException | TokenMgrError e) {
            throw new IOException(event + " is no goal or belief: " + e.getMessage().lines().findFirst().orElse(""), e);
        }
        TransitionSystem to = of(agent);
        to.runAtBeginOfNextCycle(() -> give(to, trigger));
        mas.getAg(agent).wake();
    }

    /** On the agent's own thread. */
    private static void give(TransitionSystem to, Trigger trigger) {
        try {
            if (trigger.getType() == Trigger.TEType.achieve) {
                to.getC().addEvent(new Event(trigger, Intention.EmptyInt));
            } else if (trigger.isAddition()) {
                to.getAg().addBel(trigger.getLiteral());
            } else {
                to.getAg().delBel(trigger.getLiteral());
            }
        } catch (JasonException e) {
            to.getLogger().warning(trigger + ": " + e.getMessage());
        }
    }

    @Override
    public CompletableFuture<Map<String, Object>> counts(String agent) {
        Map<String, Object> counts = new TreeMap<>();
        Optional<Diffuser> diffuser = Diffuser.find(mas.getAg(agent).getFirstAgArch());
        if (diffuser.isEmpty()) {
            return CompletableFuture.completedFuture(counts);
        }
        counts.putAll(diffuser.get().getStatus());
        return diffuser.get().counters().handle((board, none) -> {
            if (board != null) {
                board.forEach((counter, value) -> counts.put(counter.toString(), value));
            }
            return counts;
        });
    }
}
