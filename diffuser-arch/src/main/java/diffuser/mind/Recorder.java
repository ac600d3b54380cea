package diffuser.mind;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Supplier;

import jason.asSemantics.Circumstance;
import jason.asSemantics.CircumstanceListener;
import jason.asSemantics.Event;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.Option;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.SourceInfo;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;

import diffuser.board.BoardSettings;
import diffuser.gate.Plans;
import diffuser.report.Failure;

import javino.board.ReceivedMessage;
import javino.board.Transmission;
import javino.link.Time;

/**
 * Tells what an agent decides, and by what, in lines of JSON: its plans, events, which plans were asked for each and
 * what they answered, its intentions, actions and messages (docs/how-to/ask-why.md). Events, intentions and requests
 * have numbers, by which a line names another. The agent does the same without it. For the agent's own thread.
 */
public final class Recorder implements CircumstanceListener, RecordedContext.Listener {

    private static final long serialVersionUID = 1L;
    private static final double NANOS = 1e9;
    private static final double MICROS = 1e6;
    private static final String INTENTION = "intention";
    /** Jason's mark of what it keeps itself among an agent's beliefs. */
    private static final Term HIDDEN = ASSyntax.createAtom("hide_in_mind_inspector");
    private static final String JASONS_PLANS = "kqmlPlans.asl";

    private final transient TransitionSystem ts;
    private final transient Time time;
    private final transient Consumer<Supplier<String>> lines;
    private transient Circumstance watched;
    private transient Iterable<?> library;
    /** The numbers of events that wait. */
    private final transient Map<Event, Integer> numbers = new IdentityHashMap<>();
    /** The library's plans, which are recorded. */
    private final transient List<Plan> plans = new ArrayList<>();
    private int events;
    private int requests;
    /** The event for which plans are being asked, and what they have answered. */
    private transient Event selected;
    private final transient List<RecordedContext.Answer> answers = new ArrayList<>();
    private transient Event chosen;
    /** The intention that was selected is kept somewhere, or was told to have ended. */
    private transient Intention kept;
    private boolean passing;

    /**
     * @param lines takes each line, on the agent's thread or the board's. It may make the text of it later, while the
     *              agent is not in a cycle.
     */
    public Recorder(TransitionSystem ts, Time time, Consumer<Supplier<String>> lines) {
        this.ts = ts;
        this.time = time;
        this.lines = lines;
    }

    /** Tells a line, whose texts are made where it is read: an agent does not wait for them. */
    private void tell(String event, Consumer<Map<String, Object>> fields) {
        long at = time.nanos();
        lines.accept(() -> {
            Map<String, Object> line = new LinkedHashMap<>();
            line.put("t", Math.round(at / NANOS * MICROS) / MICROS);
            line.put("event", "agent-" + event);
            line.put("agent", ts.getAgArch().getAgName());
            fields.accept(line);
            return JsonLine.of(line);
        });
    }

    /** Looks at what is new: in each cycle, before an event is selected, as the agent may get other plans and minds. */
    public void watch() {
        if (ts.getC() != watched) {
            boolean first = watched == null;
            watched = ts.getC();
            watched.addEventListener(this);
            if (first) {
                for (Literal belief : ts.getAg().getBB()) {
                    if (!belief.hasAnnot(HIDDEN)) {
                        String text = belief.toString();
                        tell("believes", line -> line.put("belief", text));
                    }
                }
            }
            watched.getEvents().forEach(each -> added(each, first ? "program" : ""));
            library = (Iterable<?>) Plans.library(ts.getAg());
        }
        int known = 0;
        for (Object plan : library) {
            if (known == plans.size() || plans.get(known) != plan) {
                recordAll();
                return;
            }
            known++;
        }
    }

    private void recordAll() {
        Set<Plan> before = Collections.newSetFromMap(new IdentityHashMap<>());
        before.addAll(plans);
        plans.clear();
        for (Object each : library) {
            Plan plan = (Plan) each;
            plans.add(plan);
            if (!before.contains(plan)) {
                record(plan);
            }
        }
    }

    private void record(Plan plan) {
        RecordedContext.record(plan, this);
        if (!String.valueOf(plan.getSrcInfo()).contains(JASONS_PLANS)) {
            tell("plan", line -> {
                name(line, plan);
                line.put("trigger", plan.getTrigger().toString());
                line.put("body", String.valueOf(plan.getBody()));
            });
        }
        Plans.within(plan).forEach(this::record);
    }

    /** Leaves the agent as it was. */
    public void end() {
        if (watched != null) {
            watched.removeEventListener(this);
            Plans.of(ts.getAg()).forEach(Recorder::restore);
        }
    }

    private static void restore(Plan plan) {
        RecordedContext.restore(plan);
        Plans.within(plan).forEach(Recorder::restore);
    }

    private static void name(Map<String, Object> line, Plan plan) {
        SourceInfo place = plan.getSrcInfo();
        String label = plan.getLabel() == null ? "" : plan.getLabel().getFunctor();
        line.put("plan", Plans.GENERATED.matcher(label).matches() ? "" : label);
        line.put("place", place == null || place.getSrcFile() == null ? ""
                : place.getSrcFile().replaceFirst("^(.*/|\\w+:)+", "") + ":" + place.getBeginSrcLine());
    }

    /** Where an intention is: its plan on top, and that one's step; without them it has ended. */
    private record Place(int intention, Plan plan, PlanBody step, Unifier binding) {

        static Place of(Intention intention) {
            IntendedMeans top = intention.isFinished() ? null : intention.peek();
            return top == null ? new Place(intention.getId(), null, null, null)
                    : new Place(intention.getId(), top.getPlan(), top.getCurrentStep(), top.getUnif());
        }

        void putInto(Map<String, Object> line) {
            line.put(INTENTION, intention);
            if (plan != null) {
                name(line, plan);
                Term term = step == null ? null : step.getBodyTerm();
                line.put("step", term == null ? "" : step.getBodyType() + term.capply(binding).toString());
            }
        }
    }

    // Events and plans

    @Override
    public void eventAdded(Event event) {
        added(event, "");
    }

    private void added(Event event, String origin) {
        // A belief's annotations change with it.
        Trigger trigger = event.getTrigger().isGoal() ? event.getTrigger() : event.getTrigger().clone();
        int number = ++events;
        numbers.put(event, number);
        Intention from = event.getIntention();
        boolean internal = from != null && from != Intention.EmptyInt;
        if (internal) {
            keep(from);
        }
        Intention by = internal ? from : isBy(ts.getC().getSelectedIntention(), trigger)
                ? ts.getC().getSelectedIntention() : null;
        Place place = by == null || !origin.isEmpty() ? null : Place.of(by);
        tell("event", line -> {
            line.put("number", number);
            line.put("trigger", trigger.toString());
            if (!origin.isEmpty()) {
                line.put("origin", origin);
            } else if (place != null) {
                place.putInto(line);
            }
        });
    }

    /** Whether the step that an intention does now has made that event. */
    private static boolean isBy(Intention intention, Trigger trigger) {
        if (intention == null || intention.isFinished() || intention.peek().getCurrentStep() == null) {
            return false;
        }
        PlanBody step = intention.peek().getCurrentStep();
        return step.getBodyTerm() instanceof Literal literal && switch (step.getBodyType()) {
            case action, test, constraint, none, internalAction -> false;
            default -> literal.isVar() || literal.getFunctor().equals(trigger.getLiteral().getFunctor());
        };
    }

    @Override
    public void answered(RecordedContext.Answer answer) {
        Event now = ts.getC().getSelectedEvent();
        if (passing || now == null) {
            return;
        }
        if (now != selected) {
            tellChoice();
            selected = now;
        }
        answers.add(answer);
    }

    /** Tells the event for which plans were asked, if none of them applies. */
    private void tellChoice() {
        if (selected != null && selected != chosen) {
            choice(selected, null, 0);
        }
        selected = null;
        answers.clear();
    }

    /** @param plan the one that was chosen, for that intention; null if none was. */
    private void choice(Event event, Plan plan, int intention) {
        Integer number = numbers.remove(event);
        Trigger trigger = event.getTrigger();
        List<RecordedContext.Answer> asked = event == selected ? List.copyOf(answers) : List.of();
        tell("choice", line -> {
            line.put("number", number == null ? 0 : number);
            line.put("trigger", trigger.toString());
            line.put("asked", asked.stream().map(Recorder::fields).toList());
            if (plan != null) {
                name(line, plan);
                line.put(INTENTION, intention);
            }
        });
    }

    private static Map<String, Object> fields(RecordedContext.Answer answer) {
        Map<String, Object> fields = new LinkedHashMap<>();
        name(fields, answer.plan());
        fields.put("holds", answer.holds());
        if (!answer.holds()) {
            fields.put("part", answer.text());
            fields.put("values", answer.values());
        }
        return fields;
    }

    // Intentions

    private void keep(Intention intention) {
        if (intention == ts.getC().getSelectedIntention()) {
            kept = intention;
        }
    }

    @Override
    public void intentionAdded(Intention intention) {
        keep(intention);
        Event event = ts.getC().getSelectedEvent();
        Option option = ts.getC().getSelectedOption();
        if (event != null && option != null && event != chosen) {
            if (event != selected) {
                tellChoice();
            }
            choice(event, option.getPlan(), intention.getId());
            chosen = event;
        }
    }

    @Override
    public void intentionWaiting(Intention intention, Term reason) {
        keep(intention);
        tell("waits", Place.of(intention)::putInto);
    }

    @Override
    public void intentionSuspended(Trigger trigger, Intention intention, Term reason) {
        intentionWaiting(intention, reason);
    }

    @Override
    public void intentionDropped(Intention intention) {
        keep(intention);
        if (intention.isFinished()) {
            return;
        }
        Place place = Place.of(intention);
        Intention by = ts.getC().getSelectedIntention();
        Place dropping = by == null || by.isFinished() ? null : Place.of(by);
        tell("dropped", line -> {
            place.putInto(line);
            if (dropping != null) {
                Map<String, Object> fields = new LinkedHashMap<>();
                dropping.putInto(fields);
                line.put("by", fields);
            }
        });
    }

    /** At the end of a cycle: an intention that is kept nowhere has failed, and no plan handles it. */
    public void cycled() {
        tellChoice();
        Intention done = ts.getC().getSelectedIntention();
        if (done != null && (done.isFinished() || done != kept)) {
            tell(done.isFinished() ? "ended" : "stopped", Place.of(done)::putInto);
        }
        kept = null;
        chosen = null;
        if (!ts.getC().hasEvent()) {
            numbers.clear();
        }
    }

    // The board

    /** What the agent wishes of its board. */
    public void settings(BoardSettings settings, String port) {
        tell("settings", line -> {
            line.put("port", port);
            line.put("percepts", settings.percepts().name().toLowerCase(Locale.ROOT));
            line.put("filters", settings.filters().size());
            line.put("radio", settings.radio());
            line.put("rfId", settings.rfId().map(Object::toString).orElse(""));
        });
    }

    /** An action that the board is asked for. */
    public void asks(String action, CompletableFuture<?> outcome) {
        int request = request("action", "action", action);
        outcome.whenComplete((done, thrown) -> performed(request, thrown));
    }

    private int request(String event, String field, String value) {
        int request = ++requests;
        Intention by = ts.getC().getSelectedIntention();
        Place place = by == null ? null : Place.of(by);
        tell(event, line -> {
            line.put("request", request);
            line.put(field, value);
            if (place != null) {
                place.putInto(line);
            }
        });
        return request;
    }

    private void performed(int request, Throwable thrown) {
        tell("performed", line -> {
            line.put("request", request);
            line.put("error", thrown == null ? "" : Failure.of(thrown).error());
            line.put("message", thrown == null ? "" : Failure.of(thrown).message());
        });
    }

    /** A message that the board is asked to send. */
    void sends(OutgoingMessage message, Transmission transmission) {
        int request = request("sends", "content", message.content().toString());
        transmission.end().whenComplete((outcome, thrown) -> performed(request, thrown));
    }

    /** Gate and messages: contexts that the gate asks are of no event. */
    void passing(boolean now) {
        passing = now;
    }

    /**
     * A message from the radio, and what became of it.
     *
     * @param how {@code passed}, {@code refused} or {@code malformed}.
     * @param why a refusal's reason.
     * @param row the gate's row that decided; empty if none did.
     */
    void message(ReceivedMessage message, String how, String why, String row) {
        tell("message", line -> {
            line.put("from", message.from().toString());
            line.put("to", message.to().toString());
            line.put("id", String.format("%06x", message.id()));
            line.put("content", message.content().toString());
            line.put("how", how);
            line.put("why", why);
            line.put("row", row);
        });
    }
}
