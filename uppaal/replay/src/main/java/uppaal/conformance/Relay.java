package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Counter;
import javino.protocol.Crc16;
import javino.protocol.Payload;
import trace.TraceEvent;

/** One relay: its scores, its credit, and what it knows of each packet in one of its places. */
final class Relay {
    private static final int RESERVE_QUIET = 18;
    /** After so many a copy for many is not sent any more. */
    private static final int MOST_SLOTS = 256;
    private static final int ADDRESSES = 32;
    private static final int FIRST_SCORE = 1;
    /** The limits of time on the air, in milliseconds, and as a share of all time. */
    private static final double MOST_CREDIT = 4000;
    private static final double SHARE = 0.1;
    private static final int MILLIS = 1000;
    /** The counters of packets that it may have to copy. */
    private static final Set<Counter> FOR_OTHERS = Set.of(Counter.RADIO_NOT_FOR_US, Counter.RADIO_BLOCKED);

    private final double bit;
    private final Model model;
    private final BoardAir air;
    private final Map<Integer, RelayedPacket> places = new HashMap<>();
    /** By the number of an address. */
    private final Map<Integer, Integer> scores = new BoundedMap<>(ADDRESSES);
    /** Likewise, bit h for a packet from there with h hops behind it. */
    private final Map<Integer, Integer> hops = new HashMap<>();
    /** The time that it may still spend on packets for many, and on others. */
    private final Map<Boolean, Interval> credits;
    private double filled;
    private final String id;
    /** The point that must follow in the same run; nothing where none must. */
    private String next = "";
    /** The last point but COUNT. */
    private Point before;
    /** When its last packet ended. */
    private double sentUntil;
    /** By packet, the paths with which it has come, damaged or not. */
    private final Map<Payload, Set<Integer>> paths = new BoundedMap<>();
    /** The numbers of origins of which it has surely read a packet. */
    private final Set<Integer> read = new HashSet<>();

    Relay(Header header, Point on, Model model, String id) {
        this.model = model;
        this.id = id;
        bit = header.bit();
        before = on;
        air = new BoardAir(header, on.board());
        Interval full = new Interval(air.isTimed() ? MOST_CREDIT : 0, MOST_CREDIT);
        credits = new HashMap<>(Map.of(true, full, false, full));
        on.packets().forEach(reception -> heard(reception.packet())); // they may wait to be read
    }

    void point(Point point) throws RefusedException {
        read(point);
        if (point.is("COUNT")) {
            return;
        }
        point.require(next.isEmpty() || next.equals(point.name() + " of place " + point.event().textOrEmpty("place")),
                next);
        next = "";
        for (RelayedPacket place : places.values()) {
            place.due.checkNotLate(point);
            boolean isTold = !place.isOnAir || point.name().endsWith("_ENDED")
                    || point.runBefore() < sentUntil + 2 * PhysicalLimits.ARRIVAL_BITS * bit;
            point.require(isTold, "first that what it has copied has ended");
        }
        if (point.name().startsWith("RELAY_")) {
            double more = (point.seconds() - filled) * SHARE * MILLIS / air.second();
            filled = point.seconds();
            credit(true, new Interval(more - SHARE, more + SHARE));
            credit(false, new Interval(more - SHARE, more + SHARE));
            relay(point, point.operand("place"));
        }
        before = point;
        if (air.changes(point)) {
            places.values().forEach(each -> each.air(point));
        }
    }

    /** It looks at a packet as a relay before it tells what it is. */
    private void read(Point point) throws RefusedException {
        boolean isFate =
                FateCheck.READ.contains(point.name()) || point.counter().filter(FOR_OTHERS::contains).isPresent();
        if (!isFate || point.packets().size() != 1 || !point.packets().get(0).isIntact()) {
            return;
        }
        Transmission packet = point.packets().get(0).packet();
        read.add(number(packet.payload().origin()));
        for (int place : places.keySet()) {
            RelayedPacket copied = places.get(place);
            point.require(copied.answer != null || !copied.isAnsweredWholeBy(packet.payload()),
                    "RELAY_ANSWERED of place " + place + " before");
            point.require(!copied.isUnheeded(packet, point.run()), "RELAY_PEER or RELAY_GONE_ON of place " + place
                    + ", or of its answer, before");
        }
    }

    private void credit(boolean isToMany, Interval millis) {
        if (air.isTimed()) {
            credits.merge(isToMany, millis, (credit, more) -> credit.plus(more).atMost(MOST_CREDIT));
        }
    }

    private void follows(Point point, String name) {
        next = name + " of place " + point.operand("place");
    }

    private void relay(Point point, int number) throws RefusedException {
        RelayedPacket place = places.get(number);
        boolean begins = point.is("RELAY_NEW") || point.is("RELAY_DISTANCE");
        point.require(begins || place != null, "RELAY_NEW of this place before");
        switch (point.name()) {
            case "RELAY_DISTANCE" -> {
                point.require(!before.is("RELAY_FORGET"), "none of a packet that is late");
                follows(point, "RELAY_NEW");
            }
            case "RELAY_NEW" -> begin(point, number);
            case "RELAY_ANEW", "RELAY_STEP_IN" -> again(point, place);
            case "RELAY_RESERVE" -> place.expect(point, "Reserve");
            case "RELAY_DRAW", "RELAY_DRAW_REPEAT", "RELAY_DRAW_ANSWER", "RELAY_DRAW_ANSWER_REPEAT" ->
                place.draw(point);
            case "RELAY_DRAW_AGAIN", "RELAY_DRAW_ANSWER_AGAIN" -> {
                take(point, place, place::is);
                place.draw(point);
            }
            case "RELAY_GONE_ON", "RELAY_PEER" -> {
                take(point, place, place::is);
                if (point.is("RELAY_GONE_ON")) {
                    place.checkSoon(point, point.operand("soon") == 1);
                }
            }
            case "RELAY_COPY", "RELAY_REFUSE" -> copy(point, place);
            case "RELAY_ANSWER" -> {
                int behind = (place.answer.hops() + 1) % TraceEvent.HOPS;
                send(point, place, behind, place.instance.get("own") + 1);
            }
            case "RELAY_ANSWERED" -> answered(point, place);
            case "RELAY_ANSWER_GONE_ON", "RELAY_ANSWER_PEER" -> take(point, place, place::isAnswer);
            case "RELAY_FORGET" -> {
                take(point, place, place::is);
                places.remove(number);
            }
            case "RELAY_COPY_ENDED", "RELAY_ANSWER_ENDED" -> {
                point.require(place.isOnAir, "a copy before");
                place.isOnAir = false;
                place.restart(point);
                if (place.instance.isAt(point.is("RELAY_COPY_ENDED") ? "Waiting" : "Carrying")) {
                    follows(point, point.is("RELAY_COPY_ENDED") ? "RELAY_DRAW_REPEAT" : "RELAY_DRAW_ANSWER_REPEAT");
                }
            }
            default -> throw new RefusedException(point.toString(), "a point of a relay");
        }
    }

    /**
     * What has come of a packet, as the trace tells it. A board that mends a damaged copy may take it for one that has
     * come before (SPEC 6), and so for one of that path: this may be what came, too.
     */
    private List<Transmission> came(Point point, Predicate<Payload> wanted) throws RefusedException {
        Reception last = point.packets().stream().filter(each -> wanted.test(each.packet().payload()))
                .reduce((first, other) -> other)
                .orElseThrow(() -> new RefusedException(point.toString(), "that the packet has come to it"));
        Transmission packet = last.packet();
        Set<Integer> before = last.isIntact() ? Set.of() : paths.getOrDefault(packet.payload(), Set.of());
        return Stream.concat(Stream.of(packet), before.stream().map(packet::of)).toList();
    }

    private void take(Point point, RelayedPacket place, Predicate<Payload> wanted) throws RefusedException {
        place.take(point, came(point, wanted), score(place.packet.destination()));
    }

    private static int number(String address) {
        return Crc16.of(Bytes.ofText(address));
    }

    private int score(String address) {
        return scores.getOrDefault(number(address), FIRST_SCORE);
    }

    /** A packet has come, perhaps damaged, and tells how far its origin may be. */
    void heard(Transmission packet) {
        String origin = packet.payload().origin();
        paths.computeIfAbsent(packet.payload(), added -> new TreeSet<>()).add(packet.path());
        if (!origin.isEmpty() && !origin.equals(id)) {
            hops.merge(number(origin), 1 << packet.hops(), (some, more) -> some | more);
            scores.put(number(origin), score(origin));
        }
    }

    /** Whether the told distance of a packet's destination is unknown, or one more than some hops. */
    private void checkKnown(String who, Payload packet, int told) throws RefusedException {
        int one = 1 << (told + 2) % TraceEvent.HOPS;
        require(told == 0 || (hops.getOrDefault(number(packet.destination()), 0) & one) != 0,
                who + " tells the distance " + (told - 1) + " of " + packet.destination(),
                "one more than the hops behind a packet from there");
    }

    private void begin(Point point, int number) throws RefusedException {
        Transmission packet = came(point, payload -> RelayedPacket.isCopied(payload)
                && RelayedPacket.mark(payload) == point.operand("nonce")
                && !payload.destination().equals(id) && !payload.origin().equals(id)).get(0);
        RelayedPacket old = places.get(number);
        point.require(old == null || old.due == Timer.NONE && !old.isOnAir,
                "another place, as that has something to send, or RELAY_REFUSED");
        RelayedPacket place = new RelayedPacket(packet.payload(), model, air);
        places.put(number, place);
        point.require(!place.isToMany() || packet.hops() == 0, "no copy of a copy");
        boolean isSpender = place.isToMany() || score(place.packet.destination()) == 0;
        double least = isSpender ? cost(place) : MOST_CREDIT / 2;
        double credit = credits.get(place.isToMany()).most();
        point.require(credit >= least, (int) least + " ms of credit or more, not " + (int) credit);
        boolean isEarly = before.is("RELAY_DISTANCE");
        point.require(isEarly != (place.isToMany() || before.is("RELAY_FORGET")),
                "RELAY_DISTANCE before, if it is of one device and not late");
        if (isEarly) {
            place.told = before.operand("distance");
            checkKnown(point.board(), place.packet, place.told);
            boolean isKnown = read.contains(number(place.packet.destination())) && scores.size() < ADDRESSES;
            require(place.told != 0 || !isKnown, point.board() + " tells no distance of "
                    + place.packet.destination(), "one, as it has read a packet from there");
            boolean isNearer = place.told != 0 && (place.told + 1 - packet.told()) % TraceEvent.HOPS == 0;
            place.instance.set("away", packet.told() == 0 || isNearer ? 0 : 1);
        }
        begun(point, place);
    }

    private void begun(Point point, RelayedPacket place) throws RefusedException {
        List<Transmission> mayCome = came(point, place::is);
        place.take(point, mayCome, score(place.packet.destination()));
        place.begin(mayCome);
        place.restart(point);
        place.isSoon = false;
        follows(point, place.instance.isAt("Reserve") ? "RELAY_RESERVE" : "RELAY_DRAW");
    }

    private void again(Point point, RelayedPacket place) throws RefusedException {
        double quiet = place.quiet(point).most();
        point.require(point.is("RELAY_ANEW") || quiet >= RESERVE_QUIET,
                RESERVE_QUIET + " quiet slots or more, not " + (int) quiet);
        place.told = point.is("RELAY_ANEW") ? 0 : place.told;
        begun(point, place);
    }

    private int cost(RelayedPacket place) {
        return (int) (Airtime.bits(place.packet.bytes().length()) * bit * MILLIS);
    }

    private void copy(Point point, RelayedPacket place) throws RefusedException {
        int cost = cost(place);
        Interval credit = credits.get(place.isToMany());
        Interval waited = place.isToMany() && air.isTimed() ? place.age(point).times(1 / air.slot()) : Interval.of(0);
        boolean isRefused = point.is("RELAY_REFUSE");
        point.require(isRefused ? credit.least() < cost || waited.most() > MOST_SLOTS
                : credit.most() >= cost && waited.least() <= MOST_SLOTS,
                "RELAY_" + (isRefused ? "COPY" : "REFUSE")
                        + " of a packet of " + cost + " ms, with a credit of " + (int) credit.least() + " to "
                        + (int) credit.most());
        place.instance.set("spent", isRefused ? model.constant("CREDIT") : 0);
        if (isRefused) {
            place.send(point);
        } else {
            credit(place.isToMany(), Interval.of(-cost));
            place.spent += cost;
            place.tells(point.operand("path") % TraceEvent.HOPS);
            send(point, place, place.instance.get("own"), place.told);
        }
    }

    private void send(Point point, RelayedPacket place, int behind, int told) throws RefusedException {
        place.send(point);
        int path = behind + TraceEvent.HOPS * told;
        point.require(point.operand("path") == path, "path " + path + ", with " + behind + " hops");
        place.isOnAir = true;
        sentUntil = Double.POSITIVE_INFINITY;
    }

    private void answered(Point point, RelayedPacket place) throws RefusedException {
        place.answer = came(point, place::isAnswer).get(0);
        point.require(place.isAnsweredWholeBy(place.answer.payload()), "a whole message's answer");
        boolean isDirect = place.answer.told() == 0;
        boolean isCopied = place.instance.get("copied") == 1;
        int doubt = point.operand("doubt");
        if (isDirect && isCopied) {
            place.checkSoon(point, doubt != model.constant("MOST"));
        }
        String rule = !isCopied ? "NEEDLESS" : place.isSoon ? "SOON" : isDirect ? "TOO_LATE" : "ELSEWHERE";
        place.take(point, place.answer, score(place.packet.destination()),
                Map.of(RelayedPacket.RULE, model.constant(rule), "doubt", doubt));
        scores.put(number(place.packet.destination()), doubt);
        credit(false, Interval.of(place.spent));
        place.spent = 0;
        if (place.instance.isAt("Carrying")) {
            follows(point, "RELAY_DRAW_ANSWER");
        }
    }

    /** A packet of this board begins: of what it has copied the bytes are those that came. */
    void begins(Transmission packet) throws RefusedException {
        if (packet.isDeclared("RELAY_")) {
            RelayedPacket place = places.get(packet.declared().operand("place"));
            Payload expected = packet.isDeclared("RELAY_COPY") ? place.packet : place.answer.payload();
            require(packet.payload().equals(expected), packet.board() + " copies " + packet.payload().hex(),
                    expected.hex() + ", as it came");
        } else {
            checkKnown(packet.board(), packet.payload(), packet.told());
        }
    }

    void ends(Transmission packet) {
        sentUntil = packet.isOfModule() ? sentUntil : packet.end();
    }
}
