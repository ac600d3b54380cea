package uppaal.conformance;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.protocol.Payload;
import trace.TraceEvent;

/** One packet of a relay: a copy of {@code relay.xml}'s automaton, and times. */
final class RelayedPacket {
    static final String RULE = "rule[1]";

    /** Slots (SPEC 7.5): in a row, then as many as are drawn from so many on. */
    private record Draw(int first, int from, int spread, boolean mayTurn) {}

    private static final int TURN = 45;
    private static final int SPREAD = 8;
    private static final Draw FROM_RESERVE = new Draw(8, TURN, 2 * SPREAD, false);
    private static final Draw DOUBTFUL = new Draw(30, 0, 16 * SPREAD, false);
    private static final Draw TO_MANY = new Draw(1, 0, SPREAD, false);
    private static final Map<String, Draw> DRAWS = Map.of(
            "RELAY_DRAW", new Draw(8, 0, 2 * SPREAD, false),
            "RELAY_DRAW_AGAIN", new Draw(6, 0, SPREAD, true),
            "RELAY_DRAW_REPEAT", new Draw(2, 20, SPREAD, true),
            "RELAY_DRAW_ANSWER", new Draw(1, 0, SPREAD / 2, false),
            "RELAY_DRAW_ANSWER_AGAIN", new Draw(6, 0, SPREAD, true),
            "RELAY_DRAW_ANSWER_REPEAT", new Draw(6, 14, SPREAD, false));
    /** Slots after which a packet for many that comes again is copied again. */
    private static final int AGAIN_SLOTS = 128;
    private static final int LATE_MILLIS = 1500;
    private static final int AGAIN_MILLIS = 200;
    private static final double MILLIS = 1000;
    private static final int MARK_AT = 15;
    private static final int SOON = 24;

    final Payload packet;
    private final Model model;
    final Instance instance;
    private final BoardAir air;
    Transmission answer;
    /** One more than the distance that its copies tell; 0 if they tell none. */
    int told;
    Timer due = Timer.NONE;
    /** The hops that its first copy may tell, if what began it may have been one of several. */
    private Set<Integer> mayTell = Set.of();
    /** When something happened to it last, in seconds. */
    private double happened;
    /** The slots of quiet times that are over, of those that count since a moment. */
    private Interval counted = Interval.of(0);
    private double since;
    boolean isSoon;
    double spent;
    boolean isOnAir;

    RelayedPacket(Payload packet, Model model, BoardAir air) {
        this.packet = packet;
        this.model = model;
        this.air = air;
        instance = model.instance(packet.origin() + " to " + packet.destination());
    }

    /** The automaton with the firmware's times, in milliseconds. */
    static Model model() {
        Map<String, Integer> times = Map.of("LATE", LATE_MILLIS, "AGAIN", AGAIN_MILLIS);
        return new Model(Model.read("relay.xml"), "Relay", times, 1, 0, 0);
    }

    /** Whether relays copy such packets. */
    static boolean isCopied(Payload packet) {
        return switch (packet.kind()) {
            case UNICAST -> packet.hasNonce();
            case MULTICAST, BROADCAST -> true;
            default -> false;
        };
    }

    /** The packet as RELAY_NEW tells of it. */
    static int mark(Payload packet) {
        return packet.bytes().length() > MARK_AT ? packet.bytes().at(MARK_AT) : 0;
    }

    boolean isToMany() {
        return packet.kind() != Payload.Kind.UNICAST;
    }

    boolean is(Payload heard) {
        return packet.equals(heard);
    }

    /** Whether the relay has told nothing of it in a run() in which it looks at another's copy that it must heed. */
    boolean isUnheeded(Transmission heard, double run) {
        boolean isAnswer = answer != null;
        boolean isOfThis = isAnswer ? isAnsweredWholeBy(heard.payload()) && heard.told() != 0 : is(heard.payload());
        if (!isOfThis || happened >= run || mayTell.size() > 1) {
            return false;
        }
        int from = isAnswer ? heard.told() - 1 : heard.hops();
        int further = Math.floorMod(from - instance.get("own"), TraceEvent.HOPS);
        boolean isUpstream = further == TraceEvent.HOPS - 1;
        return further == 0 ? isAnswer || due != Timer.NONE && instance.get("copied") == 0 : isAnswer == isUpstream;
    }

    boolean isAnswer(Payload heard) {
        return heard.isAcknowledgement() && packet.destination().equals(heard.origin())
                && packet.lastBits() == heard.answered();
    }

    /** Not about some of its fragments. */
    boolean isAnsweredWholeBy(Payload heard) {
        int length = heard.message().length();
        return isAnswer(heard) && (length == Payload.TAG_LENGTH || length == 2 * Payload.TAG_LENGTH);
    }

    void expect(Point point, String location) throws RefusedException {
        point.require(instance.isAt(location), location + ", not " + instance.location());
    }

    /** It, or its acknowledgement, comes, and ends what was due. */
    void take(Point point, Transmission comes, int score, Map<String, Integer> effect) throws RefusedException {
        boolean isAnswer = comes.payload().isAcknowledgement();
        int from = !isAnswer ? comes.hops() : comes.told() == 0 ? model.constant("DIRECT") : comes.told() - 1;
        instance.take(point, point.name(), Map.of("at", at(point), "kind", model.constant(isAnswer ? "ACK" : "DATA"),
                "hops", from, "by", model.constant("SENDER"), "genuine", 1, "spent", 0, "doubt", score), effect);
        due = Timer.NONE;
        happened = point.seconds();
    }

    /** One of those comes. */
    void take(Point point, List<Transmission> mayCome, int score) throws RefusedException {
        RefusedException refusal = null;
        int own = instance.get("own");
        for (int told : Stream.concat(Stream.of(own), mayTell.stream()).toList()) {
            instance.set("own", told);
            for (Transmission comes : mayCome) {
                try {
                    take(point, comes, score, Map.of());
                    return;
                } catch (RefusedException refused) {
                    refusal = refusal == null ? refused : refusal;
                }
            }
        }
        instance.set("own", own);
        throw refusal;
    }

    /** It has begun with one of those. */
    void begin(List<Transmission> mayCome) {
        mayTell = mayCome.stream().map(comes -> (comes.hops() + 1) % TraceEvent.HOPS).collect(Collectors.toSet());
    }

    /** Its copy tells so many hops. */
    void tells(int hops) {
        if (mayTell.contains(hops)) {
            instance.set("own", hops);
        }
        mayTell = Set.of();
    }

    /** Milliseconds as the model has them, in which packets for many are late at the same time as others. */
    private int at(Point point) {
        Interval age = age(point).times(MILLIS / air.second());
        int late = isToMany() && air.isTimed() ? (int) Math.round(AGAIN_SLOTS * air.slot() / air.second() * MILLIS)
                : LATE_MILLIS;
        return age.holds(late) ? LATE_MILLIS
                : age.holds(AGAIN_MILLIS) ? AGAIN_MILLIS : (int) age.most() + LATE_MILLIS - late;
    }

    /** How long ago something happened to it, in seconds. */
    Interval age(Point point) {
        double age = point.seconds() - happened;
        double error = 2 * PhysicalLimits.MILLIS_STEP_SECONDS * air.second();
        return new Interval(age - error, age + error);
    }

    /** Quiet slots count from here. */
    void restart(Point point) {
        happened = point.seconds();
        counted = Interval.of(0);
        since = point.run();
    }

    /** The board's air has become busy or quiet. */
    void air(Point point) {
        if (air.isBusy()) {
            due.busy(point);
            counted = counted.plus(slots(air.quiet().last(), air.quiet().until()));
        }
    }

    /** Quiet slots since the end of its last copy, or since it came. */
    Interval quiet(Point point) {
        return !air.isTimed() ? Interval.ANY
                : air.isBusy() ? counted : counted.plus(slots(point.runBefore(), point.run()));
    }

    private Interval slots(double least, double most) {
        double from = Math.max(since, air.quiet().from());
        return new Interval(air.slots(from, least).least(), air.slots(from, most).most() + 1);
    }

    void draw(Point point) throws RefusedException {
        boolean isOfAnswer = point.name().startsWith("RELAY_DRAW_ANSWER");
        expect(point, isOfAnswer ? "Carrying" : "Waiting");
        point.require(!isToMany() || point.is("RELAY_DRAW"), "one copy of what is for many");
        Draw draw = DRAWS.get(point.name());
        if (point.is("RELAY_DRAW") && instance.get("repeated") == 1) {
            draw = isToMany() ? TO_MANY : instance.get("reserved") == 1 ? FROM_RESERVE : told == 0 ? DOUBTFUL : draw;
        }
        boolean mayTurn = draw.mayTurn && !(point.is("RELAY_DRAW_AGAIN") && instance.get("handed") == 1);
        int slots = point.operand("slots");
        int drawn = slots - draw.from;
        boolean isTurn = mayTurn && drawn >= TURN && drawn < TURN + draw.spread;
        point.require(drawn >= 0 && drawn < draw.spread || isTurn, draw.from + " to " + (draw.from + draw.spread - 1)
                + (mayTurn ? " slots, or " + TURN + " more" : " slots"));
        due = air.slots(point, draw.first, slots, isOfAnswer ? "RELAY_ANSWER" : "RELAY_COPY");
    }

    void send(Point point) throws RefusedException {
        due.checkNotEarly(point);
        due = Timer.NONE;
        instance.take(point);
    }

    void checkSoon(Point point, boolean isTold) throws RefusedException {
        boolean isCopied = instance.get("copied") == 1;
        Interval quiet = quiet(point);
        point.require(isSoon ? isTold : isTold ? isCopied && quiet.least() < SOON : !isCopied || quiet.most() >= SOON,
                "that soon is less than " + SOON + " quiet slots behind a copy");
        isSoon = isTold;
    }
}
