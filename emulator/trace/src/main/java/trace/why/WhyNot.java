package trace.why;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.protocol.Counter;
import trace.TraceEvent;

/** Why something did not happen to an agent. */
final class WhyNot {

    private static final Set<Counter> DROPS = Set.of(Counter.RADIO_DAMAGED, Counter.RADIO_MISSED,
            Counter.RADIO_BAD_FRAMES, Counter.RADIO_RESERVED, Counter.RADIO_NOT_FOR_US, Counter.RADIO_OWN,
            Counter.RADIO_NO_KEY, Counter.RADIO_BAD_TAG, Counter.RADIO_REPLAYED, Counter.RADIO_REPLAY_FULL,
            Counter.RADIO_QUEUE_FULL, Counter.RADIO_REPEATS, Counter.RADIO_FRAGMENTS_DROPPED, Counter.RADIO_EXPIRED,
            Counter.RADIO_STALE, Counter.RADIO_BLOCKED, Counter.RADIO_DOUBTFUL);

    private final History history;
    private final Why why;
    private final String agent;
    private final String board;
    /** The plans that were looked at: each may wait for another one's goal. */
    private final Set<String> places = new HashSet<>();

    WhyNot(History history, Why why, String agent) {
        this.history = history;
        this.why = why;
        this.agent = agent;
        board = history.boardOf(agent);
    }

    private Stream<TraceEvent> plans() {
        return history.of(agent, "agent-plan");
    }

    /** Plans with a step that may be that: {@code !} or {@code +} before the term, or nothing for an action. */
    private Stream<TraceEvent> plansWith(String operator, Term asked) {
        return plans().filter(each -> steps(operator, asked, each).anyMatch(asked::mayBe));
    }

    /** The steps of a plan that have its name. */
    private static Stream<Term> steps(String operator, Term asked, TraceEvent plan) {
        String before = operator.isEmpty() ? "(^|[;&|{] ?|act\\(\"?)" : "(?<!\\w)\\" + operator;
        String body = plan.text("body");
        return Pattern.compile(before + "(?=" + Pattern.quote(asked.functor()) + "\\b)").matcher(body).results()
                .flatMap(found -> Term.parse(body.substring(found.end())).stream());
    }

    /** Whether a plan has it as an action. */
    boolean isStep(Term action) {
        return plansWith("", action).findAny().isPresent();
    }

    /** What the agent asked its board for that is an instance. */
    Stream<TraceEvent> actions(Term action) {
        return history.of(agent, "agent-action").filter(each -> action.matches(History.parsed(each, "action")));
    }

    /** Why a pin did not change: its sketch knows; what was asked of the board last is told. */
    void pin(String of, Term asked) {
        Optional<TraceEvent> last = History.last(history.of(agent, "agent-action"));
        if (last.flatMap(history::outcome).filter(end -> !end.text("error").isEmpty()).isPresent()) {
            failed(last.get());
        } else {
            last.ifPresent(
                    each -> why.link(each, "the last action that " + agent + " asked for is " + each.text("action")));
            why.cause("no action of " + of + "'s board has changed " + asked.functor()
                    + " so" + last.map(each -> "; ask of one, such as '" + each.text("action") + "'").orElse(""));
        }
    }

    // Events and goals

    /** Why an event did not come, or has no plan; or what became of it. */
    void event(Term asked) {
        Optional<TraceEvent> event = History.last(history.events(agent, asked.sign(), asked).stream());
        if (event.isEmpty()) {
            never(asked);
            return;
        }
        Optional<TraceEvent> choice = choice(event.get());
        if (choice.filter(each -> each.has("intention")).isPresent()) {
            why.link(choice.get(), agent + " chose the plan (" + choice.get().text("place") + ")");
            if (!ran(choice.get().text("intention"), choice.get().text("place"), false)) {
                why.chain(event.get());
            }
        } else {
            why.link(event.get(), agent + " has the event " + asked.brief());
            noPlan(event.get());
        }
    }

    private Optional<TraceEvent> choice(TraceEvent event) {
        return history.of(agent, "agent-choice").filter(each -> each.number("number") == event.number("number"))
                .findFirst();
    }

    /** Why no plan was chosen for an event. */
    private void noPlan(TraceEvent event) {
        Term trigger = History.parsed(event, "trigger");
        List<Map.Entry<String, JsonObject>> asked = choice(event).map(History::asked).orElse(List.of());
        if (!asked.isEmpty()) {
            asked.forEach(each -> why.link(event, "the plan " + Why.plan(each.getValue()) + " was asked: "
                    + Why.falsePart(each.getValue())));
            why.cause(Why.falsePart(asked.get(0).getValue()));
            return;
        }
        Optional<Term> same = plans().map(each -> History.parsed(each, "trigger"))
                .filter(each -> each.sign().equals(trigger.sign()) && each.goal().equals(trigger.goal())
                        && each.matches(trigger))
                .findFirst();
        Optional<Term> nearest = History.nearest(trigger, plans().map(each -> History.parsed(each, "trigger"))
                .filter(each -> each.goal().equals(trigger.goal()) && each.sign().equals(trigger.sign())));
        if (same.isPresent()) {
            mismatch(trigger, same.get());
        } else {
            why.cause("no plan of " + agent + " is for " + trigger.brief()
                    + nearest.map(each -> "; the nearest is " + each.brief()).orElse(""));
        }
    }

    /** Why a plan with the same term is not for an event. */
    private void mismatch(Term event, Term plan) {
        Optional<String> lacking = plan.annotations().stream().filter(each -> Term.parse(each)
                .filter(mark -> event.annotations().stream().noneMatch(had -> Term.parse(had).filter(mark::matches)
                        .isPresent()))
                .isPresent()).findFirst();
        String had = lacking.flatMap(Term::parse).map(mark -> event.annotations().stream()
                .filter(each -> Term.parse(each).filter(mark::isOfKind).isPresent())
                .collect(Collectors.joining(", "))).orElse("");
        why.cause(event.term() + " has " + (had.isEmpty() ? "no " : had + ", not ")
                + lacking.orElse("values of that kind"));
    }

    private void never(Term asked) {
        if (asked.goal().isEmpty()) {
            belief(asked, Optional.empty());
            return;
        }
        if (refused(asked, Optional.empty())) {
            return;
        }
        List<TraceEvent> calling = plansWith("!", asked).filter(each -> places.add(each.text("place")))
                .toList();
        if (calling.isEmpty()) {
            why.cause("nobody gave " + agent + " the goal " + asked.term());
        } else {
            plan(calling.get(calling.size() - 1), asked);
        }
    }

    // Actions and plans

    /** Why an action of the board was not performed. */
    void action(Term asked) {
        Optional<TraceEvent> action = History.last(actions(asked));
        if (action.isPresent()) {
            failed(action.get());
            return;
        }
        List<TraceEvent> plans = plansWith("", asked).filter(each -> places.add(each.text("place")))
                .toList();
        Optional<TraceEvent> ran = plans.stream().filter(each -> !chosen(each).isEmpty()).findFirst();
        plan(ran.orElse(plans.get(0)), asked);
    }

    private void failed(TraceEvent action) {
        String what = action.text("action");
        why.link(action, agent + " asks its board for " + what);
        Optional<TraceEvent> end = history.outcome(action);
        if (end.isEmpty()) {
            why.cause(what + " waits for " + board + "'s board, which has not answered");
            return;
        }
        why.link(end.get(), end.get().text("message"));
        Optional<TraceEvent> reply = history.same(action, history.reached(agent, what).toList(),
                history.onBoard(board, "host-action").filter(each -> each.text("action").equals(what)).toList());
        boolean refused = !Ordinals.isUnreached(end.get())
                && reply.filter(each -> each.text("done").equals("false")).isPresent();
        why.cause((refused ? board + "'s board refused " + what : what + " failed") + ": " + end.get().text("error"));
    }

    private List<TraceEvent> chosen(TraceEvent plan) {
        return history.of(agent, "agent-choice").filter(each -> each.has("intention")
                && each.textOrEmpty("place").equals(plan.text("place"))).toList();
    }

    /** Why a plan has not done a step. */
    private void plan(TraceEvent plan, Term step) {
        Term trigger = History.parsed(plan, "trigger");
        String place = plan.text("place");
        why.link(plan, "it is in the plan " + trigger.brief() + " (" + place + ")");
        Optional<TraceEvent> last = History.last(chosen(plan).stream());
        if (last.isPresent()) {
            why.link(last.get(), agent + " chose it for " + History.parsed(last.get(), "trigger").brief());
            if (ran(last.get().text("intention"), place, true)) {
                return;
            }
            Optional<TraceEvent> event = history.of(agent, "agent-event")
                    .filter(each -> each.number("number") == last.get().number("number")).findFirst();
            if (step.isInternal() && event.isPresent()) {
                why.link(last.get(), "its plan ran to its end; no log tells of " + step.functor() + " itself");
                why.chain(event.get());
            } else {
                why.cause("its plan ran to its end, another way");
            }
            return;
        }
        Optional<TraceEvent> asked = History.last(history.of(agent, "agent-choice").filter(each -> History.asked(each)
                .stream().anyMatch(one -> one.getKey().equals(place))));
        Optional<TraceEvent> other = History.last(history.of(agent, "agent-choice").filter(each -> each.has("place")
                && isFor(trigger, History.parsed(each, "trigger"))));
        Optional<TraceEvent> event = History.last(history.events(agent, trigger.sign(), trigger).stream());
        if (asked.isPresent()) {
            JsonObject answer = History.asked(asked.get()).stream().filter(one -> one.getKey().equals(place))
                    .findFirst().orElseThrow().getValue();
            why.link(asked.get(), "its context was asked for " + History.parsed(asked.get(), "trigger").brief());
            why.cause(Why.falsePart(answer));
        } else if (other.isPresent()) {
            why.link(other.get(), agent + " chose the plan (" + other.get().text("place") + ")");
            why.cause("its plan was not asked, as one before it applied: (" + other.get().text("place") + ")");
        } else if (event.isPresent()) {
            why.link(event.get(), agent + " has the event " + History.parsed(event.get(), "trigger").brief());
            mismatch(History.parsed(event.get(), "trigger"), trigger);
        } else {
            never(trigger);
        }
    }

    private static boolean isFor(Term plan, Term event) {
        return plan.sign().equals(event.sign()) && plan.goal().equals(event.goal()) && plan.matches(event);
    }

    /**
     * Tells where an intention is, if it is not at its end.
     *
     * @param ended whether the end is to be told, too.
     */
    private boolean ran(String intention, String place, boolean ended) {
        Optional<TraceEvent> last = History.last(history.all().filter(each -> each.name().startsWith("agent-")
                && each.textOrEmpty("agent").equals(agent) && each.textOrEmpty("intention").equals(intention)
                && !each.is("agent-choice")));
        if (last.isEmpty()) {
            return false;
        }
        TraceEvent at = last.get();
        String step = at.textOrEmpty("step");
        switch (at.name()) {
            case "agent-dropped" -> {
                why.link(at, "the intention is dropped at the step " + step);
                JsonObject by = at.has("by") ? at.json("by").getAsJsonObject() : new JsonObject();
                why.cause("its plan was dropped"
                        + (by.has("step") ? " by " + by.get("step").getAsString() + " of the plan "
                                + Why.plan(by) : ""));
            }
            case "agent-stopped" -> {
                why.link(at, "the plan stops at the step " + step);
                why.cause(step + " failed" + error(at, intention));
            }
            case "agent-waits", "agent-action", "agent-sends" -> {
                Optional<TraceEvent> action = History.last(history.of(agent, "agent-action")
                        .filter(each -> each.textOrEmpty("intention").equals(intention)
                                && step.equals(each.text("step"))));
                if (action.isPresent()) {
                    failed(action.get());
                } else {
                    why.link(at, "the plan waits in " + step);
                    why.cause("its plan waits in " + step + ", since then");
                }
            }
            case "agent-event" -> {
                why.link(at, "the plan does the step " + step);
                noPlan(at);
            }
            default -> {
                if (ended) {
                    why.link(at, "the intention ends");
                }
                return false;
            }
        }
        return true;
    }

    /** What Jason said of the failure of an intention. */
    private String error(TraceEvent stopped, String intention) {
        Pattern of = Pattern.compile("(?s)error\\((\\w+)\\).*intention " + intention + "\\b");
        return history.all().filter(each -> History.PRINTS.contains(each.name())
                && each.textOrEmpty("agent").equals(agent)).filter(history.before(stopped))
                .map(each -> of.matcher(each.text("text"))).filter(Matcher::find).map(found -> ": " + found.group(1))
                .reduce((first, second) -> second).orElse("");
    }

    // Beliefs and messages

    /** Why something is not believed. @param lost when it was believed no longer. */
    void belief(Term asked, Optional<TraceEvent> lost) {
        if (refused(asked, lost)) {
            return;
        }
        List<String> told = History.last(history.onBoard(board, "percepts")).map(History::percepts).orElse(List.of());
        Optional<String> kept = told.stream().filter(each -> Term.parse(each).filter(asked::matches).isPresent())
                .findFirst();
        Optional<TraceEvent> settings = history.settings(agent);
        if (kept.isPresent() && settings.get().number("filters") > 0) {
            why.cause(agent + "'s filters keep " + kept.get() + " away, which its board told");
            return;
        }
        if (lost.isPresent()) {
            Term term = History.parsed(lost.get(), "trigger");
            if (term.source().equals("percept")) {
                why.link(lost.get(), agent + " no longer believes " + term.term());
                why.lost(lost.get(), board);
            } else {
                why.chain(lost.get());
            }
            return;
        }
        List<TraceEvent> adding = plansWith("+", asked).filter(each -> places.add(each.text("place")))
                .toList();
        if (!adding.isEmpty()) {
            plan(adding.get(adding.size() - 1), asked);
            return;
        }
        Optional<Term> other = plans().flatMap(each -> Stream.concat(steps("", asked, each), steps("+", asked, each)))
                .findFirst();
        Optional<Term> nearest = History.nearest(asked, history.believed(agent).stream());
        if (other.isPresent()) {
            why.cause("no plan of " + agent + " has the step " + asked.term() + "; the nearest is "
                    + other.get().term());
        } else if (nearest.isPresent()) {
            why.cause(agent + " never believed " + asked.term() + "; the nearest is " + nearest.get().term());
        } else if (settings.map(each -> each.text("port").isEmpty()).orElse(true)) {
            why.cause(agent + " has opened no port: its board can tell it nothing");
        } else if (!settings.get().text("percepts").equals("open")) {
            why.cause(agent + " has not opened its percepts: its plans need .percepts(open)");
        } else {
            why.cause("nobody has told " + asked.term() + (history.boards().isEmpty() ? "" : "; " + board
                    + "'s board tells " + (told.isEmpty() ? "nothing" : String.join(", ", told))));
        }
    }

    /** Tells the last attempt to tell it that came to nothing, if there was one. @param lost after this. */
    private boolean refused(Term asked, Optional<TraceEvent> lost) {
        double since = lost.map(TraceEvent::seconds).orElse(0.0);
        Optional<TraceEvent> message =
                History.last(history.of(agent, "agent-message").filter(each -> each.seconds() > since
                        && !each.text("how").equals("passed") && isSaid(asked, each)));
        if (message.isPresent()) {
            TraceEvent said = message.get();
            why.link(said, said.text("from") + " said " + said.text("content") + " to " + said.text("to"));
            String reason = said.text("why");
            if (said.text("how").equals("malformed")) {
                why.cause("it is no AgentSpeak: " + reason);
            } else {
                why.link(said, "the gate refused it: " + reason);
                why.cause("the gate refused it" + (said.text("row").isEmpty() ? ": " + reason
                        : " by its row " + said.text("row").strip()));
            }
            return true;
        }
        return History.last(transmissions(asked).filter(each -> lastTime(each) > since)).map(this::notReceived)
                .orElse(false);
    }

    private static boolean isSaid(Term asked, TraceEvent message) {
        String content = message.text("content");
        return asked.isSaidBy(content) || message.text("how").equals("malformed") && content
                .substring(content.lastIndexOf(';') + 1).startsWith(asked.functor());
    }

    /** What was to be sent with that content: by hosts, or by an attacker who needs none. */
    private Stream<TraceEvent> transmissions(Term asked) {
        return history.all().filter(each -> (each.is("host-transmit") && !each.board().equals(board)
                || each.is("rf-tx", "injector")) && asked.isSaidBy(each.textOrEmpty("content")));
    }

    /** Its packets, and those that repeat them byte by byte. */
    private List<TraceEvent> packets(TraceEvent of) {
        List<TraceEvent> all = new ArrayList<>(of.is("rf-tx") ? List.of(of) : history.packets(of));
        Set<String> payloads = all.stream().map(each -> each.text("payload")).collect(Collectors.toSet());
        history.all().filter(each -> each.is("rf-tx", "injector") && payloads.contains(each.text("payload"))
                && !all.contains(each)).forEach(all::add);
        return all;
    }

    private double lastTime(TraceEvent of) {
        return Math.max(of.seconds(), packets(of).stream().mapToDouble(TraceEvent::seconds).max().orElse(0));
    }

    private boolean notReceived(TraceEvent of) {
        String sender = of.board();
        why.link(of, sender + (of.is("rf-tx") ? " sends " : "'s board is to send ") + of.text("content") + " to "
                + of.text("destination"));
        List<TraceEvent> packets = packets(of);
        if (packets.isEmpty()) {
            why.cause(sender + "'s board waits for quiet air: it hears a carrier");
            return true;
        }
        TraceEvent packet = packets.get(packets.size() - 1);
        int number = packet.number("packet");
        why.link(packet, "packet " + number + " of " + packet.board() + ", attempt " + packets.size());
        List<TraceEvent> here = history.atBoard(board, number);
        Optional<TraceEvent> damaged = here.stream().filter(each -> each.is("rf-damaged")).findFirst();
        Optional<TraceEvent> dropped =
                here.stream().filter(each -> each.is("point") && each.text("name").equals("COUNT")
                        && Counter.of(each.number("counter")).filter(DROPS::contains).isPresent()).findFirst();
        if (dropped.isPresent()) {
            Counter counter = Counter.of(dropped.get().number("counter")).orElseThrow();
            why.link(dropped.get(), board + "'s board counts " + counter);
            why.cause(board + "'s board dropped the packet: " + counter);
        } else if (damaged.isPresent()) {
            why.link(damaged.get(), "it is damaged: " + damaged.get().text("why"));
            why.cause("the packet arrived damaged at " + board + "'s board");
        } else if (here.stream().anyMatch(each -> each.is("rf-rx"))) {
            return false;
        } else {
            outOfReach(packet.board());
        }
        return true;
    }

    private void outOfReach(String sender) {
        Optional<double[]> from = position(sender);
        Optional<double[]> to = position(board);
        double range = history.all().filter(each -> each.is("scenario")).findFirst()
                .map(each -> each.json("radio").getAsJsonObject().get("range").getAsDouble()).orElse(0.0);
        double distance = from.isPresent() && to.isPresent()
                ? Math.hypot(from.get()[0] - to.get()[0], from.get()[1] - to.get()[1]) : 0;
        why.cause(distance > range ? board + "'s board is out of reach of " + sender + ": " + Math.round(distance)
                + " m, and the radio reaches " + Math.round(range) + " m"
                : "the packet did not reach " + board + "'s board, as another was on the air");
    }

    /** Where a board was last. */
    private Optional<double[]> position(String of) {
        Optional<JsonArray> last = History.last(history.onBoard(of, "place")).map(each -> each.json("position")
                .getAsJsonArray()).or(() -> history.boards().stream()
                        .filter(each -> each.get("name").getAsString().equals(of)).findFirst()
                        .map(each -> each.getAsJsonArray("position")));
        return last.map(each -> new double[] {each.get(0).getAsDouble(), each.get(1).getAsDouble()});
    }
}
