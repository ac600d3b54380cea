package trace.why;

import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import trace.TraceEvent;

/**
 * Answers why something happened in a run, by the chain of recorded facts that leads back to a sensor, a packet or a
 * goal of the program; or why it did not. Facts are joined by the numbers of packets, requests, events and intentions.
 */
public final class Why {

    /** So often a plan is in an answer; a goal that calls itself would never end. */
    private static final int MOST_TURNS = 3;
    private static final Set<String> AT_A_TIME = Set.of("pin", "agent-action", "agent-event", "agent-message");
    private static final Set<String> ASKED = Set.of("pin", "rf-tx", "agent-action", "agent-event", "agent-message");
    /** Told once. */
    private static final Set<String> LASTING = Set.of("scenario", "agent-plan", "agent-settings");
    private static final Pattern ON = Pattern.compile("on|off|\\d+");
    private static final Set<String> OFF = Set.of("off", "0");

    private final History history;
    private List<Link> answer = new ArrayList<>();
    private final Map<String, Integer> turns = new HashMap<>();

    /** A line of an answer. @param by the fact that it tells; null for the first cause. */
    private record Link(double seconds, TraceEvent by, String text) {

        boolean isOfAgent() {
            return by != null && by.name().startsWith("agent-");
        }

        Link at(double other) {
            return isOfAgent() ? new Link(other, by, text) : this;
        }

        @Override
        public String toString() {
            return by == null ? "first cause: " + text : String.format(Locale.ROOT, "%10.4f s  %s", seconds, text);
        }
    }

    /** @param events of a run's log, in its order. */
    public Why(List<TraceEvent> events) {
        history = new History(events);
    }

    /** The same, of what had happened at a time. */
    public Why(List<TraceEvent> events, double until) {
        this(events.stream().filter(each -> each.seconds() <= until || LASTING.contains(each.name())).toList());
    }

    /**
     * Answers a question.
     *
     * @param question a belief or pin as {@code lamp(on)}, an action, a goal as {@code !go}, or an event as {@code
     *                 +dark(_)}.
     * @param agent    of whom it is asked; empty for the one that it concerns.
     * @return lines: the question's answer back to the first cause, which is the last one.
     * @throws IllegalArgumentException if it is no question, or there is no such agent; the message says what to do.
     */
    public List<String> answer(String question, String agent) {
        answer = new ArrayList<>();
        String event = question.startsWith("!") ? "+" + question : question.replaceFirst("^\\.act\\((.*)\\)$", "$1");
        Term asked = Term.parse(event).filter(any -> Term.isClosed(event))
                .orElseThrow(() -> new IllegalArgumentException("WHAT takes a belief, goal, action or pin, such as"
                        + " 'lamp(on)', '!go' or 'lampOn', not '" + question + "'"));
        answer(asked, agents(agent));
        return texts();
    }

    private List<String> texts() {
        return answer.stream().map(Link::toString).toList();
    }

    private List<String> agents(String agent) {
        List<String> agents = agent.isEmpty() ? history.agents() : List.of(agent);
        if (agents.isEmpty() || !history.agents().containsAll(agents)) {
            throw new IllegalArgumentException(history.agents().isEmpty() ? "the log has no agents; is it run.jsonl?"
                    : "the log has no agent " + agent + "; it has " + String.join(", ", history.agents()));
        }
        return agents;
    }

    /** Answers why that happened which is nearest to a time, in s; the agent's, as in {@link #answer}. */
    public List<String> at(double seconds, String agent) {
        answer = new ArrayList<>();
        List<String> agents = agents(agent);
        Optional<TraceEvent> nearest = history.all().filter(each -> AT_A_TIME.contains(each.name())
                && (!each.has("agent") || agents.contains(each.text("agent"))))
                .min(Comparator.comparingDouble(each -> Math.abs(each.seconds() - seconds)));
        nearest.ifPresentOrElse(this::chain, () -> cause("nothing happened in this log"));
        return texts();
    }

    /**
     * Answers why that happened which a line of the log tells.
     *
     * @param fields of the line, which no other has all: as a pin's {@code t}, {@code board} and {@code pin}.
     * @throws IllegalArgumentException if there is no such line.
     */
    public List<String> of(JsonObject fields) {
        answer = new ArrayList<>();
        chain(history.like(fields).filter(each -> ASKED.contains(each.name()))
                .orElseThrow(() -> new IllegalArgumentException(
                        "the log does not have that line, or no longer: ask for what is newer")));
        return texts();
    }

    private void answer(Term asked, List<String> agents) {
        Optional<TraceEvent> pin = asked.sign().isEmpty() ? lastPin(asked) : Optional.empty();
        List<String> concerned = agents.stream().filter(each -> concerns(each, asked)).toList();
        if (concerned.isEmpty() && pin.isEmpty() && agents.size() > 1) {
            cause("no agent knows " + asked.brief() + ": it is in no plan, belief or message of theirs"
                    + History.nearest(asked, agents.stream().flatMap(each -> history.believed(each).stream()))
                            .map(each -> "; the nearest is " + each.term()).orElse(""));
            return;
        }
        String agent = concerned.isEmpty() ? agents.get(0) : concerned.get(0);
        WhyNot not = new WhyNot(history, this, agent);
        Optional<String> board = boardWith(asked);
        if (pin.isPresent()) {
            chain(pin.get());
        } else if (asked.sign().isEmpty() && board.isPresent() && history.believed(agent).stream()
                .noneMatch(asked::matches)) {
                    not.pin(board.get(), asked);
                } else
            if (!asked.sign().isEmpty()) {
                not.event(asked);
            } else {
                Optional<TraceEvent> gained = History.last(history.events(agent, "+", asked).stream());
                Optional<TraceEvent> lost = History.last(history.events(agent, "-", asked).stream());
                Optional<TraceEvent> action = History.last(not.actions(asked));
                Optional<TraceEvent> had = history.of(agent, "agent-believes")
                        .filter(each -> asked.matches(History.parsed(each, "belief"))).findFirst();
                Optional<TraceEvent> since = gained.or(() -> had);
                if (since.isPresent() && lost.filter(history.after(since.get())).isEmpty()) {
                    chain(since.get());
                } else if (action.flatMap(history::outcome).filter(end -> end.text("error").isEmpty()).isPresent()) {
                    chain(action.get());
                } else if (action.isPresent() || not.isStep(asked)) {
                    not.action(asked);
                } else {
                    not.belief(asked, lost);
                }
            }
    }

    private boolean concerns(String agent, Term asked) {
        return history.all().anyMatch(each -> each.textOrEmpty("agent").equals(agent)
                && Pattern.compile("\\b" + Pattern.quote(asked.functor()) + "\\b").matcher(each.line()).find());
    }

    private Optional<TraceEvent> lastPin(Term asked) {
        boolean level = asked.arguments().size() == 1 && ON.matcher(asked.arguments().get(0)).matches();
        return History.last(history.all().filter(each -> level && each.is("pin")
                && each.textOrEmpty("name").equals(asked.functor())
                && (each.number("level") == 1) == !OFF.contains(asked.arguments().get(0))));
    }

    /** The board of which the scenario watches a pin of that name. */
    private Optional<String> boardWith(Term pin) {
        boolean level = pin.arguments().size() == 1 && ON.matcher(pin.arguments().get(0)).matches();
        return history.boards().stream().filter(each -> level && History.elements(each.get("watch"))
                .anyMatch(one -> one.getAsJsonObject().get("name").getAsString().equals(pin.functor())))
                .map(each -> each.get("name").getAsString()).findFirst();
    }

    // The answer

    /** A fact, with its time. */
    void link(TraceEvent at, String text) {
        answer.add(new Link(at.seconds(), at, text));
    }

    /** The last of an answer. */
    void cause(String text) {
        answer.add(new Link(0, null, text));
    }

    /** Where agents' lines came late or early, their times are bounded by those of the boards before and behind. */
    private void bound(List<Link> links) {
        double most = Double.MAX_VALUE;
        for (int i = 0; i < links.size(); i++) {
            Link link = links.get(i);
            links.set(i, link.at(Math.min(link.seconds, most)));
            most = link.by == null || link.isOfAgent() ? most : Math.min(most, link.seconds);
        }
        double least = 0;
        for (int i = links.size() - 1; i >= 0; i--) {
            Link link = links.get(i);
            links.set(i, link.at(Math.max(link.seconds, least)));
            least = Math.max(least, link.seconds);
        }
    }

    static String plan(JsonObject of) {
        String label = of.get("plan").getAsString();
        return (label.isEmpty() ? "" : "@" + label + " ") + "(" + of.get("place").getAsString() + ")";
    }

    private static String plan(TraceEvent of) {
        String label = of.textOrEmpty("plan");
        return (label.isEmpty() ? "" : "@" + label + " ") + "(" + of.textOrEmpty("place") + ")";
    }

    // Why it happened

    /** From something back to its first cause. */
    void chain(TraceEvent of) {
        int start = answer.size();
        turns.clear();
        back(of);
        bound(answer.subList(start, answer.size()));
    }

    private void back(TraceEvent of) {
        switch (of.name()) {
            case "pin" -> pin(of);
            case "agent-action" -> action(of);
            case "agent-message" -> message(of);
            case "rf-tx" -> sent(of);
            case "agent-believes" -> {
                link(of, of.text("agent") + " believes " + History.parsed(of, "belief").term());
                cause("it did so when the recording began");
            }
            default -> event(of);
        }
    }

    private void pin(TraceEvent pin) {
        String board = pin.board();
        link(pin, board + "'s " + pin.textOrEmpty("name") + " goes " + (pin.number("level") == 1 ? "on" : "off"));
        Optional<TraceEvent> action = History.last(history.onBoard(board, "host-action")
                .filter(each -> each.real("asked") <= pin.seconds()));
        if (action.isEmpty()) {
            cause(board + "'s sketch did it by itself: no action was asked for before");
            return;
        }
        String what = action.get().text("action");
        link(action.get(), pin.seconds() <= action.get().real("replied") ? "because of " + what
                + ", within which the pin changed" : "after " + what + ": loop() changed the pin later");
        for (String agent : history.agentsOf(board)) {
            Optional<TraceEvent> asked = history.same(action.get(), history.onBoard(board, "host-action")
                    .filter(each -> each.text("action").equals(what)).toList(), history.reached(agent, what).toList());
            if (asked.isPresent()) {
                action(asked.get());
                return;
            }
        }
        cause(history.agentsOf(board).isEmpty()
                ? board + "'s host asked for " + what + "; the log tells of no agent there"
                : "no agent of the log asked for " + what + ": another host did, or it was before the recording");
    }

    private void action(TraceEvent asked) {
        link(asked, asked.text("agent") + " asks its board for " + asked.text("action"));
        step(asked);
    }

    /** From a step of an intention to the event for which its plan was chosen. */
    private void step(TraceEvent of) {
        String agent = of.text("agent");
        if (!of.has("intention")) {
            cause(agent + " did so outside any plan");
            return;
        }
        link(of, "by the step " + of.textOrEmpty("step") + " of the plan " + plan(of));
        if (turns.merge(agent + plan(of), 1, Integer::sum) == MOST_TURNS) {
            cause("and so on: the plan " + plan(of) + " comes back to itself");
            return;
        }
        Optional<TraceEvent> choice = History.last(history.of(agent, "agent-choice").filter(history.before(of))
                .filter(each -> each.textOrEmpty("intention").equals(of.text("intention"))
                        && each.textOrEmpty("place").equals(of.textOrEmpty("place"))));
        choice.ifPresentOrElse(this::choice, () -> cause("the log does not reach back to the choice of that plan"));
    }

    private void choice(TraceEvent choice) {
        String agent = choice.text("agent");
        link(choice, agent + " chose the plan " + plan(choice) + " for " + History.parsed(choice, "trigger").brief());
        for (Map.Entry<String, JsonObject> each : History.asked(choice)) {
            if (!each.getValue().get("holds").getAsBoolean()) {
                link(choice, "not " + plan(each.getValue()) + ": " + falsePart(each.getValue()));
            }
        }
        history.of(agent, "agent-event").filter(each -> each.number("number") == choice.number("number"))
                .findFirst().ifPresentOrElse(this::event, () -> cause("the log does not reach back to that event"));
    }

    /** The first part of a context that was false, with the values then. */
    static String falsePart(JsonObject answer) {
        List<String> values = History.elements(answer.get("values")).map(each -> each.getAsString()).toList();
        return answer.get("part").getAsString() + " is false"
                + (values.isEmpty() ? "" : " with " + String.join("; ", values));
    }

    private void event(TraceEvent event) {
        String agent = event.text("agent");
        Term trigger = History.parsed(event, "trigger");
        String what = trigger.goal().isEmpty() ? trigger.sign().equals("+") ? agent + " believes " + trigger.term()
                : agent + " no longer believes " + trigger.term() : agent + " has the event " + trigger.brief();
        link(event, what);
        Matcher error = Pattern.compile("error\\((\\w+)\\).*error_msg\\(\"?(.*?)\"?\\)").matcher(event.text("trigger"));
        if (error.find()) {
            link(event, "because it failed: " + error.group(1) + ", " + error.group(2));
        }
        if (event.has("intention")) {
            step(event);
        } else if (trigger.source().equals("percept")) {
            percept(event, trigger);
        } else if (event.textOrEmpty("origin").equals("program")) {
            cause(trigger.term() + " is a " + (trigger.goal().isEmpty() ? "belief" : "goal") + " of the program");
        } else if (event.has("origin")) {
            cause(trigger.term() + " was there when the recording began");
        } else if (trigger.source().equals("page")) {
            cause(trigger.term() + " was given on the page");
        } else if (trigger.source().isEmpty() || trigger.source().equals("self")) {
            cause(trigger.term() + " was given from outside the program");
        } else {
            Optional<TraceEvent> message = History.last(history.of(agent, "agent-message")
                    .filter(each -> each.text("how").equals("passed") && each.text("from").equals(trigger.source())
                            && trigger.isSaidBy(each.text("content")) && each.seconds() <= event.seconds()));
            message.ifPresentOrElse(this::message, () -> cause("the agent " + trigger.source() + " told it"));
        }
    }

    private void percept(TraceEvent event, Term trigger) {
        String board = history.boardOf(event.text("agent"));
        if (trigger.functor().equals("port") || trigger.sign().equals("-")) {
            lost(event, board);
            return;
        }
        List<TraceEvent> readings = history.onBoard(board, "percepts").toList();
        int at = (int) readings.stream().filter(history.before(event)).count() - 1;
        while (at >= 0 && !tells(readings.get(at), trigger)) {
            at--;
        }
        // Its first one may have come after the agent's line.
        at = at >= 0 ? at : IntStream.range(0, readings.size()).filter(i -> tells(readings.get(i), trigger)).findFirst()
                .orElse(-1);
        while (at > 0 && tells(readings.get(at - 1), trigger)) {
            at--;
        }
        if (at < 0) {
            cause(board.isEmpty() ? "it perceived that without a board" : history.boards().isEmpty()
                    ? "the board at " + board + " told it" : board + "'s architecture perceived it");
            return;
        }
        TraceEvent reading = readings.get(at);
        link(reading, board + "'s board tells " + trigger.term());
        double since = at == 0 ? 0 : readings.get(at - 1).seconds();
        // A percept that has a pin's name tells of that pin; which action changes another one, only the sketch knows.
        Optional<TraceEvent> pin = History.last(history.onBoard(board, "pin").filter(history.before(reading))
                .filter(each -> each.textOrEmpty("name").equals(trigger.functor())));
        Optional<TraceEvent> sensor = History.last(history.onBoard(board, "command").filter(history.before(reading))
                .filter(each -> each.textOrEmpty("do").equals("sensor") && each.seconds() >= since));
        if (pin.isPresent()) {
            pin(pin.get());
        } else if (sensor.isPresent()) {
            link(sensor.get(), "the sensor changed before that reading");
            cause("the sensor at " + board + "'s " + sensor.get().text("pin") + " was set to "
                    + sensor.get().text("value"));
        } else {
            cause(board + "'s board told it, by its sensors");
        }
    }

    private static boolean tells(TraceEvent reading, Term trigger) {
        return History.percepts(reading).stream().anyMatch(each -> Term.parse(each).filter(trigger::matches)
                .isPresent());
    }

    /** Why a percept is believed no longer, or a port is off. */
    void lost(TraceEvent event, String board) {
        Optional<TraceEvent> port = History.last(history.all().filter(each -> each.board().equals(board)
                && (each.is("port") || each.is("fault") || each.is("percepts"))).filter(history.before(event)));
        port.ifPresent(each -> link(each, each.is("percepts") ? board + "'s board tells " + History.percepts(each)
                : board + "'s board: " + each.name() + " " + each.textOrEmpty("state") + each.textOrEmpty("do")));
        cause(port.map(each -> switch (each.textOrEmpty("state") + each.textOrEmpty("do")) {
            case "unplugged", "unplug" -> board + "'s board was unplugged";
            case "power-cut" -> board + "'s board lost its power";
            case "open", "plugged" -> board + "'s board is at its port";
            default -> board + "'s board tells it no longer";
        }).orElse(history.boards().isEmpty() ? "the board at " + board + " tells it no longer"
                : "nothing of its board is in the log"));
    }

    private void message(TraceEvent message) {
        String agent = message.text("agent");
        link(message, "the gate passed " + message.text("content") + " from " + message.text("from"));
        List<TraceEvent> all = history.onBoard(history.boardOf(agent), "host-handed")
                .filter(each -> each.text("id").equals(message.text("id"))
                        && each.textOrEmpty("content").equals(message.text("content")))
                .toList();
        // An agent's line may come before the board's, which takes another way.
        Optional<TraceEvent> handed = History.last(all.stream().filter(history.before(message)))
                .or(() -> all.stream().findFirst());
        Optional<TraceEvent> packet = handed.flatMap(history::packet);
        handed.ifPresent(each -> link(each, each.board() + "'s board handed it over, number " + each.text("number")));
        if (packet.isEmpty()) {
            cause(message.text("from") + " sent it");
            return;
        }
        sent(packet.get());
    }

    /** From a packet to who sent it. */
    private void sent(TraceEvent packet) {
        String board = packet.board();
        link(packet, "packet " + packet.text("packet") + " of " + board + (packet.textOrEmpty("sealed").equals("true")
                ? ", sealed" : ", not sealed"));
        if (board.equals("injector")) {
            cause("an attacker sent packet " + packet.text("packet"));
            return;
        }
        if (packet.textOrEmpty("kind").equals("acknowledgement") || packet.hops() > 0) {
            cause(board + "'s board " + (packet.hops() > 0 ? "relays it" : "acknowledges what it heard"));
            return;
        }
        Optional<TraceEvent> transmit = history.onBoard(board, "host-transmit")
                .filter(each -> history.packets(each).contains(packet)).findFirst();
        if (transmit.isPresent()) {
            TraceEvent asked = transmit.get();
            String content = asked.textOrEmpty("content");
            link(asked, "attempt " + (1 + history.packets(asked).indexOf(packet)) + " of message "
                    + asked.text("number") + " to " + asked.text("destination"));
            for (String agent : history.agentsOf(board)) {
                Stream<TraceEvent> same = history.of(agent, "agent-sends").filter(each -> each.text("content")
                        .equals(content));
                Optional<TraceEvent> sends = history.same(asked, history.onBoard(board, "host-transmit")
                        .filter(each -> each.textOrEmpty("content").equals(content)).toList(), same.toList());
                if (sends.isPresent()) {
                    link(sends.get(), agent + " sends " + content);
                    step(sends.get());
                    return;
                }
            }
        }
        cause("the host of " + board + "'s board sent it");
    }
}
