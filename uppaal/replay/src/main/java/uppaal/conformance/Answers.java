package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The answers that a board owes, one to each sender, of which the first waits for the air. */
final class Answers {
    private static final Map<String, Integer> OWED =
            Map.of("OWE_DELIVERED", 2, "OWE_FRAGMENTS", 3, "OWE_STALE", 4);
    private static final int FRESH_SLOTS = 1;
    private static final int LEAST_PUT_OFF_SLOTS = 2;
    private static final int MOST_PUT_OFF_SLOTS = 5;

    private final BoardAir air;
    private final DeliveryModels models;
    private final List<Answer> owed = new ArrayList<>();
    /** The one that waits, since when, and for how many quiet slots: more than a fresh one's if it is put off. */
    private Answer first;
    private double begun;
    private int quiet;
    private Timer timer = Timer.NONE;
    /** Two with a floor under a group's key may be for one sender or for two: their order is not known. */
    private boolean isVague;

    private final class Answer {
        final Point point;
        final int key;
        Instance instance;
        boolean isTwice;

        Answer(Point point) throws RefusedException {
            this.point = point;
            key = point.operand("key");
            owe(point);
        }

        void owe(Point now) throws RefusedException {
            instance = models.answer(point.name() + ", nonce " + point.operand("nonce"));
            instance.set("owed[1]", OWED.get(point.name()));
            instance.take(now, point.name(),
                    DeliveryModels.outside(Map.of("busy", DeliveryModels.flag(air.isBusy()))));
        }
    }

    Answers(BoardAir air, DeliveryModels models) {
        this.air = air;
        this.models = models;
    }

    /** One is owed, in the place of another one to the same sender. */
    void owe(Point point) throws RefusedException {
        Answer answer = new Answer(point);
        boolean isStale = point.is("OWE_STALE")
                && owed.stream().anyMatch(other -> other.key == answer.key && other.point.is("OWE_STALE"));
        isVague |= isStale;
        owed.removeIf(other -> !isStale && other.key == answer.key);
        owed.add(answer);
        begin(point);
    }

    /** The last one, which is returned, is to be sent twice. */
    Point twice(Point point) throws RefusedException {
        Answer last = owed.isEmpty() ? null : owed.get(owed.size() - 1);
        point.require(last != null && last.point.is("OWE_DELIVERED"), "OWE_DELIVERED before");
        last.isTwice = true;
        return last.point;
    }

    /** There was no room for another one. */
    void dropFirst(Point point) {
        owed.remove(first);
        begin(point);
    }

    /** Those with a key that is gone are not sent. */
    void forget(Point point) {
        owed.removeIf(answer -> answer.key == point.operand("key"));
        begin(point);
    }

    void reset() {
        owed.clear();
        isVague = false;
        first = null;
        timer = Timer.NONE;
    }

    /** Another one may be the first. */
    private void begin(Point point) {
        Answer before = first;
        first = owed.isEmpty() ? null : owed.get(0);
        if (first != before) {
            begun = point.seconds();
            await(point, FRESH_SLOTS);
        }
    }

    private void await(Point point, int slots) {
        quiet = slots;
        timer = first == null || isVague ? Timer.NONE : air.slots(point, slots, 0, "ANSWER with key " + first.key);
    }

    void putOff(Point point) throws RefusedException {
        int drawn = point.operand("slots");
        if (isVague) {
            return;
        }
        point.require(first != null && quiet == FRESH_SLOTS && air.isBusy(),
                "that it owes an answer, has not put it off yet, and hears a carrier");
        point.require(drawn >= LEAST_PUT_OFF_SLOTS && drawn <= MOST_PUT_OFF_SLOTS, LEAST_PUT_OFF_SLOTS + " to " +
                MOST_PUT_OFF_SLOTS + " slots");
        await(point, drawn);
        if (!first.instance.isAt("Pending")) {
            first.instance.take(point, point.name(), Map.of());
        }
    }

    /** The first is sent. */
    void send(Point point) throws RefusedException {
        Answer sent = !isVague ? first
                : owed.stream().filter(answer -> answer.key == point.operand("key")).findFirst().orElse(null);
        point.require(sent != null && sent.key == point.operand("key"),
                sent == null ? "that it owes one" : "first " + sent.point.name() + " with key " + sent.key);
        timer.checkNotEarly(point);
        sent.instance.take(point, point.name(), DeliveryModels.outside(Map.of()));
        if (sent.isTwice) {
            sent.isTwice = false;
            sent.owe(point);
            await(point, quiet);
        } else {
            owed.remove(sent);
            begin(point);
        }
    }

    void checkTimers(Point point) throws RefusedException {
        if (isVague) {
            timer = Timer.NONE;
            if (!air.isBusy() && air.slots(air.quiet().from(), point.runBefore())
                    .least() > MOST_PUT_OFF_SLOTS * owed.size()) {
                reset();
            }
        }
        timer.checkNotLate(point);
    }

    /** The air has become busy or quiet, which it was not. */
    void air(Point point) throws RefusedException {
        if (air.isBusy()) {
            timer.busy(point);
        }
        require(!air.isTimed() || isVague || air.isBusy() || first == null || quiet != FRESH_SLOTS
                || begun >= point.runBefore(), point.board() + " has not put off the answer that it owes",
                "PUT_OFF while the air was busy");
        for (Answer answer : owed) {
            answer.instance.hear(point, air.isBusy());
        }
    }
}
