package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Counter;

/** A board's points about its messages, and its host's word about them. */
final class ModelBoard {
    private static final int NO_KEY = 255;
    private static final int NUMBERS = 256;
    private static final Set<String> OF_SENDERS = Set.of("TAKE_UP", "RESEAL", "CONTEND", "PASSED", "SEND_PART", "SEND",
            "PART_SENT", "AWAIT", "COPIED", "ATTEMPT_FAILED", "FRAGMENTS_KNOWN", "FRAGMENTS_NEW", "STALE_HEARD", "SENT",
            "DELIVERED", "UNDELIVERED");
    /** The points between a message's being taken by a host and its acknowledgement's being owed. */
    private static final Set<String> WITHIN_TAKING = Set.of("OWE_DELIVERED", "COUNT", "FLOOR_STORED");

    private final DeliveryModels models;
    private final BoardAir air;
    private final Answers answers;
    private final Map<Integer, Sending> sending = new HashMap<>();
    private final Map<Integer, String> kinds = new HashMap<>();
    /** When their hosts were told that the board will send them. */
    private final Map<Integer, Double> accepted = new HashMap<>();
    /** In the order in which they came. */
    private final Map<Integer, Receiving> receiving = new LinkedHashMap<>();
    private int nextMessage;
    /** The last message of each key's sender that the host has taken: its repeats are acknowledged again. */
    private final Map<Integer, Receiving> taken = new HashMap<>();
    private final Deque<Receiving> unacknowledged = new ArrayDeque<>();
    /** What the host has taken last, by number: a reply to an earlier poll may still hand it over. */
    private final Map<Integer, Receiving> takenLast = new HashMap<>();
    private final Set<Integer> goneKeys = new HashSet<>();
    private boolean mayLackKeys;
    private double fragmentAt = Double.NEGATIVE_INFINITY;
    /** Since when messages wait and none has the turn; infinite while one has. */
    private double idleSince = Double.POSITIVE_INFINITY;

    ModelBoard(DeliveryModels models, BoardAir air) {
        this.models = models;
        this.air = air;
        answers = new Answers(air, models);
    }

    void point(Point point) throws RefusedException {
        for (Sending each : sending.values()) {
            each.timer().checkNotLate(point);
        }
        answers.checkTimers(point);
        point.require(idleSince == Double.POSITIVE_INFINITY || point.runBefore() <= idleSince,
                "CONTEND before, as messages wait and none has the turn");
        if (!unacknowledged.isEmpty() && !WITHIN_TAKING.contains(point.name())) {
            unacknowledged.getFirst().acknowledge(point);
        }
        switch (point.name()) {
            case "COUNT" -> {
                if (point.counter().equals(Optional.of(Counter.RADIO_ANSWERS_DROPPED))) {
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
            case "KEY_DELETED" -> delete(point, point.operand("key"));
            case "FRAGMENT" -> fragmentAt = point.run();
            case "QUEUED" -> {
                receiving.put(nextMessage, new Receiving(models, nextMessage, point));
                nextMessage = (nextMessage + 1) % NUMBERS;
            }
            case "HANDED" -> hand(point);
            case "TAKEN" -> take(point);
            case "OWE_DELIVERED", "OWE_FRAGMENTS", "OWE_STALE" -> owe(point);
            case "OWE_TWICE" -> last(answers.twice(point)).see(point);
            case "PUT_OFF" -> answers.putOff(point);
            case "ANSWER" -> answers.send(point);
            default -> {
                if (OF_SENDERS.contains(point.name())) {
                    send(point, point.number());
                }
            }
        }
        if (air.changes(point)) {
            for (Sending each : sending.values()) {
                each.air(point);
            }
            answers.air(point);
        }
        idle(point.seconds());
    }

    private void idle(double now) {
        boolean isIdle = accepted.values().stream().anyMatch(told -> told < now)
                && sending.values().stream().noneMatch(Sending::hasTurn);
        idleSince = isIdle ? Math.min(idleSince, now) : Double.POSITIVE_INFINITY;
    }

    private void delete(Point point, int key) {
        mayLackKeys = true;
        goneKeys.add(key);
        answers.forget(point);
        taken.remove(key);
        unacknowledged.removeIf(each -> each.key == key);
    }

    /** Something of a message that it sends. */
    private void send(Point point, int number) throws RefusedException {
        if (point.is("TAKE_UP")) {
            takeUp(point, number);
        } else if (point.is("RESEAL")) {
            Sending before = known(point, number);
            before.see(point, false);
            sending.put(number, before.anew(point));
        }
        Sending message = sending.get(number);
        if (point.is("UNDELIVERED") && (message == null || goneKeys.contains(message.key))) {
            point.require(mayLackKeys, "TAKE_UP, as it has all its keys");
        } else {
            known(point, number).see(point,
                    sending.values().stream().anyMatch(each -> each != message && each.hasTurn()));
        }
        if (point.is("SENT") || point.is("DELIVERED") || point.is("UNDELIVERED")) {
            sending.remove(number);
            kinds.remove(number);
            accepted.remove(number);
        }
    }

    private void takeUp(Point point, int number) throws RefusedException {
        int key = point.operand("key");
        point.require(!sending.containsKey(number) && (key == NO_KEY ||
                sending.values().stream().noneMatch(each -> each.key == key)),
                "the end of the one before to the same device");
        // A sketch without a host sends broadcasts alone.
        String kind = key == NO_KEY ? "broadcast" : kinds.get(number);
        point.require(kind != null, "that its host has asked for it");
        sending.put(number, new Sending(air, models, number, key, kind));
    }

    private Sending known(Point point, int number) throws RefusedException {
        point.require(sending.containsKey(number), "TAKE_UP first");
        return sending.get(number);
    }

    /** Its host has asked for a transmission, or to relay one, which is sent as a broadcast is. */
    void transmit(int number, String kind, double seconds) {
        kinds.put(number, kind);
        accepted.put(number, seconds);
    }

    /** The host has got a message. */
    void handed(Point told, int number, String kind) throws RefusedException {
        Receiving message = takenLast.containsKey(number) ? takenLast.get(number) : queued(told, number);
        require(message.isHanded(), told.board() + " hands over message " + number, "HANDED first");
        message.isOfKind(kind);
    }

    private Receiving queued(Point point, int number) throws RefusedException {
        Receiving message = receiving.get(number);
        require(message != null, point.board() + " hands over message " + number, "QUEUED before");
        return message;
    }

    private void hand(Point point) throws RefusedException {
        Receiving message = queued(point, point.operand("message"));
        message.hand(point,
                receiving.values().stream().takeWhile(each -> each != message).allMatch(Receiving::isHanded));
    }

    /** The host takes all up to a message, if that is still here. */
    void takes(Point told, int number) throws RefusedException {
        for (Receiving each : until(number)) {
            each.see(told);
        }
    }

    private List<Receiving> until(int number) {
        List<Receiving> all = new ArrayList<>(receiving.values());
        return all.subList(0, all.indexOf(receiving.get(number)) + 1);
    }

    private void take(Point point) throws RefusedException {
        List<Receiving> all = until(point.operand("message"));
        point.require(!all.isEmpty(), "one that is in its inbox");
        takenLast.clear();
        for (Receiving each : all) {
            each.see(point);
            receiving.remove(each.number);
            takenLast.put(each.number, each);
            if (each.isAcknowledged() && !goneKeys.contains(each.key)) {
                unacknowledged.add(each);
                taken.put(each.key, each);
            }
        }
    }

    private void owe(Point point) throws RefusedException {
        if (!unacknowledged.isEmpty()) {
            unacknowledged.remove().acknowledge(point);
        } else if (point.is("OWE_DELIVERED")) {
            last(point).see(point);
        } else {
            Receiving.unknown(models, point);
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
        accepted.clear();
        receiving.clear();
        unacknowledged.clear();
        takenLast.clear();
        answers.reset();
        nextMessage = 0;
        idleSince = Double.POSITIVE_INFINITY;
        air.reset();
    }
}
