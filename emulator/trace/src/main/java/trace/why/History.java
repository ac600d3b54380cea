package trace.why;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import trace.TraceEvent;

/** The events of a run, and which of them belong together. */
final class History {

    /** What agents print, in a run that is tested and on the live page. */
    static final Set<String> PRINTS = Set.of("agent-prints", "said", "warned");
    private static final int HANDED_NUMBERS = 256;

    private final List<TraceEvent> events;

    History(List<TraceEvent> events) {
        Ordinals ordinals = new Ordinals();
        this.events = events.stream().map(ordinals::number).toList();
    }

    Stream<TraceEvent> all() {
        return events.stream();
    }

    /** The lines of an agent, of one kind, such as {@code agent-choice}. */
    Stream<TraceEvent> of(String agent, String kind) {
        return all().filter(each -> each.is(kind) && each.text("agent").equals(agent));
    }

    Stream<TraceEvent> onBoard(String board, String kind) {
        return all().filter(each -> each.is(kind, board));
    }

    static Optional<TraceEvent> last(Stream<TraceEvent> of) {
        return of.reduce((first, second) -> second);
    }

    /** Whether something stands before an event in the log. */
    Predicate<TraceEvent> before(TraceEvent event) {
        int at = events.indexOf(event);
        Set<TraceEvent> those = new LinkedHashSet<>(events.subList(0, at));
        return those::contains;
    }

    Predicate<TraceEvent> after(TraceEvent event) {
        Set<TraceEvent> those = new LinkedHashSet<>(events.subList(events.indexOf(event) + 1, events.size()));
        return those::contains;
    }

    List<String> agents() {
        return all().filter(each -> each.is("agent-settings") || each.is("agent-plan"))
                .map(each -> each.text("agent")).distinct().toList();
    }

    /** The boards' descriptions, by the scenario. */
    List<JsonObject> boards() {
        return all().filter(each -> each.is("scenario")).findFirst().map(History::boards).orElse(List.of());
    }

    static List<JsonObject> boards(TraceEvent scenario) {
        return elements(scenario.json("boards")).map(JsonElement::getAsJsonObject).toList();
    }

    static Stream<JsonElement> elements(JsonElement array) {
        return array.isJsonArray() ? StreamSupport.stream(array.getAsJsonArray().spliterator(), false)
                : Stream.empty();
    }

    /** What an agent wished of its board last. */
    Optional<TraceEvent> settings(String agent) {
        return last(of(agent, "agent-settings"));
    }

    /** The board at an agent's port; a real one has its port's name. Empty without a port. */
    String boardOf(String agent) {
        return board(settings(agent).map(each -> each.text("port")).orElse(""), boards());
    }

    /** The board at a port; of two whose ports end alike that which more of it names. Real ones have no trace. */
    static String board(String port, List<JsonObject> boards) {
        return port.isEmpty() || boards.isEmpty() ? port : boards.stream().filter(each -> each.has("port")
                && ("/" + port).endsWith("/" + each.get("port").getAsString()))
                .max(Comparator.comparingInt(each -> each.get("port").getAsString().length()))
                .map(each -> each.get("name").getAsString()).orElse("");
    }

    /** The agents whose board that is. */
    List<String> agentsOf(String board) {
        return agents().stream().filter(each -> boardOf(each).equals(board)).toList();
    }

    static Term parsed(TraceEvent event, String field) {
        return Term.parse(event.text(field)).orElse(new Term("", "", "", List.of(), List.of()));
    }

    /** The events of an agent with that sign whose term is an instance. */
    List<TraceEvent> events(String agent, String sign, Term pattern) {
        return of(agent, "agent-event").filter(each -> {
            Term trigger = parsed(each, "trigger");
            return trigger.sign().equals(sign) && trigger.goal().equals(pattern.goal()) && pattern.matches(trigger);
        }).toList();
    }

    /** All that an agent has ever believed, without annotations. */
    Set<Term> believed(String agent) {
        Set<Term> all = new LinkedHashSet<>();
        of(agent, "agent-believes").map(each -> parsed(each, "belief")).forEach(all::add);
        of(agent, "agent-event").map(each -> parsed(each, "trigger"))
                .filter(each -> each.goal().isEmpty() && each.sign().equals("+")).forEach(all::add);
        return all;
    }

    /** The one with the nearest name, if it is near. */
    static Optional<Term> nearest(Term wanted, Stream<Term> all) {
        int most = Math.max(1, wanted.functor().length() / 2);
        return all.filter(each -> !each.functor().isEmpty() && wanted.distance(each) <= most)
                .min(Comparator.comparingInt((Term each) -> wanted.distance(each))
                        .thenComparing(each -> !each.arguments().equals(wanted.arguments())));
    }

    /** The percepts that a reading has. */
    static List<String> percepts(TraceEvent reading) {
        return reading.texts("percepts");
    }

    // Packets

    /** The packets of a message that a board was asked to transmit, by the number of its turn. */
    List<TraceEvent> packets(TraceEvent transmit) {
        String board = transmit.board();
        double asked = transmit.real("asked");
        List<TraceEvent> packets = new ArrayList<>();
        int turn = -1;
        for (TraceEvent each : events) {
            if (each.is("point", board) && each.text("name").equals("TURN")) {
                turn = each.number("number");
            } else if (each.is("rf-tx", board) && each.real("start") >= asked && turn == transmit.number("number")
                    && !each.text("kind").equals("acknowledgement")) {
                        packets.add(each);
                    }
        }
        return packets;
    }

    /** The packet by which a message came that a board has handed over, by the messages that it has queued. */
    Optional<TraceEvent> packet(TraceEvent handed) {
        return last(all().takeWhile(each -> each != handed).filter(each -> each.is("point", handed.board())
                && each.text("name").equals("QUEUED") && each.has("packet")
                && each.number(Ordinals.NTH) % HANDED_NUMBERS == handed.number("number")))
                .flatMap(queued -> all().filter(sent -> sent.is("rf-tx")
                        && sent.number("packet") == queued.number("packet")).findFirst());
    }

    /**
     * The one of others that is the same request, as agent and board have counted; from the end, if the log lacks its
     * beginning.
     */
    Optional<TraceEvent> same(TraceEvent event, List<TraceEvent> its, List<TraceEvent> others) {
        boolean whole = all().noneMatch(each -> each.is(RunLog.LEFT_OUT));
        if (whole && event.has(Ordinals.NTH)) {
            return others.stream().filter(each -> each.has(Ordinals.NTH)
                    && each.number(Ordinals.NTH) == event.number(Ordinals.NTH)).findFirst();
        }
        int at = its.indexOf(event);
        if (at < 0) {
            return Optional.empty();
        }
        at += whole ? 0 : others.size() - its.size();
        return at >= 0 && at < others.size() ? Optional.of(others.get(at)) : Optional.empty();
    }

    /** What a board has done with a packet: what was damaged, received and counted. */
    List<TraceEvent> atBoard(String board, int packet) {
        return all().filter(each -> each.board().equals(board) && each.has("packet") && !each.is("rf-tx")
                && each.number("packet") == packet).toList();
    }

    /** How an action of an agent ended, if it has. */
    Optional<TraceEvent> outcome(TraceEvent request) {
        return of(request.text("agent"), "agent-performed")
                .filter(each -> each.number("request") == request.number("request")).findFirst();
    }

    /** Actions of an agent that may have reached its board, in their order. */
    Stream<TraceEvent> reached(String agent, String action) {
        return of(agent, "agent-action").filter(each -> each.text("action").equals(action))
                .filter(each -> outcome(each).filter(Ordinals::isUnreached).isEmpty());
    }

    /** The last line with all of these fields. */
    Optional<TraceEvent> like(JsonObject fields) {
        return last(all().filter(each -> fields.entrySet().stream()
                .allMatch(field -> each.json(field.getKey()).equals(field.getValue()))));
    }

    static List<Map.Entry<String, JsonObject>> asked(TraceEvent choice) {
        return elements(choice.json("asked")).map(JsonElement::getAsJsonObject)
                .map(each -> Map.entry(each.get("place").getAsString(), each)).toList();
    }
}
