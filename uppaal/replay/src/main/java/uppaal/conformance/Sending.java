package uppaal.conformance;

import java.util.Map;

/** A message at its sender's board. */
final class Sending {
    private static final int FIRST_SLOTS = 6;
    private static final int MOST_SLOTS_OF_TURN = 7;
    /** The packets that the automaton's sender hears, as the model has it. */
    private static final Map<String, Integer> KINDS = Map.of("DELIVERED", 2, "FRAGMENTS_KNOWN", 3, "FRAGMENTS_NEW", 3,
            "STALE_HEARD", 4, "COPIED", 7);

    final int key;
    private final BoardAir air;
    private final DeliveryModels models;
    private final int number;
    private final String kind;
    private Instance instance;
    /** Its fragments: all; those that its receiver has had; those that this attempt has to send; the last sent. */
    private int all;
    private int arrived;
    private int pending;
    private int onAir;
    private Timer timer = Timer.NONE;

    Sending(BoardAir air, DeliveryModels models, int number, int key, String kind) {
        this.air = air;
        this.models = models;
        this.number = number;
        this.key = key;
        this.kind = kind;
        instance = models.sender(kind, false, number);
    }

    /** The same one with another key. */
    Sending anew(Point reseal) {
        return new Sending(air, models, number, reseal.operand("key"), kind);
    }

    Timer timer() {
        return timer;
    }

    boolean hasTurn() {
        return instance.get("turn[1]") == 1;
    }

    /**
     * Its board declares something of it.
     *
     * @param isCrowded whether another message has the turn
     */
    void see(Point point, boolean isCrowded) throws RefusedException {
        boolean isTimeout = point.is("ATTEMPT_FAILED");
        if (isTimeout || point.name().startsWith("SEND")) {
            timer.checkNotEarly(point);
        }
        if (isTimeout && instance.isAt("Held")) {
            instance.take(point, "QUIET", Map.of()); // its patience was over as its board began to send
        }
        if (point.is("CONTEND") && instance.isAt("Contending", "Deferred")) {
            // A wait that is drawn anew, once another device is acknowledged, changes only when the board sends.
            point.require(point.operand("slots") <= MOST_SLOTS_OF_TURN, "at most " + MOST_SLOTS_OF_TURN + " slots");
        } else if (isOfNoUse(point)) {
            return;
        } else {
            fragments(point);
            prepare(point, isCrowded);
            instance.take(point, point.name(), DeliveryModels.outside(Map.of("x", isTimeout ? 1 : 2, "busy",
                    DeliveryModels.flag(air.isBusy()), "kind", KINDS.getOrDefault(point.name(), 0))));
            check(point);
        }
        timer = next(point);
        instance.hear(point, air.isBusy());
    }

    /** Its board's air has become busy or quiet. */
    void air(Point point) throws RefusedException {
        if (air.isBusy()) {
            timer.busy(point);
        }
        instance.hear(point, air.isBusy());
    }

    private void prepare(Point point, boolean isCrowded) {
        if (point.is("SEND_PART")) {
            instance.become(models.sender(kind, true, number));
        } else if (point.is("ATTEMPT_FAILED")) {
            instance.set("left", 1);
        }
        if (instance.isAt("New", "Ready")) {
            instance.set("turn[1]", isCrowded ? 2 : 0);
        }
    }

    /** An answer about fragments changes nothing if none lacks, or while an attempt goes on. */
    private boolean isOfNoUse(Point point) {
        if (!point.name().startsWith("FRAGMENTS_")) {
            return false;
        }
        arrived |= point.operand("have");
        return point.operand("have") == all || instance.isAt("Part", "OnAir", "Pausing", "PutOff");
    }

    private void check(Point point) throws RefusedException {
        point.require(!point.is("AWAIT") || instance.get("left") == point.operand("rounds") + 1,
                "rounds " + (instance.get("left") - 1));
        if (point.is("ATTEMPT_FAILED")) {
            point.require(instance.get("attempt") == point.operand("attempts"), "attempts " + instance.get("attempt"));
            pending = (arrived & instance.get("attempt") & 1) != 0 ? onAir : 1;
        }
    }

    /** An attempt sends in order: first all; then what an answer lacks, or one that asks for an answer. */
    private void fragments(Point point) throws RefusedException {
        if (point.name().startsWith("FRAGMENTS_")) {
            pending = all & ~point.operand("have");
        } else if (point.name().startsWith("SEND")) {
            int told = point.operand("pending");
            all = all == 0 ? told : all;
            pending = pending == 0 ? all : pending;
            point.require(told == pending && Integer.bitCount(all + 1) == 1, "pending " + pending);
            onAir = Integer.lowestOneBit(told);
            pending = told == onAir ? all : told & ~onAir;
        }
    }

    private Timer next(Point point) {
        String send = "SEND of transmission " + number;
        return switch (instance.location()) {
            case "Contending", "Deferred" -> air.slots(point, FIRST_SLOTS, point.operand("slots"), send);
            case "Pausing", "PutOff" -> air.slots(point, 1, 0, send);
            case "Awaiting", "Held" ->
                air.patience(point, instance.get("left"), "ATTEMPT_FAILED of transmission " + number);
            default -> Timer.NONE;
        };
    }
}
