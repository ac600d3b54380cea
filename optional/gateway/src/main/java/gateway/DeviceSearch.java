package gateway;

import java.util.List;
import java.util.Map;
import javino.protocol.Address;
import javino.protocol.Bytes;

/** Questions which cell has heard a device, and the frames that wait for an answer. */
final class DeviceSearch {

    /** A question for 20 devices at once, and then one a second. */
    static final long QUESTION_MILLIS = 1000;
    static final long AT_ONCE_MILLIS = 20 * QUESTION_MILLIS;
    /** Before a question is asked again: doubled each time while nobody answers. */
    private static final long FIRST_PAUSE_MILLIS = 500;
    private static final long LONGEST_PAUSE_MILLIS = 64_000;
    private static final int MOST_QUESTIONS = 256;
    private static final int MOST_WAITING = 64;

    private final BoundedMap<Address, Question> questions = new BoundedMap<>(MOST_QUESTIONS);
    private final BoundedMap<Bytes, Waiting> waiting = new BoundedMap<>(MOST_WAITING);
    private final AirtimeBudget budget;

    /** @param pause before the same may be asked again. */
    private record Question(long asked, long pause) {
    }

    /** A packet of that attempt for a device, which is of use until then. */
    record Waiting(Address device, Bytes packet, int attempt, long until) {
    }

    DeviceSearch(long now) {
        budget = new AirtimeBudget(AT_ONCE_MILLIS, 100, now);
    }

    /** A packet waits for an answer. Tells whether the question is to be asked now. */
    boolean ask(Address device, Bytes packet, int attempt, long now) {
        waiting.renew(packet, new Waiting(device, packet, attempt, now + Router.LIFE_MILLIS));
        Question before = questions.get(device);
        if (before != null && now - before.asked < before.pause || !budget.take(QUESTION_MILLIS, now)) {
            return false;
        }
        questions.renew(device, new Question(now,
                before == null ? FIRST_PAUSE_MILLIS : Math.min(2 * before.pause, LONGEST_PAUSE_MILLIS)));
        return true;
    }

    /** The question has reached nobody. */
    void unasked(Address device) {
        questions.remove(device);
    }

    /** Whether an answer about a device is awaited. Nobody may tell unasked, or he could fill the memory. */
    boolean awaits(Address device, long now) {
        Question question = questions.get(device);
        return question != null && now - question.asked < Router.LIFE_MILLIS;
    }

    /** The device is known. Tells of the packets that wait for it, in their order. */
    List<Waiting> found(Address device, long now) {
        questions.computeIfPresent(device, (any, question) -> new Question(question.asked, FIRST_PAUSE_MILLIS));
        return waiting.entrySet().stream().map(Map.Entry::getValue)
                .filter(packet -> packet.device.equals(device) && now < packet.until).toList();
    }
}
