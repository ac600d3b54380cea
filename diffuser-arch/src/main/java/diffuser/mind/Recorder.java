package diffuser.mind;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
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
    private static final int LEAST_TO_FORGET = 1000;
    private static final String INTENTION = "intention";
    /** Jason's mark of what it keeps itself among an agent's beliefs. */
    private static final Term HIDDEN = ASSyntax.createAtom("hide_in_mind_inspector");
    private static final String JASONS_PLANS = "kqmlPlans.asl";

    private final transient TransitionSystem ts;
    private final transient Time time;
    private final transient List<Consumer<Supplier<String>>> listeners = new CopyOnWriteArrayList<>();
    private transient Circumstance watched;
    /** The library's own list of its plans. */
    private transient List<?> library;
    /** Events that wait, in their order. */
    private final transient Deque<Added> waiting = new ArrayDeque<>();
    /** The library's plans, which are recorded. */
    private final transient List<Plan> plans = new ArrayList<>();
    /** With more of them it is looked which were dropped. */
    private int mostWaiting = LEAST_TO_FORGET;
    /** When the first line of this cycle was told; one reading of the clock does for all of them. */
    private long cycle;
    private boolean inCycle;
    private int events;
    private int requests;
    /** The event for which plans are being asked, and what they have answered. */
    private transient Event selected;
    private final transient List<RecordedContext.Answer> answers = new ArrayList<>();
    private transient Event chosen;
    /** The intention that was selected is kept somewhere, or was told to have ended. */
    private transient Intention kept;
    private boolean passing;

    public Recorder(TransitionSystem ts, Time time) {
        this.ts = ts;
        this.time = time;
    }

    /**
     * Tells one more. On the agent's thread, or before its first cycle.
     *
     * @param lines takes each line, on the agent's thread or the board's. It may make the text of it later, while the
     *              agent is not in a cycle.
     */
    public void begin(Consumer<Supplier<String>> lines) {
        if (watched != null) {
            introduce(lines);
        }
        listeners.add(lines);
    }

    /** A line, whose texts are made where it is read: an agent does not wait for them. */
    private abstract class Line implements Supplier<String> {

        private final long at;
        private final String event;

        Line(String event, long at) {
            this.event = event;
            this.at = at;
        }

        abstract void put(Map<String, Object> line);

        @Override
        public final String get() {
            Map<String, Object> line = new LinkedHashMap<>();
            line.put("t", Math.round(at / NANOS * MICROS) / MICROS);
            line.put("event", "agent-" + event);
            line.put("agent", ts.getAgArch().getAgName());
            put(line);
            return JsonLine.of(line);
        }
    }

    /** An event that was added. */
    private final class Added extends Line {

        /** As long as it waits: lines are kept longer than the agent keeps its events. */
        private Event of;
        private final int number;
        private final Trigger trigger;
        /** A belief's annotations change with it. */
        private final List<Term> annotations;
        private final String origin;
        private final Place place;

        /** @param origin where it is from, if that is no plan; @param place of the intention that made it, or null. */
        Added(Event of, String origin, Place place) {
            super("event", now());
            this.of = of;
            trigger = of.getTrigger();
            annotations = trigger.getLiteral().hasAnnot() ? List.copyOf(trigger.getLiteral().getAnnots()) : List.of();
            this.origin = origin;
            this.place = place;
            number = ++events;
        }

        @Override
        void put(Map<String, Object> line) {
            Trigger then = trigger.clone();
            if (!annotations.isEmpty()) {
                then.getLiteral().clearAnnots();
                then.getLiteral().addAnnots(annotations);
            }
            line.put("number", number);
            line.put("trigger", then.toString());
            if (!origin.isEmpty()) {
                line.put("origin", origin);
            } else if (place != null) {
                place.putInto(line);
            }
        }
    }

    /** A line of a kind that is rare, whose parts are put by a function. */
    private final class Other extends Line {

        private final Consumer<Map<String, Object>> fields;

        Other(String event, long at, Consumer<Map<String, Object>> fields) {
            super(event, at);
            this.fields = fields;
        }

        @Override
        void put(Map<String, Object> line) {
            fields.accept(line);
        }
    }

    /** The time of this cycle. */
    private long now() {
        if (!inCycle) {
            inCycle = true;
            cycle = time.nanos();
        }
        return cycle;
    }

    private void tell(Line line) {
        for (Consumer<Supplier<String>> each : listeners) {
            each.accept(line);
        }
    }

    /** On the agent's thread. */
    private void tell(String event, Consumer<Map<String, Object>> fields) {
        tell(new Other(event, now(), fields));
    }

    /** Looks at what is new: in each cycle, before an event is selected, as the agent may get other plans and minds. */
    public void watch() {
        if (ts.getC() != watched) {
            boolean first = watched == null;
            watched = ts.getC();
            watched.addEventListener(this);
            library = (List<?>) Plans.call(Plans.library(ts.getAg()), "getPlans");
            if (first) {
                listeners.forEach(this::introduce);
            }
            String origin = !first ? "" : ts.getAgArch().getCycleNumber() <= 1 ? "program" : "before";
            watched.getEvents().forEach(each -> added(each, origin));
        }
        int size = library.size();
        // Plans are added at one of the ends.
        boolean same = size == plans.size() && (size == 0
                || library.get(0) == plans.get(0) && library.get(size - 1) == plans.get(size - 1));
        if (!same) {
            recordAll();
        }
    }

    /** Tells what there was before. */
    private void introduce(Consumer<Supplier<String>> to) {
        for (Literal belief : ts.getAg().getBB()) {
            if (!belief.hasAnnot(HIDDEN)) {
                String text = belief.toString();
                to.accept(new Other("believes", now(), line -> line.put("belief", text)));
            }
        }
        plans.forEach(plan -> tell(plan, List.of(to)));
        waiting.forEach(to);
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
                tell(plan, listeners);
            }
        }
    }

    private void record(Plan plan) {
        RecordedContext.record(plan, this);
        Plans.within(plan).forEach(this::record);
    }

    private void tell(Plan plan, List<Consumer<Supplier<String>>> to) {
        if (!String.valueOf(plan.getSrcInfo()).contains(JASONS_PLANS)) {
            Line told = new Other("plan", now(), line -> {
                name(line, plan);
                line.put("trigger", plan.getTrigger().toString());
                line.put("body", String.valueOf(plan.getBody()));
            });
            to.forEach(each -> each.accept(told));
        }
        Plans.within(plan).forEach(each -> tell(each, to));
    }

    /** Tells one no more. @return whether that was the last one; then the agent is as it was. */
    public boolean end(Consumer<Supplier<String>> lines) {
        listeners.remove(lines);
        if (listeners.isEmpty() && watched != null) {
            watched.removeEventListener(this);
            Plans.of(ts.getAg()).forEach(Recorder::restore);
        }
        return listeners.isEmpty();
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
        Trigger trigger = event.getTrigger();
        Intention from = event.getIntention();
        boolean internal = from != null && from != Intention.EmptyInt;
        if (internal) {
            keep(from);
        }
        Intention by = internal ? from : isBy(ts.getC().getSelectedIntention(), trigger)
                ? ts.getC().getSelectedIntention() : null;
        Added added = new Added(event, origin, by == null || !origin.isEmpty() ? null : Place.of(by));
        waiting.add(added);
        tell(added);
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
            tell(new Choice(selected, null, 0));
        }
        selected = null;
        answers.clear();
    }

    /** Which plan was chosen for an event. */
    private final class Choice extends Line {

        private final int number;
        private final Trigger trigger;
        private final List<RecordedContext.Answer> asked;
        private final Plan plan;
        private final int intention;

        /** @param plan the one that was chosen, for that intention; null if none was. */
        Choice(Event event, Plan plan, int intention) {
            super("choice", now());
            number = number(event);
            trigger = event.getTrigger();
            asked = event == selected ? List.copyOf(answers) : List.of();
            this.plan = plan;
            this.intention = intention;
        }

        @Override
        void put(Map<String, Object> line) {
            line.put("number", number);
            line.put("trigger", trigger.toString());
            line.put("asked", asked.stream().map(Recorder::fields).toList());
            if (plan != null) {
                name(line, plan);
                line.put(INTENTION, intention);
            }
        }
    }

    /** The number of an event that waits no more; 0 if it is not known. Mostly it is the first. */
    private int number(Event event) {
        for (Iterator<Added> each = waiting.iterator(); each.hasNext();) {
            Added added = each.next();
            if (added.of == event) {
                each.remove();
                added.of = null;
                return added.number;
            }
        }
        return 0;
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
            tell(new Choice(event, option.getPlan(), intention.getId()));
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
        forget();
        chosen = null;
        inCycle = false;
    }

    /** Forgets events that wait no more. The agent's queue has them in their order, but for an atomic one. */
    private void forget() {
        if (!ts.getC().hasEvent()) {
            waiting.clear();
        }
        Event first = waiting.isEmpty() ? null : ts.getC().getEvents().peek();
        while (!waiting.isEmpty() && waiting.peek().of != first && !waiting.peek().of.isAtomic()) {
            waiting.remove().of = null;
        }
        if (waiting.size() > mostWaiting) {
            Set<Event> still = Collections.newSetFromMap(new IdentityHashMap<>());
            still.addAll(ts.getC().getEvents());
            waiting.removeIf(each -> !still.contains(each.of));
            mostWaiting = LEAST_TO_FORGET + 2 * waiting.size();
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

    /** An action that the board is asked for; the number of the request. */
    public int asks(String action, CompletableFuture<?> outcome) {
        int request = request("action", "action", action);
        outcome.whenComplete((done, thrown) -> performed(request, thrown));
        return request;
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
        tell(new Other("performed", time.nanos(), line -> {
            line.put("request", request);
            line.put("error", thrown == null ? "" : Failure.of(thrown).error());
            line.put("message", thrown == null ? "" : Failure.of(thrown).message());
        }));
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
        tell(new Other("message", time.nanos(), line -> {
            line.put("from", message.from().toString());
            line.put("to", message.to().toString());
            line.put("id", String.format("%06x", message.id()));
            line.put("content", message.content().toString());
            line.put("how", how);
            line.put("why", why);
            line.put("row", row);
        }));
    }
}
