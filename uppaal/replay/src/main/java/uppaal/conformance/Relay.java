package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import javino.protocol.Airtime;
import javino.protocol.Payload;

/** One relay: its scores, its credit, and a copy of {@code relay.xml}'s automaton for each of its places. */
final class Relay {
    private static final int RESERVE_QUIET = 18;
    private static final int SCORES = 32;
    private static final int FIRST_SCORE = 1;
    /** Of time on the air, in milliseconds, and as a share of all time. */
    private static final double MOST_CREDIT = 4000;
    private static final double SHARE = 0.1;
    private static final int MILLIS = 1000;
    static final int LATE_MILLIS = 1500;
    private static final int AGAIN_MILLIS = 200;
    private static final String RULE = "rule[1]";

    private final Header header;
    private final Model model;
    private final Deque<RelayCheck.Heard> heard;
    private final DeclaredAir air;
    private final Map<Integer, RelayedPacket> places = new HashMap<>();
    private final Map<String, Integer> scores = new LinkedHashMap<>();
    /** For unicasts, and for many. */
    private final Credit[] credits;
    private double filled;
    private final String id;
    /** The point that must follow in the same run, and of which place; nothing where none must. */
    private String next = "";
    private int nextPlace;
    private Point copies;
    private boolean isAnew;

    Relay(Header header, String board, Model model, String id, Deque<RelayCheck.Heard> heard) {
        this.header = header;
        this.model = model;
        this.id = id;
        this.heard = heard;
        air = new DeclaredAir(header, board);
        credits = new Credit[] {new Credit(), new Credit()};
    }

    /** The automaton with the firmware's times, in milliseconds. */
    static Model model() {
        return new Model("relay.xml", "Relay", Map.of("LATE", LATE_MILLIS, "AGAIN", AGAIN_MILLIS), 1, 0);
    }

    void point(Point point) throws RefusedException {
        boolean isOurs = point.name().startsWith("RELAY_");
        point.require(next.isEmpty() || point.is("COUNT") || point.is(next) && point.operand("place") == nextPlace,
                next + " of place " + nextPlace);
        if (!point.is("COUNT")) {
            next = "";
        }
        if (isOurs && !point.is("RELAY_ON")) {
            fill(point);
            relay(point, point.operand("place"));
        }
        boolean wasBusy = air.isBusy();
        boolean breaks = AirCheck.SENDS.contains(point.name()) || point.is("BUSY");
        for (RelayedPacket place : breaks && !wasBusy ? places.values() : List.<RelayedPacket>of()) {
            place.due.checkNotLate(point);
            place.due.busy(point);
            place.count(point.run() - point.gap(), point.run());
        }
        if (breaks) {
            air.busy();
        } else if (wasBusy && point.is("QUIET")) {
            air.quiet(point);
            places.values().forEach(place -> place.quietFrom = point.run());
        }
    }

    private void fill(Point point) {
        double more = (point.seconds() - filled) * SHARE * MILLIS;
        filled = point.seconds();
        for (Credit credit : credits) {
            credit.add(more / air.second(), SHARE);
        }
    }

    /** What a relay may still spend: at least and at most. */
    private final class Credit {
        private double least = air.isTimed() ? MOST_CREDIT : 0;
        private double most = MOST_CREDIT;

        void add(double more, double error) {
            least = air.isTimed() ? Math.min(MOST_CREDIT, least + more - error) : 0;
            most = air.isTimed() ? Math.min(MOST_CREDIT, most + more + error) : MOST_CREDIT;
        }
    }

    private Credit credit(RelayedPacket place) {
        return credits[place.isToMany() ? 1 : 0];
    }

    private void relay(Point point, int number) throws RefusedException {
        if (point.is("RELAY_NEW")) {
            begin(point, number);
            return;
        }
        RelayedPacket place = places.get(number);
        point.require(place != null, "RELAY_NEW of this place before");
        if (RelayedPacket.DRAWS.containsKey(point.name())) {
            place.draw(point);
        }
        switch (point.name()) {
            case "RELAY_ANEW", "RELAY_STEP_IN" -> again(point, number, place);
            case "RELAY_RESERVE" -> {
                place.expect(point, "Reserve");
                place.restartQuiet(point);
            }
            case "RELAY_DRAW", "RELAY_DRAW_REPEAT" -> place.expect(point, "Waiting");
            case "RELAY_DRAW_ANSWER", "RELAY_DRAW_ANSWER_REPEAT" -> place.expect(point, "Carrying");
            case "RELAY_GONE_ON", "RELAY_PEER", "RELAY_DRAW_AGAIN" -> packetHeard(point, place);
            case "RELAY_COPY", "RELAY_REFUSE" -> copy(point, place);
            case "RELAY_ANSWER" -> answer(point, place);
            case "RELAY_ANSWERED" -> answered(point, number, place);
            case "RELAY_ANSWER_GONE_ON", "RELAY_ANSWER_PEER" -> answerHeard(point, place);
            case "RELAY_DRAW_ANSWER_AGAIN", "RELAY_FORGET" -> {
                place.instance.take(point, point.name(),
                        externals(point, place, came(point, place, place.packet::equals)));
                isAnew = point.is("RELAY_FORGET");
                if (isAnew) {
                    places.remove(number);
                }
            }
            case "RELAY_COPY_ENDED" -> ended(point, number, place, "Waiting", "RELAY_DRAW_REPEAT");
            case "RELAY_ANSWER_ENDED" -> ended(point, number, place, "Carrying", "RELAY_DRAW_ANSWER_REPEAT");
            default -> throw new RefusedException(point.board() + " declares " + point.name(), "a point of a relay");
        }
    }

    private RelayCheck.Heard came(Point point, RelayedPacket place, Predicate<Payload> wanted) throws RefusedException {
        Optional<RelayCheck.Heard> found = heard.stream().filter(packet -> wanted.test(packet.payload())).findFirst();
        return found.orElseThrow(() -> new RefusedException(point.board() + " declares " + point.name(),
                "that the packet has come to it"));
    }

    private Map<String, Integer> externals(Point point, RelayedPacket place, RelayCheck.Heard packet) {
        double late = place.lateSeconds() * MILLIS;
        double millis = (point.seconds() - place.happened) * MILLIS / air.second() + LATE_MILLIS - late;
        double error = 2 * PhysicalLimits.MILLIS_STEP_SECONDS * MILLIS;
        int at = Math.abs(millis - LATE_MILLIS) <= error ? LATE_MILLIS
                : Math.abs(millis - AGAIN_MILLIS) <= error ? AGAIN_MILLIS : (int) millis;
        Map<String, Integer> set = new HashMap<>(Map.of("at", at, "kind",
                model.constant(packet.payload().isAcknowledgement() ? "ACK" : "DATA"), "hops", packet.hops(), "by",
                model.constant("SENDER"), "genuine", 1, "doubt", scores.getOrDefault(place.pair(), FIRST_SCORE)));
        set.put("spent", 0);
        return set;
    }

    private void begin(Point point, int number) throws RefusedException {
        RelayCheck.Heard packet = came(point, null, payload -> RelayedPacket.isCopied(payload)
                && RelayedPacket.mark(payload) == point.operand("nonce")
                && !payload.destination().equals(id) && !payload.origin().equals(id));
        RelayedPacket old = places.get(number);
        point.require(old == null || old.due == Timer.NONE && !old.sends,
                "another place, as that has something to send, or RELAY_REFUSED");
        RelayedPacket place = new RelayedPacket(packet.payload(), model.instance(packet.payload().origin() + " to "
                + packet.payload().destination()), air);
        places.put(number, place);
        point.require(!place.isToMany() || packet.hops() == 0, "no copy of a copy");
        Map<String, Integer> set = externals(point, place, packet);
        boolean isTrusted = set.get("doubt") == 0;
        double least = isTrusted || place.isToMany() ? cost(place.packet) : MOST_CREDIT / 2;
        double credit = credit(place).most;
        point.require(credit >= least, (int) least + " ms of credit or more, not " + (int) credit);
        set.put("late", isAnew ? 1 : 0);
        isAnew = false;
        place.instance.take(point, point.name(), set);
        begun(point, number, place);
    }

    private void begun(Point point, int number, RelayedPacket place) {
        place.happened = point.seconds();
        place.restartQuiet(point);
        place.soon = false;
        place.due = Timer.NONE;
        next = place.instance.isAt("Reserve") ? "RELAY_RESERVE" : "RELAY_DRAW";
        nextPlace = number;
    }

    private void again(Point point, int number, RelayedPacket place) throws RefusedException {
        place.fromReserve = point.is("RELAY_STEP_IN");
        place.count(point.run() - point.gap(), point.run());
        point.require(!place.fromReserve || place.quietMost >= RESERVE_QUIET,
                RESERVE_QUIET + " quiet slots or more, not " + (int) place.quietMost);
        place.instance.take(point, point.name(), externals(point, place, came(point, place, place.packet::equals)));
        begun(point, number, place);
    }

    private void packetHeard(Point point, RelayedPacket place) throws RefusedException {
        if (place.instance.isAt("Reserve")) {
            place.happened = point.seconds();
            return;
        }
        place.instance.take(point, point.name(), externals(point, place, came(point, place, place.packet::equals)));
        if (point.is("RELAY_DRAW_AGAIN")) {
            return;
        }
        place.stop(point);
        if (point.is("RELAY_GONE_ON")) {
            place.soon = place.isSoon(point, point.operand("soon") == 1);
        }
    }

    private int cost(Payload packet) {
        return (int) (Airtime.bits(packet.bytes().length()) * header.bit() * MILLIS);
    }

    private void copy(Point point, RelayedPacket place) throws RefusedException {
        place.due.checkNotEarly(point);
        place.due.checkNotLate(point);
        int cost = cost(place.packet);
        boolean isRefused = point.is("RELAY_REFUSE");
        Credit credit = credit(place);
        boolean mayBeRefused = credit.least < cost || place.isLate(point, -1);
        point.require(isRefused ? mayBeRefused : credit.most >= cost && !place.isLate(point, 1),
                "RELAY_" + (isRefused ? "COPY" : "REFUSE") + " of a packet of " + cost + " ms, with a credit of "
                        + (int) credit.least + " to " + (int) credit.most);
        place.instance.set("spent", isRefused ? model.constant("CREDIT") : 0);
        place.instance.take(point);
        place.due = Timer.NONE;
        if (!isRefused) {
            checkHops(point, place.instance.get("own"));
            credit.add(-cost, 0);
            place.spent += cost;
            place.sends = true;
            copies = point;
        }
    }

    private static void checkHops(Point point, int expected) throws RefusedException {
        point.require(point.operand("hops") == expected, expected + " hops, one more than it came with");
    }

    private void answer(Point point, RelayedPacket place) throws RefusedException {
        place.due.checkNotEarly(point);
        place.due.checkNotLate(point);
        place.instance.take(point);
        checkHops(point, place.instance.get("back"));
        place.due = Timer.NONE;
        place.sends = true;
        copies = point;
    }

    private void answered(Point point, int number, RelayedPacket place) throws RefusedException {
        RelayCheck.Heard packet = came(point, place, place::isAnswer);
        int length = packet.payload().message().length();
        point.require(length == Payload.TAG_LENGTH || length == 2 * Payload.TAG_LENGTH, "a whole message's answer");
        place.answer = packet.payload();
        boolean isDirect = packet.hops() == 0;
        Map<String, Integer> set = externals(point, place, packet);
        boolean isCopied = place.instance.get("copied") == 1;
        if (isDirect && isCopied && !place.soon) {
            place.count(point.run() - point.gap(), point.run());
            // Where one step of a clock decides, the score that is told does.
            place.soon = place.quietMost < RelayedPacket.SOON
                    || place.quietLeast < RelayedPacket.SOON && point.operand("doubt") != model.constant("MOST");
        }
        set.put("reserved", place.fromReserve ? 1 : 0);
        String rule = !isCopied ? "NEEDLESS" : place.soon ? "SOON" : isDirect ? "TOO_LATE" : "ELSEWHERE";
        place.instance.take(point, point.name(), set,
                Map.of(RULE, model.constant(rule), "doubt", point.operand("doubt")));
        place.stop(point);
        scores.remove(place.pair());
        scores.put(place.pair(), point.operand("doubt"));
        if (scores.size() > SCORES) {
            scores.remove(scores.keySet().iterator().next());
        }
        credits[0].add(place.spent, 0);
        place.spent = 0;
        if (place.instance.isAt("Carrying")) {
            next = "RELAY_DRAW_ANSWER";
            nextPlace = number;
        }
    }

    private void answerHeard(Point point, RelayedPacket place) throws RefusedException {
        RelayCheck.Heard packet = came(point, place, place::isAnswer);
        if (point.is("RELAY_ANSWER_GONE_ON") || place.instance.isAt("Carrying")) {
            place.instance.take(point, point.name(), externals(point, place, packet));
        }
        place.stop(point);
    }

    private void ended(Point point, int number, RelayedPacket place, String location, String draw) {
        place.sends = false;
        place.happened = point.seconds();
        place.restartQuiet(point);
        if (place.instance.isAt(location) && place.answer == null == draw.equals("RELAY_DRAW_REPEAT")) {
            next = draw;
            nextPlace = number;
        }
    }

    /** A packet of this board begins: of what it has copied the bytes are those that came. */
    void begins(Transmission packet) throws RefusedException {
        if (copies == null) {
            return;
        }
        RelayedPacket place = places.get(copies.operand("place"));
        Payload expected = copies.is("RELAY_COPY") ? place.packet : place.answer;
        copies = null;
        require(packet.payload().equals(expected), packet.board() + " copies " + packet.payload().hex(),
                expected.hex() + ", as it came");
    }
}
