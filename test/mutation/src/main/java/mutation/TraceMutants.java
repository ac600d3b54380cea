package mutation;

import static mutation.Trace.is;
import static mutation.Trace.number;
import static mutation.Trace.set;
import static mutation.Trace.text;

import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * All small changes of a trace: of its order, of times, of fields, and of the bytes on the air. Left out are those
 * after which it may still be genuine, as far as the trace tells that: a change that boards or hosts are free to make
 * is no mutant.
 */
final class TraceMutants {

    /** A slot of 16 bits at 2000 bit/s, and a bit. */
    private static final double SLOT = 0.008;
    private static final double BIT = 0.0005;
    private static final double SECOND = 1;
    private static final double MOMENT = 0.001;
    /** Quiet slots that are too few for whoever is no acknowledgement, and for all. */
    private static final double FEW_SLOTS = 4;
    private static final double NO_SLOT = 0.5;
    /** More than an acknowledgement ever waits on quiet air, even of a busy board. */
    private static final int MANY_SLOTS = 60;
    /** So long before and after a reset, a fault or a command the trace may not tell what boards hear, in seconds. */
    private static final double DISTURBED = 2;
    /** A request that is lost is repeated sooner, in seconds. */
    private static final double OTHER_REQUEST = 2;
    /** A board that has not heard its acknowledgement sends again sooner, in seconds. */
    private static final double OTHER_ATTEMPT = 5;
    /** A unicast that was sent as often is undelivered. */
    private static final int ATTEMPTS = 8;
    /** Whoever sends by a command: he may send anything. */
    private static final String INJECTOR = "injector";
    /** What hosts and boards may say as often as they like. */
    private static final Set<String> REPEATED =
            Set.of("host-handed", "host-taking", "host-outcome", "reset", "host-id");
    private static final List<String> OUTCOMES = List.of("sent", "delivered", "undelivered");
    private static final List<String> KINDS =
            List.of("unicast", "multicast", "broadcast", "fragment", "acknowledgement");

    private final List<String> lines;
    private final Trace genuine;
    private final List<Trace.Packet> packets;
    private final Random random;
    private final List<TraceMutant> mutants = new ArrayList<>();

    private TraceMutants(List<String> lines, long seed) {
        this.lines = lines;
        genuine = new Trace(lines);
        packets = genuine.packets();
        random = new Random(seed);
    }

    /** Every mutant of a trace; the seed decides which bits and which other names are taken. */
    static List<TraceMutant> of(List<String> lines, long seed) {
        TraceMutants all = new TraceMutants(lines, seed);
        for (int i = 0; i < lines.size(); i++) {
            all.order(i);
            all.fields(i);
        }
        for (int i = 0; i < all.packets.size(); i++) {
            all.times(i);
            all.bytes(i);
        }
        return List.copyOf(all.mutants);
    }

    private void order(int line) {
        JsonObject event = genuine.events().get(line);
        if (tellsNothing(line)) {
            return;
        }
        if (isMissed(line)) {
            enter("dropped", line, "", (trace, it) -> trace.events().remove(it));
        }
        if (!REPEATED.contains(text(event, "event"))) {
            enter("told twice", line, "", (trace, it) -> trace.events().add(line + 1, it.deepCopy()));
        }
        if (isOwn(event) && !is(event, "host-id")) {
            next(line).filter(other -> isOrdered(event, genuine.events().get(other)))
                    .ifPresent(other -> enter("swapped with the board's next event", line,
                            called(genuine.events().get(other)),
                            (trace, it) -> swap(trace, it, trace.events().get(other))));
        }
        if (isOwn(event) && !is(event, "rf-tx") && !is(event, "host-id")) {
            if (isOvertaken(event, SECOND)) {
                enter("a second later", line, "", (trace, it) -> trace.move(it, SECOND));
            }
            if (number(event, "t") > SECOND && isOvertaken(event, -SECOND)) {
                enter("a second earlier", line, "", (trace, it) -> trace.move(it, -SECOND));
            }
        }
        if (is(event, "host-handed")) {
            heardBefore(event).ifPresent(packet -> enter("before its packet", line, "",
                    (trace, it) -> trace.move(it, packet.start() - MOMENT - number(it, "t"))));
        }
        if (is(event, "host-outcome")) {
            asked(line).ifPresent(asked -> enter("before its packet", line, "",
                    (trace, it) -> trace.move(it, number(asked, "t") + MOMENT - number(it, "t"))));
        }
    }

    private void fields(int line) {
        JsonObject event = genuine.events().get(line);
        if (tellsNothing(line)) {
            return;
        }
        for (String field : List.of("board", "from", "destination", "origin", "id")) {
            if (event.has(field) && (!field.equals("destination") || !isUnknown(line))) {
                other(field, event).ifPresent(other -> enter("another " + field, line, "",
                        (trace, it) -> it.addProperty(field, other)));
            }
        }
        if (event.has("kind")) {
            other(KINDS, text(event, "kind"))
                    .ifPresent(other -> enter("another kind", line, "",
                            (trace, it) -> it.addProperty("kind", other)));
        }
        if (event.has("number")) {
            enter("another number", line, "", (trace, it) -> it.addProperty("number", it.get("number").getAsInt() + 1));
        }
        if (event.has("content") && !isUnknown(line)) {
            enter("another content", line, "", (trace, it) -> it.addProperty("content", text(it, "content") + "00"));
        }
        if (is(event, "host-outcome")) {
            for (String outcome : OUTCOMES) {
                if (!outcome.equals(text(event, "outcome"))) {
                    enter("another outcome", line, text(event, "outcome") + " as " + outcome,
                            (trace, it) -> it.addProperty("outcome", outcome));
                }
            }
        }
        if (is(event, "reset")) {
            enter("another why", line, "", (trace, it) -> it.addProperty("why",
                    text(it, "why").equals("power") ? "port opened" : "power"));
        }
        if (is(event, "rf-rx") && event.has("end")) {
            enter("heard before it is sent", line, "", (trace, it) -> {
                set(it, "end", number(it, "end") - SLOT);
                set(it, "t", number(it, "t") - SLOT);
                trace.place(it);
            });
        }
        if (event.has("payload")) {
            for (Region region : Region.of(text(event, "kind"), text(event, "payload"))) {
                if (is(event, "rf-rx")) {
                    String changed = region.flipped(text(event, "payload"), random);
                    enter("a bit changed as heard: " + region.name(), line, "",
                            (trace, it) -> it.addProperty("payload", changed));
                }
            }
        }
    }

    private void times(int number) {
        Trace.Packet packet = packets.get(number);
        if (packet.board().equals(INJECTOR)) {
            return;
        }
        if (isMissed(packet)) {
            enter("packet dropped", number, (trace, it) -> trace.events().removeAll(it.all()));
        }
        enter("packet repeated at once", number, (trace, it) -> {
            double later = it.end() - it.start() + SLOT;
            for (JsonObject event : it.all()) {
                JsonObject again = event.deepCopy();
                trace.events().add(again);
                trace.move(again, later);
            }
        });
        // A reset soon after may have broken off its trailer.
        for (int bits : isCalm(packet.start(), packet.end()) ? List.of(1, -1) : List.of(1)) {
            enter("airtime a bit " + (bits > 0 ? "longer" : "shorter"), number, (trace, it) -> {
                it.sent().addProperty("bits", (int) number(it.sent(), "bits") + bits);
                set(it.sent(), "end", it.end() + bits * BIT);
                set(it.sent(), "t", number(it.sent(), "t") + bits * BIT);
            });
        }
        packets.stream().filter(before -> before.payload().equals(packet.payload())
                && before.board().equals(packet.board()) && before.end() < packet.start())
                .reduce((first, second) -> second)
                .filter(before -> before.end() + FEW_SLOTS * SLOT < packet.start()
                        && isSure(before, packet, before.end() + 3 * SLOT))
                .ifPresent(before -> moved("repeat without patience", number,
                        before.end() + 3 * SLOT - packet.start()));
        boolean answer = text(packet.sent(), "kind").equals("acknowledgement");
        packets.stream().filter(before -> before.end() < packet.start() && before.isHeardBy(packet.board()))
                .reduce((first, second) -> second).ifPresent(before -> {
                    for (double slots : List.of(FEW_SLOTS, NO_SLOT)) {
                        if (packet.start() - before.end() > slots * SLOT + MOMENT && (!answer || slots == NO_SLOT)
                                && !before.sent().has("trailer")
                                && isSure(before, packet, before.end() + slots * SLOT)) {
                            moved("after " + slots + " quiet slots", number,
                                    before.end() + slots * SLOT - packet.start());
                        }
                    }
                    if (isSure(before, packet, before.middle())) {
                        moved("into the packet before", number, before.middle() - packet.start());
                    }
                    if (answer && isSure(before, packet, packet.start() + MANY_SLOTS * SLOT)) {
                        moved("acknowledgement later by " + MANY_SLOTS + " slots", number, MANY_SLOTS * SLOT);
                    }
                });
        packets.stream().filter(next -> next.start() > packet.end() && next.isHeardBy(packet.board())).findFirst()
                .filter(next -> isSure(next, packet, next.middle()))
                .ifPresent(next -> moved("into the next packet", number, next.middle() - packet.start()));
    }

    private void bytes(int number) {
        Trace.Packet packet = packets.get(number);
        if (packet.board().equals(INJECTOR)) {
            return;
        }
        for (Region region : Region.of(text(packet.sent(), "kind"), packet.payload())) {
            String flipped = region.flipped(packet.payload(), random);
            String zeroed = region.zeroed(packet.payload());
            enter("a bit changed as sent: " + region.name(), number,
                    (trace, it) -> payload(trace.packets(), it.payload(),
                            flipped, same -> same.start() == packet.start()));
            enter("a bit changed in each repeat: " + region.name(), number,
                    (trace, it) -> payload(trace.packets(), it.payload(), flipped, same -> true));
            if (!zeroed.equals(packet.payload())) {
                enter("zeros in each repeat: " + region.name(), number,
                        (trace, it) -> payload(trace.packets(), it.payload(), zeroed, same -> true));
            }
        }
        Region.nonce(text(packet.sent(), "kind"), packet.payload()).ifPresent(nonce -> packets.stream()
                .filter(before -> before.start() < packet.start() && before.board().equals(packet.board())
                        && !before.payload().equals(packet.payload()))
                .filter(before -> Region.nonce(text(before.sent(), "kind"), before.payload()).isPresent())
                .reduce((first, second) -> second)
                .ifPresent(before -> {
                    String old = Region.nonce(text(before.sent(), "kind"), before.payload()).orElseThrow()
                            .in(before.payload());
                    if (!old.equals(nonce.in(packet.payload()))) {
                        String reused = nonce.with(packet.payload(), old);
                        enter("nonce of the message before", number,
                                (trace, it) -> payload(trace.packets(), it.payload(), reused, same -> true));
                    }
                }));
    }

    private static void payload(List<Trace.Packet> packets, String from, String to, Predicate<Trace.Packet> which) {
        for (Trace.Packet packet : packets) {
            if (packet.payload().equals(from) && which.test(packet)) {
                packet.all().stream().filter(event -> event.has("payload"))
                        .forEach(event -> event.addProperty("payload", to));
            }
        }
    }

    /**
     * Something that the model does not speak of, what a host does with keys and the radio when it wants, what a
     * injector sends, a reset of a board that has no past, or an id that is known or under
     * which nothing is sent.
     */
    private boolean tellsNothing(int line) {
        JsonObject event = genuine.events().get(line);
        if (text(event, "board").equals(INJECTOR) || text(event, "from").equals(INJECTOR)) {
            return true;
        }
        List<JsonObject> before = of(text(event, "board"), genuine.events().subList(0, line));
        List<JsonObject> after = of(text(event, "board"), genuine.events().subList(line + 1, lines.size()));
        return switch (text(event, "event")) {
            case "reset" -> before.stream().noneMatch(other -> text(other, "event").startsWith("rf-"))
                    || before.stream().filter(TraceMutants::isOwn).reduce((first, second) -> second)
                            .filter(other -> !is(other, "reset")).isEmpty();
            case "host-id" -> before.stream()
                    .anyMatch(other -> is(other, "host-id") && text(other, "id").equals(text(event, "id")))
                    || after.stream().takeWhile(other -> !is(other, "host-id")).noneMatch(other -> is(other, "rf-tx"));
            case "host-key", "host-radio", "host-relaying", "host-nothing" -> true;
            case "rf-tx", "rf-rx", "rf-damaged" -> false;
            default -> !text(event, "event").startsWith("host-");
        };
    }

    /** What else this board and its host do from here on, up to a reset. */
    private Stream<JsonObject> then(int line) {
        return of(text(genuine.events().get(line), "board"), genuine.events().subList(line + 1, lines.size())).stream()
                .takeWhile(other -> !is(other, "reset"));
    }

    /** Whether a board could not go on so without this event. */
    private boolean isMissed(int line) {
        JsonObject event = genuine.events().get(line);
        return switch (text(event, "event")) {
            // A host tells with the next what it has not been heard to say, and so does a board.
            case "host-taking" -> then(line).filter(other -> text(other, "event").startsWith("host-tak")).findFirst()
                    .filter(other -> is(other, "host-taken") && isSame("number", event, other)).isPresent();
            case "host-taken" -> then(line).noneMatch(other -> is(other, "host-taken"))
                    && then(line).anyMatch(other -> isTold(other) && apart(event, other) > OTHER_REQUEST);
            case "host-outcome" -> then(line)
                    .anyMatch(other -> is(other, "host-handed") && apart(event, other) > OTHER_ATTEMPT);
            // With the next one all that it has done is gone as well.
            case "reset" -> then(line).anyMatch(TraceMutants::isOwn);
            // No trace tells who is in range.
            case "rf-damaged" -> false;
            case "rf-rx" -> isActedUpon(line);
            // A trace may end before it tells of a packet that others have heard already.
            case "rf-tx" -> number(genuine.events().get(lines.size() - 1), "t") > number(event, "end") + SECOND;
            default -> !isUnknown(line);
        };
    }

    /** Whether what comes here, and has not come before, is what its board then tells its host of. */
    private boolean isActedUpon(int line) {
        JsonObject event = genuine.events().get(line);
        boolean comesOnce = packets.stream().filter(packet -> packet.payload().equals(text(event, "payload"))
                && packet.isHeardBy(text(event, "board"))).count() == 1;
        return comesOnce && then(line)
                .takeWhile(other -> !text(other, "event").startsWith("rf-"))
                .anyMatch(other -> text(event, "kind").equals("acknowledgement")
                        ? text(other, "outcome").equals("delivered")
                        : is(other, "host-handed") && isSame("origin", event, other)
                                && isSame("destination", event, other));
    }

    /** Whether it may have been without effect: a host asks for what its board never sends, as a reset comes before. */
    private boolean isUnknown(int line) {
        JsonObject event = genuine.events().get(line);
        return is(event, "host-transmit")
                && then(line).noneMatch(other -> is(other, "host-outcome") && isSame("number", event, other));
    }

    /** Whether boards could not go on so without this packet: of others there are repeats that are enough. */
    private boolean isMissed(Trace.Packet packet) {
        long copies = packets.stream().filter(other -> other.payload().equals(packet.payload())
                && other.board().equals(packet.board())).count();
        boolean toMany = List.of("multicast", "broadcast").contains(text(packet.sent(), "kind"));
        // A reset may end a message before anybody has answered.
        boolean isNoMatter = text(packet.sent(), "kind").equals("unicast")
                && then(genuine.events().indexOf(packet.sent())).noneMatch(other -> is(other, "host-outcome"));
        return !isNoMatter && (toMany || copies == 1 || copies == ATTEMPTS);
    }

    /** Whether an event that comes sooner or later is no longer where it was among what it has to do with. */
    private boolean isOvertaken(JsonObject event, double seconds) {
        double from = number(event, "t") + Math.min(0, seconds);
        double to = number(event, "t") + Math.max(0, seconds);
        if (seconds < 0 && is(event, "host-outcome")) {
            return true;
        }
        if (seconds < 0 && is(event, "host-handed")
                && heardBefore(event).filter(packet -> packet.end() > from).isPresent()) {
            return true;
        }
        return genuine.events().stream()
                .filter(other -> other != event && isOwn(other) && isSame("board", event, other)
                        && number(other, "t") >= from && number(other, "t") <= to)
                .anyMatch(other -> !(is(other, "rf-tx") && !is(event, "reset"))
                        && isOrdered(seconds < 0 ? other : event, seconds < 0 ? event : other));
    }

    /** Whether a board and its host can have done these two in this order only. */
    private static boolean isOrdered(JsonObject first, JsonObject second) {
        Set<String> names = Set.copyOf(List.of(text(first, "event"), text(second, "event")));
        boolean same = isSame("number", first, second);
        if (names.contains("host-transmit") && names.size() == 2) {
            return names.contains("reset") || names.contains("rf-tx") || names.contains("host-outcome") && same;
        }
        if (names.contains("host-taken")) {
            return names.size() == 1 ? !same : names.contains("reset") || names.contains("rf-tx")
                    || names.contains("host-taking") && same;
        }
        if (names.contains("host-taking")) {
            return names.contains("reset") || names.contains("rf-tx") || names.contains("host-handed") && same;
        }
        if (isTold(first) && isTold(second)) {
            return names.equals(Set.of("host-handed"));
        }
        // What a reset breaks off is told behind it.
        return !names.equals(Set.of("reset"))
                && (!is(second, "rf-tx") || number(second, "start") > number(first, "t"));
    }

    /** What a board tells its host when that asks: all that there is. */
    private static boolean isTold(JsonObject event) {
        return is(event, "host-handed") || is(event, "host-outcome");
    }

    private static double apart(JsonObject first, JsonObject second) {
        return number(second, "t") - number(first, "t");
    }

    private static boolean isSame(String field, JsonObject first, JsonObject second) {
        return text(first, field).equals(text(second, field));
    }

    /**
     * Whether it is known that a packet's board hears another one, if it begins at a time: nothing disturbs, and nobody
     * else sends.
     */
    private boolean isSure(Trace.Packet heard, Trace.Packet packet, double start) {
        double from = Math.min(heard.start(), start);
        double to = Math.max(heard.end(), start + packet.end() - packet.start());
        return isCalm(from, to) && packets.stream().filter(other -> other != heard && other != packet)
                .noneMatch(other -> other.start() < to && other.end() > from);
    }

    private boolean isCalm(double from, double to) {
        return genuine.events().stream()
                .filter(event -> is(event, "reset") || is(event, "fault") || is(event, "command"))
                .noneMatch(event -> number(event, "t") > from - DISTURBED && number(event, "t") < to + DISTURBED);
    }

    private static List<JsonObject> of(String board, List<JsonObject> events) {
        return events.stream().filter(event -> text(event, "board").equals(board)).toList();
    }

    /** What a board itself does, in the order in which it does it. */
    private static boolean isOwn(JsonObject event) {
        return is(event, "rf-tx") || is(event, "reset")
                || text(event, "event").startsWith("host-") && !is(event, "host-nothing");
    }

    private Optional<Integer> next(int line) {
        JsonObject event = genuine.events().get(line);
        for (int i = line + 1; i < lines.size(); i++) {
            JsonObject other = genuine.events().get(i);
            if (isOwn(other) && text(other, "board").equals(text(event, "board"))) {
                boolean same = event.has("payload") && text(event, "payload").equals(text(other, "payload"));
                return same || tellsNothing(i) ? Optional.empty() : Optional.of(i);
            }
        }
        return Optional.empty();
    }

    private static void swap(Trace trace, JsonObject first, JsonObject second) {
        double between = number(second, "t") - number(first, "t");
        trace.move(first, between);
        trace.move(second, -between);
    }

    /** The first time that what was handed over was sent. */
    private Optional<Trace.Packet> heardBefore(JsonObject handed) {
        List<Trace.Packet> heard = packets.stream().filter(packet -> packet.end() < number(handed, "t")
                && packet.isHeardBy(text(handed, "board"))
                && text(packet.sent(), "origin").equals(text(handed, "origin"))).toList();
        return heard.stream().filter(packet -> packet.payload().equals(heard.get(heard.size() - 1).payload()))
                .findFirst();
    }

    private Optional<JsonObject> asked(int outcome) {
        JsonObject event = genuine.events().get(outcome);
        return genuine.events().subList(0, outcome).stream()
                .filter(other -> is(other, "host-transmit") && text(other, "board").equals(text(event, "board"))
                        && text(other, "number").equals(text(event, "number")))
                .reduce((first, second) -> second);
    }

    /** Another value that this field has in this trace. */
    private Optional<String> other(String field, JsonObject event) {
        Set<String> values = new LinkedHashSet<>();
        for (JsonObject each : genuine.events()) {
            if (each.has(field) && text(each, field).length() == text(event, field).length() || field.equals("board")) {
                values.add(text(each, field));
            }
        }
        values.removeAll(List.of("", INJECTOR));
        return other(List.copyOf(values), text(event, field));
    }

    private Optional<String> other(List<String> values, String than) {
        List<String> others = values.stream().filter(value -> !value.equals(than)).toList();
        return others.isEmpty() ? Optional.empty() : Optional.of(others.get(random.nextInt(others.size())));
    }

    private void moved(String operator, int number, double seconds) {
        enter(operator, number, (trace, it) -> it.all().forEach(event -> trace.move(event, seconds)));
    }

    private void enter(String operator, int packet, BiConsumer<Trace, Trace.Packet> change) {
        JsonObject sent = packets.get(packet).sent();
        enter(operator, genuine.events().indexOf(sent), "",
                (trace, it) -> change.accept(trace, trace.packets().get(packet)));
    }

    private void enter(String operator, int line, String detail, BiConsumer<Trace, JsonObject> change) {
        mutants.add(new TraceMutant(operator, called(genuine.events().get(line)), line + 1, detail, () -> {
            Trace trace = new Trace(lines);
            change.accept(trace, trace.events().get(line));
            return trace.lines();
        }));
    }

    private static String called(JsonObject event) {
        return (text(event, "event") + " " + text(event, "kind") + " " + text(event, "answers")).strip();
    }
}
