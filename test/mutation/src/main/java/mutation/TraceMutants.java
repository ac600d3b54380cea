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

/** All small changes of a trace: of its order, of times, of fields, and of the bytes on the air. */
final class TraceMutants {

    /** A slot of 16 bits at 2000 bit/s, and a bit. */
    private static final double SLOT = 0.008;
    private static final double BIT = 0.0005;
    private static final double SECOND = 1;
    private static final double MOMENT = 0.001;
    /** Quiet slots that are too few for whoever is no acknowledgement, and for all. */
    private static final double FEW_SLOTS = 4;
    private static final double NO_SLOT = 0.5;
    /** More than an acknowledgement ever waits on quiet air. */
    private static final int MANY_SLOTS = 16;
    private static final List<String> OUTCOMES = List.of("sent", "delivered", "undelivered");
    private static final List<String> KINDS = List.of("unicast", "multicast", "broadcast", "piece", "acknowledgement");

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
        enter("dropped", line, "", (trace, it) -> trace.events().remove(it));
        if (!is(event, "host-id")) {
            enter("told twice", line, "", (trace, it) -> trace.events().add(line + 1, it.deepCopy()));
        }
        if (isOwn(event) && !is(event, "host-id")) {
            next(line).ifPresent(other -> enter("swapped with the board's next event", line,
                    called(genuine.events().get(other)),
                    (trace, it) -> swap(trace, it, trace.events().get(other))));
        }
        if (isOwn(event) && !is(event, "rf-tx") && !is(event, "host-id")) {
            enter("a second later", line, "", (trace, it) -> trace.move(it, SECOND));
            if (number(event, "t") > SECOND) {
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
            if (event.has(field)) {
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
        if (event.has("content")) {
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
        enter("packet dropped", number, (trace, it) -> trace.events().removeAll(it.all()));
        enter("packet repeated at once", number, (trace, it) -> {
            double later = it.end() - it.start() + SLOT;
            for (JsonObject event : it.all()) {
                JsonObject again = event.deepCopy();
                trace.events().add(again);
                trace.move(again, later);
            }
        });
        for (int bits : List.of(1, -1)) {
            enter("airtime a bit " + (bits > 0 ? "longer" : "shorter"), number, (trace, it) -> {
                it.sent().addProperty("bits", (int) number(it.sent(), "bits") + bits);
                set(it.sent(), "end", it.end() + bits * BIT);
                set(it.sent(), "t", number(it.sent(), "t") + bits * BIT);
            });
        }
        packets.stream().filter(before -> before.payload().equals(packet.payload())
                && before.board().equals(packet.board()) && before.end() < packet.start())
                .reduce((first, second) -> second)
                .ifPresent(before -> moved("repeat without patience", number,
                        before.end() + 3 * SLOT - packet.start()));
        boolean answer = text(packet.sent(), "kind").equals("acknowledgement");
        packets.stream().filter(before -> before.end() < packet.start() && before.isHeardBy(packet.board()))
                .reduce((first, second) -> second).ifPresent(before -> {
                    for (double slots : List.of(FEW_SLOTS, NO_SLOT)) {
                        if (packet.start() - before.end() > slots * SLOT + MOMENT && (!answer || slots == NO_SLOT)) {
                            moved("after " + slots + " quiet slots", number,
                                    before.end() + slots * SLOT - packet.start());
                        }
                    }
                    moved("into the packet before", number, (before.start() + before.end()) / 2 - packet.start());
                    if (answer) {
                        moved("acknowledgement later by " + MANY_SLOTS + " slots", number, MANY_SLOTS * SLOT);
                    }
                });
        packets.stream().filter(next -> next.start() > packet.end() && next.isHeardBy(packet.board())).findFirst()
                .ifPresent(next -> moved("into the next packet", number,
                        (next.start() + next.end()) / 2 - packet.start()));
    }

    private void bytes(int number) {
        Trace.Packet packet = packets.get(number);
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
     * Something that the model does not speak of, a reset of a board that has no past, or an id that is known or under
     * which nothing is sent.
     */
    private boolean tellsNothing(int line) {
        JsonObject event = genuine.events().get(line);
        List<JsonObject> before = of(text(event, "board"), genuine.events().subList(0, line));
        List<JsonObject> after = of(text(event, "board"), genuine.events().subList(line + 1, lines.size()));
        return switch (text(event, "event")) {
            case "reset" -> before.stream().noneMatch(other -> text(other, "event").startsWith("rf-"));
            case "host-id" -> before.stream()
                    .anyMatch(other -> is(other, "host-id") && text(other, "id").equals(text(event, "id")))
                    || after.stream().takeWhile(other -> !is(other, "host-id")).noneMatch(other -> is(other, "rf-tx"));
            case "rf-tx", "rf-rx", "rf-damaged" -> false;
            default -> !text(event, "event").startsWith("host-");
        };
    }

    private static List<JsonObject> of(String board, List<JsonObject> events) {
        return events.stream().filter(event -> text(event, "board").equals(board)).toList();
    }

    /** What a board itself does, in the order in which it does it. */
    private static boolean isOwn(JsonObject event) {
        return is(event, "rf-tx") || is(event, "reset") || text(event, "event").startsWith("host-");
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
        values.remove("");
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
