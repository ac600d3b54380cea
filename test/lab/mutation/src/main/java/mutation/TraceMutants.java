package mutation;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javino.protocol.Counter;
import trace.TraceEvent;

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
    /** Seconds before and after a reset, a fault or a command in which the trace may not tell what boards hear. */
    private static final double DISTURBED = 2;
    /** A request that is lost is repeated sooner, in seconds. */
    private static final double OTHER_REQUEST = 2;
    /** A board that has not heard its acknowledgement sends again sooner, in seconds. */
    private static final double OTHER_ATTEMPT = 5;
    /** A unicast that was sent as often is undelivered. */
    private static final int ATTEMPTS = 8;
    /** Whoever sends by a command: he may send anything. */
    private static final String INJECTOR = "injector";
    /** The events that hosts and boards may tell as often as they like. */
    private static final Set<String> REPEATED =
            Set.of("host-handed", "host-taking", "host-outcome", "reset", "host-id");
    private static final List<String> OPERANDS =
            List.of("number", "message", "key", "slots", "rounds", "attempts", "pending",
                    "have", "nonce", "kept", "low", "place", "path", "distance", "doubt", "counter");
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
        genuine = new Trace(
                IntStream.range(0, lines.size()).mapToObj(i -> TraceEvent.parse(i + 1, lines.get(i))).toList());
        packets = genuine.packets();
        random = new Random(seed);
    }

    /** Every mutant of a trace; the seed decides which bits and which other names are taken. */
    static List<TraceMutant> of(List<String> lines, long seed) {
        TraceMutants all = new TraceMutants(lines, seed);
        for (int i = 0; i < lines.size(); i++) {
            all.order(i);
            all.fields(i);
            all.declared(i);
        }
        for (int i = 0; i < all.packets.size(); i++) {
            all.times(i);
            all.bytes(i);
        }
        return List.copyOf(all.mutants);
    }

    private void order(int line) {
        TraceEvent event = genuine.events().get(line);
        if (tellsNothing(line)) {
            return;
        }
        if (isMissed(line)) {
            enter("dropped", line, "", (trace, it) -> trace.events().remove(it));
        }
        if (!REPEATED.contains(event.name())) {
            enter("told twice", line, "", (trace, it) -> trace.events().add(line + 1, it));
        }
        if (isOwn(event) && !event.is("host-id")) {
            next(line).filter(other -> isOrdered(event, genuine.events().get(other)))
                    .ifPresent(other -> enter("swapped with the board's next event", line,
                            called(genuine.events().get(other)),
                            (trace, it) -> swap(trace, it, trace.events().get(other))));
        }
        if (isOwn(event) && !event.is("rf-tx") && !event.is("host-id")) {
            if (isOvertaken(event, SECOND)) {
                enter("a second later", line, "", (trace, it) -> trace.move(it, SECOND));
            }
            if (event.seconds() > SECOND && isOvertaken(event, -SECOND)) {
                enter("a second earlier", line, "", (trace, it) -> trace.move(it, -SECOND));
            }
        }
        if (event.is("host-handed")) {
            heardBefore(event).ifPresent(packet -> enter("before its packet", line, "",
                    (trace, it) -> trace.move(it, packet.start() - MOMENT - it.seconds())));
        }
        if (event.is("host-outcome")) {
            asked(line).ifPresent(asked -> enter("before its packet", line, "",
                    (trace, it) -> trace.move(it, asked.seconds() + MOMENT - it.seconds())));
        }
    }

    /** Changes events that a board's program declares by trace points, and a host of its machines. */
    private void declared(int line) {
        TraceEvent event = genuine.events().get(line);
        String name = event.is("point") ? "name" : "state";
        if (!event.is("point") && !event.is("transition") || event.textOrEmpty("name").matches("QUIET|BUSY")) {
            return;
        }
        String what = event.text(name) + (event.has("counter")
                ? " " + Counter.of(event.number("counter")).map(Counter::toString).orElse("") : "");
        enter(event.name() + " dropped", line, what, (trace, it) -> trace.events().remove(it));
        if (!event.textOrEmpty("name").equals("TURN")) {
            enter(event.name() + " told twice", line, what, (trace, it) -> trace.events().add(line + 1, it));
        }
        other(name, event).ifPresent(other -> enter("another " + name, line, event.text(name) + " as " + other,
                (trace, it) -> trace.change(it, name, other)));
        if (event.has("packet")) {
            change("another packet", line, "packet", event.number("packet") + 1);
        }
        OPERANDS.stream().filter(event::has).forEach(operand -> enter("another operand", line,
                what + " " + operand, (trace, it) -> trace.change(it, operand, event.number(operand) + 1)));
    }

    private void fields(int line) {
        TraceEvent event = genuine.events().get(line);
        if (tellsNothing(line)) {
            return;
        }
        for (String field : List.of("board", "from", "destination", "origin", "id")) {
            if (event.has(field) && (!field.equals("destination") || !isUnknown(line))) {
                other(field, event).ifPresent(other -> change("another " + field, line, field, other));
            }
        }
        if (event.has("kind")) {
            other(KINDS, event.text("kind")).ifPresent(other -> change("another kind", line, "kind", other));
        }
        if (event.has("number")) {
            change("another number", line, "number", event.number("number") + 1);
        }
        if (event.has("packet")) {
            change("another packet", line, "packet", event.number("packet") + 1);
        }
        if (event.has("content") && !isUnknown(line)) {
            change("another content", line, "content", event.text("content") + "00");
        }
        if (event.is("host-outcome")) {
            for (String outcome : OUTCOMES) {
                if (!outcome.equals(event.textOrEmpty("outcome"))) {
                    enter("another outcome", line, event.textOrEmpty("outcome") + " as " + outcome,
                            (trace, it) -> trace.change(it, "outcome", outcome));
                }
            }
        }
        if (event.is("reset")) {
            change("another why", line, "why", event.text("why").equals("power") ? "port opened" : "power");
        }
        if (event.is("rf-rx") && event.has("end")) {
            enter("heard before it is sent", line, "", (trace, it) -> {
                trace.events().remove(it);
                trace.place(Trace.moved(it, -SLOT, "end", "t"));
            });
        }
        if (event.is("rf-rx")) {
            for (Region region : Region.of(event.text("kind"), event.text("payload"))) {
                change("a bit changed as heard: " + region.name(), line, "payload",
                        region.flipped(event.text("payload"), random));
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
        enter("packet repeated at once", number, (trace, it) -> it.all()
                .forEach(event -> trace.place(Trace.moved(event, it.end() - it.start() + SLOT))));
        // A reset soon after may have broken off its trailer.
        for (int bits : isCalm(packet.start(), packet.end()) ? List.of(1, -1) : List.of(1)) {
            enter("airtime a bit " + (bits > 0 ? "longer" : "shorter"), number,
                    (trace, it) -> trace.replace(it.sent(), Trace.moved(it.sent(), bits * BIT, "end", "t")
                            .with("bits", it.sent().number("bits") + bits)));
        }
        packets.stream().filter(before -> before.payload().equals(packet.payload())
                && before.board().equals(packet.board()) && before.end() < packet.start())
                .reduce((first, second) -> second)
                .filter(before -> before.end() + FEW_SLOTS * SLOT < packet.start()
                        && isSure(before, packet, before.end() + 3 * SLOT))
                .ifPresent(before -> moved("repeat without patience", number,
                        before.end() + 3 * SLOT - packet.start()));
        boolean answer = packet.sent().textOrEmpty("kind").equals("acknowledgement");
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
        for (Region region : Region.of(packet.sent().textOrEmpty("kind"), packet.payload())) {
            String flipped = region.flipped(packet.payload(), random);
            String zeroed = region.zeroed(packet.payload());
            enter("a bit changed as sent: " + region.name(), number,
                    (trace, it) -> payload(trace, it.payload(),
                            flipped, same -> same.start() == packet.start()));
            enter("a bit changed in each repeat: " + region.name(), number,
                    (trace, it) -> payload(trace, it.payload(), flipped, same -> true));
            if (!zeroed.equals(packet.payload())) {
                enter("zeros in each repeat: " + region.name(), number,
                        (trace, it) -> payload(trace, it.payload(), zeroed, same -> true));
            }
        }
        Region.nonce(packet.sent().textOrEmpty("kind"), packet.payload()).ifPresent(nonce -> packets.stream()
                .filter(before -> before.start() < packet.start() && before.board().equals(packet.board())
                        && !before.payload().equals(packet.payload()))
                .filter(before -> Region.nonce(before.sent().textOrEmpty("kind"), before.payload()).isPresent())
                .reduce((first, second) -> second)
                .ifPresent(before -> {
                    String old = Region.nonce(before.sent().textOrEmpty("kind"), before.payload()).orElseThrow()
                            .in(before.payload());
                    if (!old.equals(nonce.in(packet.payload()))) {
                        String reused = nonce.with(packet.payload(), old);
                        enter("nonce of the message before", number,
                                (trace, it) -> payload(trace, it.payload(), reused, same -> true));
                    }
                }));
    }

    private void payload(Trace trace, String from, String to, Predicate<Trace.Packet> which) {
        packets.stream().filter(packet -> packet.payload().equals(from) && which.test(packet))
                .flatMap(packet -> packet.all().stream()).filter(event -> event.has("payload"))
                .forEach(event -> trace.change(event, "payload", to));
    }

    /**
     * Something that the model does not speak of, what a host does with keys and the radio when it wants, what a
     * injector sends, a reset of a board that has no past, or an id that is known or under
     * which nothing is sent.
     */
    private boolean tellsNothing(int line) {
        TraceEvent event = genuine.events().get(line);
        if (event.board().equals(INJECTOR) || event.textOrEmpty("from").equals(INJECTOR)) {
            return true;
        }
        List<TraceEvent> before = of(event.board(), genuine.events().subList(0, line));
        List<TraceEvent> after = of(event.board(), genuine.events().subList(line + 1, lines.size()));
        return switch (event.name()) {
            case "reset" -> before.stream().noneMatch(other -> other.name().startsWith("rf-"))
                    || before.stream().filter(TraceMutants::isOwn).reduce((first, second) -> second)
                            .filter(other -> !other.is("reset")).isEmpty();
            case "host-id" -> before.stream()
                    .anyMatch(other -> other.is("host-id") && other.textOrEmpty("id").equals(event.textOrEmpty("id")))
                    || after.stream().takeWhile(other -> !other.is("host-id")).noneMatch(other -> other.is("rf-tx"));
            case "host-key", "host-action", "host-radio", "host-relaying", "host-nothing" -> true;
            case "rf-tx", "rf-rx", "rf-damaged" -> false;
            default -> !event.name().startsWith("host-");
        };
    }

    /** All else that this board and its host do from here on, up to a reset. */
    private Stream<TraceEvent> then(int line) {
        return of(genuine.events().get(line).board(), genuine.events().subList(line + 1, lines.size())).stream()
                .takeWhile(other -> !other.is("reset"));
    }

    /** Whether a board could not go on so without this event. */
    private boolean isMissed(int line) {
        TraceEvent event = genuine.events().get(line);
        return switch (event.name()) {
            // A host tells with the next what it has not been heard to say, and so does a board.
            case "host-taking" -> then(line).filter(other -> other.name().startsWith("host-tak")).findFirst()
                    .filter(other -> other.is("host-taken") && isSame("number", event, other)).isPresent();
            case "host-taken" -> then(line).noneMatch(other -> other.is("host-taken"))
                    && then(line).anyMatch(other -> isTold(other) && apart(event, other) > OTHER_REQUEST);
            case "host-outcome" -> then(line)
                    .anyMatch(other -> other.is("host-handed") && apart(event, other) > OTHER_ATTEMPT);
            // All that it has done is gone with the next one as well.
            case "reset" -> then(line).anyMatch(TraceMutants::isOwn);
            // No trace tells who is in range.
            case "rf-damaged" -> false;
            case "rf-rx" -> isActedUpon(line);
            // A trace may end before it tells of a packet that others have heard already.
            case "rf-tx" -> genuine.events().get(lines.size() - 1).seconds() > event.real("end") + SECOND;
            default -> !isUnknown(line);
        };
    }

    /** Whether what comes here, and has not come before, is what its board then tells its host of. */
    private boolean isActedUpon(int line) {
        TraceEvent event = genuine.events().get(line);
        boolean comesOnce = packets.stream().filter(packet -> packet.payload().equals(event.textOrEmpty("payload"))
                && packet.isHeardBy(event.board())).count() == 1;
        return comesOnce && then(line)
                .takeWhile(other -> !other.name().startsWith("rf-"))
                .anyMatch(other -> event.textOrEmpty("kind").equals("acknowledgement")
                        ? other.textOrEmpty("outcome").equals("delivered")
                        : other.is("host-handed") && isSame("origin", event, other)
                                && isSame("destination", event, other));
    }

    /** Whether it may have been without effect: a host asks for what its board never sends, as a reset comes before. */
    private boolean isUnknown(int line) {
        TraceEvent event = genuine.events().get(line);
        return event.is("host-transmit")
                && then(line).noneMatch(other -> other.is("host-outcome") && isSame("number", event, other));
    }

    /** Whether boards could not go on so without this packet: of others there are repeats that are enough. */
    private boolean isMissed(Trace.Packet packet) {
        long copies = packets.stream().filter(other -> other.payload().equals(packet.payload())
                && other.board().equals(packet.board())).count();
        boolean toMany = List.of("multicast", "broadcast").contains(packet.sent().textOrEmpty("kind"));
        // A reset may end a message before anybody has answered.
        boolean isNoMatter = packet.sent().textOrEmpty("kind").equals("unicast")
                && then(genuine.events().indexOf(packet.sent())).noneMatch(other -> other.is("host-outcome"));
        return !isNoMatter && (toMany || copies == 1 || copies == ATTEMPTS);
    }

    /** Whether an event that comes sooner or later is no longer where it was among what it has to do with. */
    private boolean isOvertaken(TraceEvent event, double seconds) {
        double from = event.seconds() + Math.min(0, seconds);
        double to = event.seconds() + Math.max(0, seconds);
        if (seconds < 0 && event.is("host-outcome")) {
            return true;
        }
        if (seconds < 0 && event.is("host-handed")
                && heardBefore(event).filter(packet -> packet.end() > from).isPresent()) {
            return true;
        }
        return genuine.events().stream()
                .filter(other -> other != event && isOwn(other) && isSame("board", event, other)
                        && other.seconds() >= from && other.seconds() <= to)
                .anyMatch(other -> !(other.is("rf-tx") && !event.is("reset"))
                        && isOrdered(seconds < 0 ? other : event, seconds < 0 ? event : other));
    }

    /** Whether a board and its host can have done these two in this order only. */
    private static boolean isOrdered(TraceEvent first, TraceEvent second) {
        Set<String> names = Set.copyOf(List.of(first.name(), second.name()));
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
        // Events that a reset breaks off are told behind it.
        return !names.equals(Set.of("reset"))
                && (!second.is("rf-tx") || second.real("start") > first.seconds());
    }

    /** A board tells all such events that there are when its host asks. */
    private static boolean isTold(TraceEvent event) {
        return event.is("host-handed") || event.is("host-outcome");
    }

    private static double apart(TraceEvent first, TraceEvent second) {
        return second.seconds() - first.seconds();
    }

    private static boolean isSame(String field, TraceEvent first, TraceEvent second) {
        return first.textOrEmpty(field).equals(second.textOrEmpty(field));
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
                .filter(event -> event.is("reset") || event.is("fault") || event.is("command"))
                .noneMatch(event -> event.seconds() > from - DISTURBED && event.seconds() < to + DISTURBED);
    }

    private static List<TraceEvent> of(String board, List<TraceEvent> events) {
        return events.stream().filter(event -> event.board().equals(board)).toList();
    }

    /** A board itself does this, in the order of the trace. */
    private static boolean isOwn(TraceEvent event) {
        return event.is("rf-tx") || event.is("reset")
                || event.name().startsWith("host-") && !event.is("host-nothing");
    }

    private Optional<Integer> next(int line) {
        TraceEvent event = genuine.events().get(line);
        for (int i = line + 1; i < lines.size(); i++) {
            TraceEvent other = genuine.events().get(i);
            if (isOwn(other) && other.board().equals(event.board())) {
                boolean same =
                        event.has("payload") && event.textOrEmpty("payload").equals(other.textOrEmpty("payload"));
                return same || tellsNothing(i) ? Optional.empty() : Optional.of(i);
            }
        }
        return Optional.empty();
    }

    private static void swap(Trace trace, TraceEvent first, TraceEvent second) {
        double between = second.seconds() - first.seconds();
        trace.move(first, between);
        trace.move(second, -between);
    }

    /** The first time that what was handed over was sent. */
    private Optional<Trace.Packet> heardBefore(TraceEvent handed) {
        List<Trace.Packet> heard = packets.stream().filter(packet -> packet.end() < handed.seconds()
                && packet.isHeardBy(handed.board())
                && packet.sent().textOrEmpty("origin").equals(handed.textOrEmpty("origin"))).toList();
        return heard.stream().filter(packet -> packet.payload().equals(heard.get(heard.size() - 1).payload()))
                .findFirst();
    }

    private Optional<TraceEvent> asked(int outcome) {
        TraceEvent event = genuine.events().get(outcome);
        return genuine.events().subList(0, outcome).stream()
                .filter(other -> other.is("host-transmit") && other.board().equals(event.board())
                        && other.textOrEmpty("number").equals(event.textOrEmpty("number")))
                .reduce((first, second) -> second);
    }

    /** Another value that this field has in this trace. */
    private Optional<String> other(String field, TraceEvent event) {
        Set<String> values = new LinkedHashSet<>();
        for (TraceEvent each : genuine.events()) {
            if (each.has(field) && each.textOrEmpty(field).length() == event.textOrEmpty(field).length()
                    || field.equals("board") || List.of("name", "state").contains(field) && each.is(event.name())) {
                values.add(each.textOrEmpty(field));
            }
        }
        values.removeAll(List.of("", INJECTOR));
        return other(List.copyOf(values), event.textOrEmpty(field));
    }

    private Optional<String> other(List<String> values, String than) {
        List<String> others = values.stream().filter(value -> !value.equals(than)).toList();
        return others.isEmpty() ? Optional.empty() : Optional.of(others.get(random.nextInt(others.size())));
    }

    private void change(String operator, int line, String field, Object value) {
        enter(operator, line, "", (trace, it) -> trace.change(it, field, value));
    }

    private void moved(String operator, int number, double seconds) {
        enter(operator, number, (trace, it) -> it.all().forEach(event -> trace.move(event, seconds)));
    }

    private void enter(String operator, int packet, BiConsumer<Trace, Trace.Packet> change) {
        TraceEvent sent = packets.get(packet).sent();
        enter(operator, genuine.events().indexOf(sent), "",
                (trace, it) -> change.accept(trace, packets.get(packet)));
    }

    private void enter(String operator, int line, String detail, BiConsumer<Trace, TraceEvent> change) {
        mutants.add(new TraceMutant(operator, called(genuine.events().get(line)), line + 1, detail, () -> {
            Trace trace = new Trace(genuine.events());
            change.accept(trace, trace.events().get(line));
            return trace.lines();
        }));
    }

    private static String called(TraceEvent event) {
        return (event.name() + " " + event.textOrEmpty("kind") + " " + event.textOrEmpty("answers")).strip();
    }
}
