package uppaal.conformance;

import java.util.Map;
import javino.protocol.Payload;

/** What a relay knows of one of its packets. */
final class RelayedPacket {
    /** Slots (SPEC 7.5): in a row, then as many as are drawn from so many on. */
    record Draw(String due, int first, int from, int spread, boolean turn) {}

    private static final int TURN = 45;
    private static final int SPREAD = 8;
    /** Of a packet whose pair's score is 1 or 2. */
    private static final Draw DOUBTFUL = new Draw("RELAY_COPY", 30, 0, 16 * SPREAD, false);
    static final Map<String, Draw> DRAWS = Map.of(
            "RELAY_DRAW", new Draw("RELAY_COPY", 8, 0, SPREAD, false),
            "RELAY_DRAW_AGAIN", new Draw("RELAY_COPY", 6, 0, SPREAD, true),
            "RELAY_DRAW_REPEAT", new Draw("RELAY_COPY", 2, 20, SPREAD, true),
            "RELAY_DRAW_ANSWER", new Draw("RELAY_ANSWER", 1, 0, SPREAD / 2, false),
            "RELAY_DRAW_ANSWER_AGAIN", new Draw("RELAY_ANSWER", 6, 0, SPREAD, true),
            "RELAY_DRAW_ANSWER_REPEAT", new Draw("RELAY_ANSWER", 6, 14, SPREAD, false));
    static final int SOON = 24;

    final Payload packet;
    final Instance instance;
    private final DeclaredAir air;
    Payload answer;
    Timer due = Timer.NONE;
    /** When something happened to it last, in seconds. */
    double happened;
    /** Quiet slots since the end of its last copy, or since it came in reserve: at least and at most. */
    double quietLeast;
    double quietMost;
    double quietFrom;
    boolean soon;
    boolean fromReserve;
    double spent;
    boolean sends;

    RelayedPacket(Payload packet, Instance instance, DeclaredAir air) {
        this.packet = packet;
        this.instance = instance;
        this.air = air;
    }

    void restartQuiet(Point point) {
        quietLeast = 0;
        quietMost = 0;
        quietFrom = point.run();
    }

    String pair() {
        String one = packet.destination();
        String other = packet.origin();
        return one.compareTo(other) < 0 ? one + other : other + one;
    }

    boolean isAnswer(Payload heard) {
        return heard.isAcknowledgement() && packet.destination().equals(heard.origin())
                && packet.lastBits() == heard.answered();
    }

    /** Counts the quiet slots up to a moment between two. */
    void count(double least, double most) {
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
        boolean isDoubtful = point.is("RELAY_DRAW") && !fromReserve && instance.get("repeated") == 1;
        Draw draw = isDoubtful ? DOUBTFUL : DRAWS.get(point.name());
        int slots = point.operand("slots");
        int from = draw.from + (point.is("RELAY_DRAW") && fromReserve ? TURN : 0);
        boolean mayTurn = draw.turn && !(point.is("RELAY_DRAW_AGAIN") && instance.get("handed") == 1);
        boolean isIn = slots >= from && slots < from + draw.spread
                || mayTurn && slots >= from + TURN && slots < from + TURN + draw.spread;
        point.require(isIn,
                from + " to " + (from + draw.spread - 1) + (mayTurn ? " slots, or " + TURN + " more" : " slots"));
        due = air.slots(point, draw.first, slots, draw.due);
    }

    boolean isSoon(Point point, boolean told) throws RefusedException {
        count(point.run() - point.gap(), point.run());
        boolean copied = instance.get("copied") == 1;
        boolean mustBe = soon || copied && quietMost < SOON;
        boolean mayBe = soon || copied && quietLeast < SOON;
        point.require(told ? mayBe : !mustBe, "that soon is less than " + SOON + " quiet slots behind a copy");
        return told;
    }

    void stop(Point point) throws RefusedException {
        due.checkNotLate(point);
        due = Timer.NONE;
        happened = point.seconds();
    }
}
