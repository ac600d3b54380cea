package uppaal.conformance;

import java.util.Map;
import javino.protocol.Payload;

/** What a relay knows of one of its packets. */
final class RelayedPacket {
    /** Slots (SPEC 7.5): in a row, then as many as are drawn from so many on. */
    record Draw(String due, int first, int from, int spread, boolean turn) {}

    private static final int TURN = 45;
    private static final int SPREAD = 8;
    private static final Draw FROM_RESERVE = new Draw("RELAY_COPY", 8, TURN, 2 * SPREAD, false);
    private static final Draw DOUBTFUL = new Draw("RELAY_COPY", 30, 0, 16 * SPREAD, false);
    private static final Draw TO_MANY = new Draw("RELAY_COPY", 1, 0, SPREAD, false);
    /** Slots after which a packet for many that comes again is copied again. */
    private static final int AGAIN_SLOTS = 128;
    private static final int MARK_AT = 15;
    private static final Map<String, Draw> DRAWS = Map.of(
            "RELAY_DRAW", new Draw("RELAY_COPY", 8, 0, 2 * SPREAD, false),
            "RELAY_DRAW_AGAIN", new Draw("RELAY_COPY", 6, 0, SPREAD, true),
            "RELAY_DRAW_REPEAT", new Draw("RELAY_COPY", 2, 20, SPREAD, true),
            "RELAY_DRAW_ANSWER", new Draw("RELAY_ANSWER", 1, 0, SPREAD / 2, false),
            "RELAY_DRAW_ANSWER_AGAIN", new Draw("RELAY_ANSWER", 6, 0, SPREAD, true),
            "RELAY_DRAW_ANSWER_REPEAT", new Draw("RELAY_ANSWER", 6, 14, SPREAD, false));
    private static final int SOON = 24;

    final Payload packet;
    final Instance instance;
    private final BoardAir air;
    Transmission answer;
    /** One more than the distance that its copies tell; 0 if they tell none. */
    int told;
    Timer due = Timer.NONE;
    /** When something happened to it last, in seconds. */
    private double happened;
    /** The slots of quiet times that are over, of those that count since a moment. */
    private Interval counted = Interval.of(0);
    private double since;
    boolean soon;
    double spent;
    boolean sends;

    RelayedPacket(Payload packet, Instance instance, BoardAir air) {
        this.packet = packet;
        this.instance = instance;
        this.air = air;
    }

    /** Whether relays copy such packets. */
    static boolean isCopied(Payload packet) {
        return switch (packet.kind()) {
            case UNICAST -> packet.hasNonce();
            case MULTICAST, BROADCAST -> true;
            default -> false;
        };
    }

    /** What RELAY_NEW tells of it. */
    static int mark(Payload packet) {
        return packet.bytes().length() > MARK_AT ? packet.bytes().at(MARK_AT) : 0;
    }

    boolean isToMany() {
        return packet.kind() != Payload.Kind.UNICAST;
    }

    /** From when on it begins anew where it comes again. */
    int lateMillis() {
        return isToMany() && air.isTimed() ? (int) Math.round(AGAIN_SLOTS * air.slot() / air.second() * 1e3)
                : Relay.LATE_MILLIS;
    }

    /** How long ago something happened to it, in seconds. */
    Interval age(Point point) {
        double age = point.seconds() - happened;
        double error = 2 * PhysicalLimits.MILLIS_STEP_SECONDS * air.second();
        return new Interval(age - error, age + error);
    }

    /** It is new, or as if it were. */
    void begin(Point point) {
        restart(point);
        soon = false;
        due = Timer.NONE;
    }

    void reserve(Point point) throws RefusedException {
        expect(point, "Reserve");
        restart(point);
    }

    /** Quiet slots count from here. */
    void restart(Point point) {
        happened = point.seconds();
        counted = Interval.of(0);
        since = point.run();
    }

    boolean is(Payload heard) {
        return packet.equals(heard);
    }

    boolean isAnswer(Payload heard) {
        return heard.isAcknowledgement() && packet.destination().equals(heard.origin())
                && packet.lastBits() == heard.answered();
    }

    /** The board's air has become busy or quiet. */
    void air(Point point) {
        if (air.isBusy()) {
            due.busy();
            counted = counted.plus(slots(point));
        }
    }

    /** Quiet slots since the end of its last copy, or since it came in reserve. */
    Interval quiet(Point point) {
        return !air.isTimed() ? Interval.ANY : air.isBusy() ? counted : counted.plus(slots(point));
    }

    private Interval slots(Point point) {
        double from = Math.max(since, air.quiet().from());
        return new Interval(air.slots(from, point.run() - point.gap()).least(), air.slots(from, point.run()).most() + 1);
    }

    private void expect(Point point, String location) throws RefusedException {
        point.require(instance.isAt(location), location + ", not " + instance.location());
    }

    void draw(Point point) throws RefusedException {
        expect(point, point.name().startsWith("RELAY_DRAW_ANSWER") ? "Carrying" : "Waiting");
        boolean isUnsure = point.is("RELAY_DRAW") && instance.get("repeated") == 1;
        Draw draw = !isUnsure ? DRAWS.get(point.name())
                : isToMany() ? TO_MANY
                        : instance.get("reserved") == 1 ? FROM_RESERVE : told == 0 ? DOUBTFUL : DRAWS.get(point.name());
        point.require(!isToMany() || point.is("RELAY_DRAW"), "one copy of what is for many");
        int slots = point.operand("slots");
        boolean mayTurn = draw.turn && !(point.is("RELAY_DRAW_AGAIN") && instance.get("handed") == 1);
        boolean isIn = slots >= draw.from && slots < draw.from + draw.spread
                || mayTurn && slots >= draw.from + TURN && slots < draw.from + TURN + draw.spread;
        point.require(isIn, draw.from + " to " + (draw.from + draw.spread - 1)
                + (mayTurn ? " slots, or " + TURN + " more" : " slots"));
        due = air.slots(point, draw.first, slots, draw.due);
    }

    void checkSoon(Point point, boolean isTold) throws RefusedException {
        boolean isCopied = instance.get("copied") == 1;
        Interval quiet = quiet(point);
        point.require(soon ? isTold : isTold ? isCopied && quiet.least() < SOON : !isCopied || quiet.most() >= SOON,
                "that soon is less than " + SOON + " quiet slots behind a copy");
        soon = isTold;
    }

    /** Something happens to it, by which what is due is not sent. */
    void stop(Point point) {
        due = Timer.NONE;
        happened = point.seconds();
    }
}
