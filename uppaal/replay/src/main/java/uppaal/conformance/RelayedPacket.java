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
    /** Slots after which a copy for many is not sent any more, and those after which another one is. */
    private static final int MOST_SLOTS = 256;
    private static final int AGAIN_SLOTS = 128;
    private static final int MARK_AT = 15;
    static final Map<String, Draw> DRAWS = Map.of(
            "RELAY_DRAW", new Draw("RELAY_COPY", 8, 0, 2 * SPREAD, false),
            "RELAY_DRAW_AGAIN", new Draw("RELAY_COPY", 6, 0, SPREAD, true),
            "RELAY_DRAW_REPEAT", new Draw("RELAY_COPY", 2, 20, SPREAD, true),
            "RELAY_DRAW_ANSWER", new Draw("RELAY_ANSWER", 1, 0, SPREAD / 2, false),
            "RELAY_DRAW_ANSWER_AGAIN", new Draw("RELAY_ANSWER", 6, 0, SPREAD, true),
            "RELAY_DRAW_ANSWER_REPEAT", new Draw("RELAY_ANSWER", 6, 14, SPREAD, false));
    private static final int SOON = 24;

    final Payload packet;
    final Instance instance;
    private final DeclaredAir air;
    Transmission answer;
    /** One more than the distance that its copies tell; 0 if they tell none. */
    int told;
    Timer due = Timer.NONE;
    /** When something happened to it last, in seconds. */
    double happened;
    /** Quiet slots since the end of its last copy, or since it came in reserve: at least and at most. */
    double quietLeast;
    double quietMost;
    double quietFrom;
    boolean soon;
    double spent;
    boolean sends;

    RelayedPacket(Payload packet, Instance instance, DeclaredAir air) {
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
    double lateSeconds() {
        return isToMany() && air.isTimed() ? AGAIN_SLOTS * air.slot() / air.second() : Relay.LATE_MILLIS / 1e3;
    }

    /** Whether a copy for many comes too late, by so many steps of the clock at least. */
    boolean isLate(Point point, int steps) {
        return isToMany() && air.isTimed() && point.seconds() - happened > MOST_SLOTS * air.slot()
                + 2 * steps * PhysicalLimits.MILLIS_STEP_SECONDS * air.second();
    }

    void restartQuiet(Point point) {
        quietLeast = 0;
        quietMost = 0;
        quietFrom = point.run();
    }

    boolean is(Payload heard) {
        return packet.equals(heard);
    }

    boolean isAnswer(Payload heard) {
        return heard.isAcknowledgement() && packet.destination().equals(heard.origin())
                && packet.lastBits() == heard.answered();
    }

    /** Counts the quiet slots up to a moment between two. */
    void count(Point point) {
        double least = point.run() - point.gap();
        double most = point.run();
        if (!air.isTimed()) {
            quietMost = Double.POSITIVE_INFINITY;
        } else if (!air.isBusy()) {
            double error = PhysicalLimits.MILLIS_STEP_SECONDS / air.slot();
            quietLeast += Math.max(0, Math.floor((least - quietFrom) / air.slot() - error));
            quietMost += Math.max(0, Math.floor((most - quietFrom) / air.slot() + error) + 1);
        }
        quietFrom = most;
    }

    void expect(Point point, String location) throws RefusedException {
        point.require(instance.isAt(location), location + ", not " + instance.location());
    }

    void draw(Point point) throws RefusedException {
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
        count(point);
        boolean copied = instance.get("copied") == 1;
        boolean mustBe = soon || copied && quietMost < SOON;
        boolean mayBe = soon || copied && quietLeast < SOON;
        point.require(isTold ? mayBe : !mustBe, "that soon is less than " + SOON + " quiet slots behind a copy");
        soon = isTold;
    }

    void stop(Point point) throws RefusedException {
        due.checkNotLate(point);
        due = Timer.NONE;
        happened = point.seconds();
    }
}
