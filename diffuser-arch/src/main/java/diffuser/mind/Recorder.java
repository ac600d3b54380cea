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

import jason.asSemantics.Circumstance;
import jason.asSemantics.CircumstanceListener;
import jason.asSemantics.Event;
import jason.asSemantics.IntendedMeans;
import jason.asSemantics.Intention;
import jason.asSemantics.Option;
import jason.asSemantics.TransitionSystem;
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
    private final transient Consumer<String> lines;
    private transient Circumstance watched;
    private transient Iterable<?> library;
    /** The numbers of events that wait. */
    private final transient Map<Event, Integer> numbers = new IdentityHashMap<>();
    /** The plans that were told. */
    private final transient Set<Plan> plans = Collections.newSetFromMap(new IdentityHashMap<>());
    private int events;
    private int requests;
    /** The event for which plans are being asked, and what they have answered. */
    private transient Event selected;
    private final transient List<Map<String, Object>> answers = new ArrayList<>();
    private transient Event chosen;
    /** The intention that was selected is kept somewhere, or was told to have ended. */
    private transient Intention kept;
    private boolean passing;

    /**
     * @param lines takes each line, on the agent's thread or the board's.
     */
    public Recorder(TransitionSystem ts, Time time, Consumer<String> lines) {
        this.ts = ts;
        this.time = time;
        this.lines = lines;
    }

    private Map<String, Object> line(String event) {
        Map<String, Object> line = new LinkedHashMap<>();
        line.put("t", Math.round(time.nanos() / NANOS * MICROS) / MICROS);
        line.put("event", "agent-" + event);
        line.put("agent", ts.getAgArch().getAgName());
        return line;
    }

    private void tell(Map<String, Object> line) {
        lines.accept(JsonLine.of(line));
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
                        Map<String, Object> line = line("believes");
                        line.put("belief", belief.toString());
                        tell(line);
                    }
                }
            }
            watched.getEvents().forEach(each -> added(each, first ? "program" : ""));
            library = (Iterable<?>) Plans.library(ts.getAg());
        }
        for (Object plan : library) {
            record((Plan) plan);
        }
    }

    private void record(Plan plan) {
        RecordedContext.record(plan, this);
        boolean jasons = plan.getSrcInfo() != null && String.valueOf(plan.getSrcInfo().getSrcFile()).endsWith(JASONS_PLANS);
        if (plans.add(plan) && !jasons) {
            Map<String, Object> line = line("plan");
            name(line, plan);
            line.put("trigger", plan.getTrigger().toString());
            line.put("body", String.valueOf(plan.getBody()));
            tell(line);
            Plans.within(plan).forEach(this::record);
        }
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

    /** Where an intention is: its plan on top, and that one's step. */
    private static void name(Map<String, Object> line, Intention intention) {
        line.put(INTENTION, intention.getId());
        if (!intention.isFinished()) {
            IntendedMeans top = intention.peek();
            name(line, top.getPlan());
            PlanBody step = top.getCurrentStep();
            Term term = step == null ? null : step.getBodyTerm();
            line.put("step", term == null ? "" : step.getBodyType() + term.capply(top.getUnif()).toString());
        }
    }

    // Events and plans

    @Override
    public void eventAdded(Event event) {
        added(event, "");
    }

    private void added(Event event, String origin) {
        Trigger trigger = event.getTrigger();
        numbers.put(event, ++events);
        Map<String, Object> line = line("event");
        line.put("number", events);
        line.put("trigger", trigger.toString());
        if (!origin.isEmpty()) {
            line.put("origin", origin);
        } else if (event.getIntention() != null && event.getIntention() != Intention.EmptyInt) {
            keep(event.getIntention());
            name(line, event.getIntention());
        } else if (isBy(ts.getC().getSelectedIntention(), trigger)) {
            name(line, ts.getC().getSelectedIntention());
        }
        tell(line);
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
    public void answered(Plan of, RecordedContext context, boolean holds) {
        Event now = ts.getC().getSelectedEvent();
        if (passing || now == null) {
            return;
        }
        if (now != selected) {
            tellChoice();
            selected = now;
        }
        Map<String, Object> answer = new LinkedHashMap<>();
        name(answer, of);
        answer.put("holds", holds);
        if (!holds) {
            answer.put("part", context.part());
            answer.put("values", context.values());
        }
        answers.add(answer);
    }

    /** Tells the event for which plans were asked, if none of them applies. */
    private void tellChoice() {
        if (selected != null && selected != chosen) {
            tell(choice(selected));
        }
        selected = null;
        answers.clear();
    }

    private Map<String, Object> choice(Event event) {
        Map<String, Object> line = line("choice");
        Integer number = numbers.remove(event);
        line.put("number", number == null ? 0 : number);
        line.put("trigger", event.getTrigger().toString());
        line.put("asked", event == selected ? List.copyOf(answers) : List.of());
        return line;
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
            Map<String, Object> line = choice(event);
            name(line, option.getPlan());
            line.put(INTENTION, intention.getId());
            tell(line);
            chosen = event;
        }
    }

    @Override
    public void intentionWaiting(Intention intention, Term reason) {
        keep(intention);
        Map<String, Object> line = line("waits");
        name(line, intention);
        tell(line);
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
        Map<String, Object> line = line("dropped");
        name(line, intention);
        Intention by = ts.getC().getSelectedIntention();
        if (by != null && !by.isFinished()) {
            Map<String, Object> dropping = new LinkedHashMap<>();
            name(dropping, by);
            line.put("by", dropping);
        }
        tell(line);
    }

    /** At the end of a cycle: an intention that is kept nowhere has failed, and no plan handles it. */
    public void cycled() {
        tellChoice();
        Intention done = ts.getC().getSelectedIntention();
        if (done != null && (done.isFinished() || done != kept)) {
            Map<String, Object> line = line(done.isFinished() ? "ended" : "stopped");
            name(line, done);
            tell(line);
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
        Map<String, Object> line = line("settings");
        line.put("port", port);
        line.put("percepts", settings.percepts().name().toLowerCase(Locale.ROOT));
        line.put("filters", settings.filters().size());
        line.put("radio", settings.radio());
        line.put("rfId", settings.rfId().map(Object::toString).orElse(""));
        tell(line);
    }

    /** An action that the board is asked for. */
    public void asks(String action, CompletableFuture<Void> outcome) {
        int request = request("action", "action", action);
        outcome.whenComplete((done, thrown) -> performed(request, thrown));
    }

    private int request(String event, String field, String value) {
        Map<String, Object> line = line(event);
        line.put("request", ++requests);
        line.put(field, value);
        Intention by = ts.getC().getSelectedIntention();
        if (by != null) {
            name(line, by);
        }
        tell(line);
        return requests;
    }

    private void performed(int request, Throwable thrown) {
        Map<String, Object> line = line("performed");
        line.put("request", request);
        line.put("error", thrown == null ? "" : Failure.of(thrown).error());
        line.put("message", thrown == null ? "" : Failure.of(thrown).message());
        tell(line);
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
        Map<String, Object> line = line("message");
        line.put("from", message.from().toString());
        line.put("to", message.to().toString());
        line.put("id", String.format("%06x", message.id()));
        line.put("content", message.content().toString());
        line.put("how", how);
        line.put("why", why);
        line.put("row", row);
        tell(line);
    }
}
