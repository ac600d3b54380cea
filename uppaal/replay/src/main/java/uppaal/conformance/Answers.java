package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/** The answers that a board owes, one to each sender, of which the first waits for the air. */
final class Answers {
    private static final Map<String, Integer> OWED =
            Map.of("OWE_DELIVERED", 2, "OWE_FRAGMENTS", 3, "OWE_STALE", 4);
    private static final int LEAST_PUT_OFF_SLOTS = 2;
    private static final int MOST_PUT_OFF_SLOTS = 5;

    private final DeclaredAir air;
    private final DeliveryModels models;
    private final List<Answer> owed = new ArrayList<>();
    private Timer slots = Timer.NONE;
    /** When the first became the first, and whether it was put off. */
    private double begun;
    private boolean isPutOff;
    /** The quiet slots that the first waits for; the same ones if it is sent twice. */
    private int quiet;
    /** Two with a floor under a group's key may be for one sender or for two: their order is not known. */
    private boolean isVague;

    private static final class Answer {
        private final Point point;
        private final Instance instance;
        private boolean twice;

        Answer(Point point, Instance instance) {
            this.point = point;
            this.instance = instance;
        }

        int key() {
            return point.operand("key");
        }
    }

    Answers(DeclaredAir air, DeliveryModels models) {
        this.air = air;
        this.models = models;
    }

    /** One is owed, in the place of another one to the same sender. */
    void owe(Point point) throws RefusedException {
        boolean isStale = point.is("OWE_STALE") && owed.stream().anyMatch(answer -> answer.key() == point.operand("key")
                && answer.point.is("OWE_STALE"));
        isVague |= isStale;
        remove(point, answer -> !isStale && answer.key() == point.operand("key"));
        add(point, point, owed.size());
        begin(point, owed.size() == 1);
    }

    private void add(Point now, Point owes, int index) throws RefusedException {
        Instance instance = models.answer(owes.name() + ", nonce " + owes.operand("nonce"));
        instance.set("owed[1]", OWED.get(owes.name()));
        instance.take(now, owes.name(), DeliveryModels.outside(Map.of("busy", DeliveryModels.flag(air.isBusy()))));
        owed.add(index, new Answer(owes, instance));
    }

    /** The last one, which is returned, is to be sent twice. */
    Point twice(Point point) throws RefusedException {
        Answer last = owed.isEmpty() ? null : owed.get(owed.size() - 1);
        point.require(last != null && last.point.is("OWE_DELIVERED"), "OWE_DELIVERED before");
        last.twice = true;
        return last.point;
    }

    /** There was no room for another one. */
    void dropFirst(Point point) {
        Answer first = owed.isEmpty() ? null : owed.get(0);
        remove(point, answer -> answer == first);
    }

    /** Those with a key that is gone are not sent. */
    void forget(Point point) {
        remove(point, answer -> answer.key() == point.operand("key"));
    }

    void reset() {
        owed.clear();
        isVague = false;
        slots = Timer.NONE;
    }

    private void remove(Point point, Predicate<Answer> which) {
        Answer first = owed.isEmpty() ? null : owed.get(0);
        owed.removeIf(which);
        begin(point, first != null && !owed.contains(first));
    }

    /** Another one is the first. */
    private void begin(Point point, boolean isAnother) {
        if (isAnother) {
            quiet = 1;
            slots = owed.isEmpty() ? Timer.NONE : wait(point);
            begun = point.seconds();
            isPutOff = false;
        }
    }

    private Timer wait(Point point) {
        return isVague ? Timer.NONE : air.slots(point, quiet, 0, "ANSWER with key " + owed.get(0).key());
    }

    void putOff(Point point) throws RefusedException {
        int drawn = point.operand("slots");
        if (isVague) {
            return;
        }
        point.require(!owed.isEmpty() && !isPutOff && air.isBusy(),
                "that it owes an answer, has not put it off yet, and hears a carrier");
        point.require(drawn >= LEAST_PUT_OFF_SLOTS && drawn <= MOST_PUT_OFF_SLOTS, LEAST_PUT_OFF_SLOTS + " to " +
                MOST_PUT_OFF_SLOTS + " slots");
        isPutOff = true;
        quiet = drawn;
        slots = wait(point);
        Instance first = owed.get(0).instance;
        if (!first.isAt("Pending")) {
            first.take(point, point.name(), Map.of());
        }
    }

    /** The first is sent. */
    void send(Point point) throws RefusedException {
        Answer first = owed.stream().filter(answer -> !isVague || answer.key() == point.operand("key")).findFirst()
                .orElse(null);
        point.require(first != null && first.key() == point.operand("key"),
                first == null ? "that it owes one" : "first " + first.point.name() + " with key " + first.key());
        slots.checkNotEarly(point);
        first.instance.take(point, point.name(), DeliveryModels.outside(Map.of()));
        if (first.twice) {
            int place = owed.indexOf(first);
            owed.remove(place);
            add(point, first.point, place);
            slots = wait(point);
        } else {
            remove(point, answer -> answer == first);
        }
    }

    void checkTimers(Point point) throws RefusedException {
        if (isVague) {
            slots = Timer.NONE;
            if (air.slotsAtLeast(point.run() - point.gap()) > MOST_PUT_OFF_SLOTS * owed.size()) {
                reset();
            }
        }
        slots.checkNotLate(point);
    }

    /** The air becomes busy; called before it is. */
    void busy(Point point) {
        slots.busy(point);
    }

    /** The air has become busy or quiet, which it was not. */
    void air(Point point) throws RefusedException {
        require(!air.isTimed() || isVague || !point.is("QUIET") || owed.isEmpty() || isPutOff ||
                begun >= point.run() - point.gap(), point.board() + " has not put off the answer that it owes",
                "PUT_OFF while the air was busy");
        String heard = air.isBusy() ? "BUSY" : "QUIET";
        for (Answer answer : owed) {
            if (answer.instance.can(heard)) {
                answer.instance.take(point, heard, Map.of());
            }
        }
    }
}
