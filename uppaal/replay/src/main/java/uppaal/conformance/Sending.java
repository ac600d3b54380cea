package uppaal.conformance;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** A message at its sender's board. It is followed once its kind is known, and whether it is in fragments. */
final class Sending {
    private static final int FIRST_SLOTS = 6;
    private static final int MOST_SLOTS_OF_TURN = 7;
    private static final int NO_KEY = 255;
    private static final int ROUNDS_WITH_RELAY = 20;
    private static final String UNICAST = "unicast";
    private static final Set<String> OF_UNICASTS = Set.of("AWAIT", "COPIED", "FRAGMENTS_KNOWN", "FRAGMENTS_NEW",
            "STALE_HEARD", "DELIVERED");
    /** What the automaton's sender hears, as the model has it. */
    private static final Map<String, Integer> KINDS = Map.of("DELIVERED", 2, "FRAGMENTS_KNOWN", 3, "FRAGMENTS_NEW", 3,
            "STALE_HEARD", 4, "COPIED", 7);

    final int key;
    private final DeclaredAir air;
    private final DeliveryModels models;
    private final int number;
    private final List<Seen> before = new ArrayList<>();
    String kind;
    private Instance instance;
    private int contentions;
    private boolean isContending;
    /** Its fragments: all; those that its receiver has had; those that this attempt has to send; the last sent. */
    private int all;
    private int arrived;
    private int pending;
    private int onAir;
    Timer timer = Timer.NONE;

    /** A point of it, or one by which only the air changes. */
    private record Seen(Point point, boolean isOwn, boolean isBusy, boolean isCrowded) {}

    /** @param kind empty if it is not known yet */
    Sending(DeclaredAir air, DeliveryModels models, int number, int key, String kind) {
        this.air = air;
        this.models = models;
        this.number = number;
        this.key = key;
        this.kind = key == NO_KEY ? "broadcast" : kind;
    }

    /** The host has asked for it. */
    void isOf(String destinations) throws RefusedException {
        kind = kind.isEmpty() ? destinations : kind;
        follow();
    }

    /**
     * Its board declares something of it.
     *
     * @param isCrowded whether another message has the turn
     */
    void see(Point point, boolean isCrowded) throws RefusedException {
        if (isContending && point.is("CONTEND")) {
            // What it draws anew, once another device is acknowledged, changes when it sends, and nothing else.
            point.require(point.operand("slots") <= MOST_SLOTS_OF_TURN, "at most " + MOST_SLOTS_OF_TURN + " slots");
            time(point);
            return;
        }
        isContending = point.is("CONTEND");
        contentions += DeliveryModels.flag(isContending);
        if (kind.isEmpty() && OF_UNICASTS.contains(point.name())) {
            kind = UNICAST;
        } else if (kind.isEmpty() && (point.is("SENT") || contentions > 1)) {
            kind = "multicast";
        }
        follow();
        if (!isOfNoUse(point)) {
            time(point);
            fragments(point);
        }
        before.add(new Seen(point, true, air.isBusy(), isCrowded));
        follow();
    }

    /** Its board's air becomes busy or quiet. */
    void air(Point point) throws RefusedException {
        before.add(new Seen(point, false, air.isBusy(), false));
        follow();
    }

    private void follow() throws RefusedException {
        if (instance == null && !kind.isEmpty() && all != 0) {
            boolean isCut = before.stream().anyMatch(seen -> seen.point.is("SEND_PART"));
            instance = models.sender(kind, isCut, number);
        }
        while (instance != null && !before.isEmpty()) {
            step(before.remove(0));
        }
    }

    private void step(Seen seen) throws RefusedException {
        Point point = seen.point;
        if (seen.isOwn && !isOfNoUse(point)) {
            boolean isTimeout = point.is("ATTEMPT_FAILED");
            if (isTimeout) {
                instance.set("left", 1);
            }
            if (instance.isAt("New", "Ready")) {
                instance.set("turn[1]", seen.isCrowded ? 2 : 0);
            }
            instance.take(point, point.name(), DeliveryModels.outside(Map.of("x", isTimeout ? 1 : 2, "busy",
                    DeliveryModels.flag(seen.isBusy), "kind", KINDS.getOrDefault(point.name(), 0))));
            check(point);
        }
        String heard = seen.isBusy ? "BUSY" : "QUIET";
        if (instance.can(heard)) {
            instance.take(point, heard, Map.of());
        }
    }

    /** An answer about fragments changes nothing if none lacks, or while an attempt goes on. */
    private boolean isOfNoUse(Point point) {
        if (!point.name().startsWith("FRAGMENTS_") || instance == null) {
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

    private void time(Point point) throws RefusedException {
        String what = "SEND of transmission " + number;
        switch (point.name()) {
            case "CONTEND" -> timer = air.slots(point, FIRST_SLOTS, point.operand("slots"), what);
            case "PART_SENT" -> timer = air.slots(point, 1, 0, what);
            case "AWAIT" -> timer = air.patience(point, point.operand("rounds") + 1);
            case "COPIED" -> timer = air.patience(point, ROUNDS_WITH_RELAY);
            case "FRAGMENTS_KNOWN", "FRAGMENTS_NEW" ->
                timer = timer == Timer.NONE ? timer : air.slots(point, 1, 0, what);
            case "SEND", "SEND_PART", "ATTEMPT_FAILED" -> {
                timer.checkNotEarly(point);
                timer = Timer.NONE;
            }
            default -> timer = Timer.NONE;
        }
    }
}
