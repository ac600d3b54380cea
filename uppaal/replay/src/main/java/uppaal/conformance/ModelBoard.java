package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** What a board declares of its messages, and what its host says of them. */
final class ModelBoard {
    private static final int NO_KEY = 255;
    private static final int NUMBERS = 256;
    private static final int NONE = -1;
    private static final int DATA = 1;
    private static final int QUESTION = 6;
    /** RADIO_ANSWERS_DROPPED of SPEC 4.5. */
    private static final int ANSWERS_DROPPED = 30;
    private static final Set<String> OF_SENDERS = Set.of("TAKE_UP", "RESEAL", "CONTEND", "PASSED", "SEND_PART", "SEND",
            "PART_SENT",
            "AWAIT", "COPIED", "ATTEMPT_FAILED", "FRAGMENTS_KNOWN", "FRAGMENTS_NEW", "STALE_HEARD", "SENT", "DELIVERED",
            "UNDELIVERED");
    /** What may be declared between that a host has taken a message and that an acknowledgement is owed. */
    private static final Set<String> WITHIN_TAKING = Set.of("OWE_DELIVERED", "COUNT", "FLOOR_STORED");

    private final DeliveryModels models;
    private final DeclaredAir air;
    private final Answers answers;
    private final Map<Integer, Sending> sending = new HashMap<>();
    private final Map<Integer, String> kinds = new HashMap<>();
    private final Map<Integer, String> outcomes = new HashMap<>();
    private int turn = NONE;
    /** In the order in which they came. */
    private final Map<Integer, Receiving> receiving = new LinkedHashMap<>();
    private int nextMessage;
    /** Of each key's sender the last that the host has taken: its repeats are acknowledged again. */
    private final Map<Integer, Receiving> taken = new HashMap<>();
    private final List<Receiving> unacknowledged = new ArrayList<>();
    private final Set<Integer> goneKeys = new HashSet<>();
    private boolean mayLackKeys;
    private double fragmentAt = Double.NEGATIVE_INFINITY;

    ModelBoard(DeliveryModels models, DeclaredAir air) {
        this.models = models;
        this.air = air;
        answers = new Answers(air, models);
    }

    void point(Point point) throws RefusedException {
        for (Sending each : sending.values()) {
            each.timer.checkNotLate(point);
        }
        answers.checkTimers(point);
        if (!unacknowledged.isEmpty() && !WITHIN_TAKING.contains(point.name())) {
            unacknowledged.get(0).acknowledge(point);
        }
        switch (point.name()) {
            case "BUSY" -> busy(point);
            case "QUIET" -> quiet(point);
            case "RELAY_COPY", "RELAY_ANSWER" -> busy(point);
            case "COUNT" -> {
                if (point.operand("counter") == ANSWERS_DROPPED) {
                    answers.dropFirst(point);
                }
            }
            case "MEMORY" -> {
                if (point.operand("kept") == 0) {
                    taken.clear();
                }
            }
            case "KEY_STORED" -> {
                goneKeys.remove(point.operand("key"));
                mayLackKeys = true; // of the session keys one may have gone
            }
            case "KEY_DELETED" -> {
                mayLackKeys = true;
                goneKeys.add(point.operand("key"));
                answers.forget(point);
                taken.remove(point.operand("key"));
                unacknowledged.removeIf(each -> each.key == point.operand("key"));
            }
            case "FRAGMENT" -> fragmentAt = point.run();
            case "QUEUED" -> {
                receiving.put(nextMessage, new Receiving(models, nextMessage, point));
                nextMessage = (nextMessage + 1) % NUMBERS;
            }
            case "HANDED" -> hand(point);
            case "TAKEN" -> take(point);
            case "OWE_DELIVERED", "OWE_FRAGMENTS", "OWE_STALE" -> owe(point);
            case "OWE_TWICE" -> last(answers.twice(point)).see(point, true);
            case "PUT_OFF" -> answers.putOff(point);
            case "ANSWER" -> {
                answers.send(point);
                busy(point);
            }
            default -> {
                if (OF_SENDERS.contains(point.name())) {
                    send(point);
                }
            }
        }
    }

    private void busy(Point point) throws RefusedException {
        for (Sending each : sending.values()) {
            each.timer.busy(point);
        }
        answers.busy(point);
        boolean wasBusy = air.isBusy();
        air.busy();
        if (!wasBusy) {
            air(point);
        }
    }

    private void quiet(Point point) throws RefusedException {
        if (air.isBusy()) {
            air.quiet(point);
            for (Sending each : sending.values()) {
                each.timer.quiet(point);
            }
            air(point);
        }
    }

    private void air(Point point) throws RefusedException {
        for (Sending each : sending.values()) {
            each.air(point);
        }
        answers.air(point);
    }

    /** Something of a message that it sends. */
    private void send(Point point) throws RefusedException {
        int number = point.number();
        boolean isCrowded = turn != NONE && turn != number;
        Sending message = sending.get(number);
        switch (point.name()) {
            case "TAKE_UP" -> message = takeUp(number, point);
            case "RESEAL" -> {
                known(message, point).see(point, isCrowded);
                message = new Sending(air, models, number, point.operand("key"), message.kind);
                sending.put(number, message);
            }
            case "CONTEND" -> turn = number;
            case "UNDELIVERED" -> {
                if (message == null || goneKeys.contains(message.key)) {
                    message = null;
                    point.require(mayLackKeys, "TAKE_UP, as it has all its keys");
                }
            }
            default -> {}
        }
        boolean isLost = message == null && point.is("UNDELIVERED");
        if (!isLost) {
            known(message, point).see(point, isCrowded);
        }
        switch (point.name()) {
            case "SEND", "SEND_PART" -> busy(point);
            case "PASSED", "ATTEMPT_FAILED", "STALE_HEARD" -> turn = turn == number ? NONE : turn;
            case "SENT", "DELIVERED", "UNDELIVERED" -> {
                turn = turn == number ? NONE : turn;
                sending.remove(number);
                kinds.remove(number);
                outcomes.put(number, point.name().toLowerCase(java.util.Locale.ROOT));
            }
            default -> {}
        }
    }

    private Sending takeUp(int number, Point point) throws RefusedException {
        int key = point.operand("key");
        point.require(!sending.containsKey(number) && (key == NO_KEY ||
                sending.values().stream().noneMatch(each -> each.key == key)),
                "the end of the one before to the same device");
        Sending message = new Sending(air, models, number, key, kinds.getOrDefault(number, ""));
        sending.put(number, message);
        return message;
    }

    private static Sending known(Sending message, Point point) throws RefusedException {
        point.require(message != null, "TAKE_UP first");
        return message;
    }

    /** Its host has asked for a transmission, or to relay one, which is sent as a broadcast is. */
    void transmit(int number, String kind) throws RefusedException {
        kinds.put(number, kind);
        if (sending.containsKey(number)) {
            sending.get(number).isOf(kind);
        }
    }

    void outcome(Point told, int number, String outcome) throws RefusedException {
        String declared = outcomes.remove(number);
        require(outcome.equals(declared), told.board() + " reports transmission " + number + " " + outcome,
                declared == null ? "that it has ended" : declared);
    }

    /** The host has got a message. */
    void handed(Point told, int number, String kind) throws RefusedException {
        known(told, number).isOfKind(kind, told);
    }

    private void hand(Point point) throws RefusedException {
        Receiving message = known(point, point.operand("message"));
        boolean isNext = receiving.values().stream().takeWhile(each -> each != message).allMatch(each -> each.isHanded);
        message.see(point, isNext);
    }

    private Receiving known(Point point, int number) throws RefusedException {
        Receiving message = receiving.get(number);
        require(message != null, point.board() + " hands over message " + number, "QUEUED before");
        return message;
    }

    /** The host takes all up to a message, if that is still here. */
    void takes(Point told, int number) throws RefusedException {
        for (Receiving each : until(number)) {
            each.see(told, true);
        }
    }

    private List<Receiving> until(int number) {
        List<Receiving> all = new ArrayList<>();
        if (receiving.containsKey(number)) {
            for (Receiving each : receiving.values()) {
                all.add(each);
                if (each.number == number) {
                    break;
                }
            }
        }
        return all;
    }

    private void take(Point point) throws RefusedException {
        List<Receiving> all = until(point.operand("message"));
        point.require(!all.isEmpty(), "one that is in its inbox");
        for (Receiving each : all) {
            each.see(point, true);
            receiving.remove(each.number);
            if (each.key != NO_KEY && each.isUnicast && !goneKeys.contains(each.key)) {
                unacknowledged.add(each);
                taken.put(each.key, each);
            }
        }
    }

    private void owe(Point point) throws RefusedException {
        if (!unacknowledged.isEmpty()) {
            unacknowledged.remove(0).acknowledge(point);
        } else if (point.is("OWE_DELIVERED")) {
            last(point).see(point, true);
        } else {
            int kind = point.is("OWE_FRAGMENTS") ? QUESTION : DATA; // of what it does not have
            models.receiver("unicast", point.operand("nonce")).take(point, point.name(),
                    DeliveryModels.outside(Map.of("kind", kind)));
        }
        point.require(!point.is("OWE_FRAGMENTS") || fragmentAt == point.run(), "FRAGMENT in the same run()");
        answers.owe(point);
    }

    private Receiving last(Point point) throws RefusedException {
        Receiving last = taken.get(point.operand("key"));
        point.require(last != null && last.isOf(point), "one that its host has taken last of this key");
        return last;
    }

    /** It begins anew; what its RAM keeps it tells then. */
    void reset() {
        sending.clear();
        kinds.clear();
        outcomes.clear();
        receiving.clear();
        unacknowledged.clear();
        answers.reset();
        turn = NONE;
        nextMessage = 0;
        air.busy();
    }
}
