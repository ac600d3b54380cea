package javino.board;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import javino.Counts;
import javino.legacy.LegacyDecoder;
import javino.legacy.LegacyMessage;
import javino.link.Link;
import javino.link.LinkException;

/** Asks and tells a board in the older protocol, over an open link at its speed (SPEC 8.2). */
final class LegacyExchange {

    /**
     * From an action to the next message. The older library keeps one message only, so one that comes before the
     * sketch's loop has come round takes the place of the action; there are sketches with a delay of 50 ms in each
     * round.
     */
    private static final Duration ROUND = Duration.ofMillis(100);
    /** The longest that a read waits, so that the session's end is noticed; a serial port makes 100 ms of it. */
    private static final Duration STEP = Duration.ofMillis(50);

    private final Link link;
    private final SessionContext context;
    private final Counts<SessionCounter> counters;
    private final LegacyDecoder decoder = new LegacyDecoder();
    private final byte[] buffer = new byte[1024];
    private Deadline mayWrite;
    private int answerLength;
    private long skippedBefore;
    /** Whether an answer is missing that may still come, and must not be taken for the next one. */
    private boolean awaitsLateOne;

    LegacyExchange(Link link, SessionContext context) {
        this.link = link;
        this.context = context;
        counters = context.counters();
        mayWrite = context.in(Duration.ZERO);
    }

    /**
     * Asks what the board perceives.
     *
     * @param timeout how long the answer may take to begin and end.
     * @param goOn    whether to wait still.
     * @return nothing if there was no answer.
     * @throws LinkException if the link broke.
     */
    Optional<LegacyMessage> askPercepts(Duration timeout, BooleanSupplier goOn) throws LinkException {
        byte[] request = LegacyMessage.GET_PERCEPTS.encode().toArray();
        counters.count(SessionCounter.REQUESTS);
        sleepUntil(mayWrite);
        link.write(request);
        // As bytes come one a millisecond, being woken for each few would be most of what an idle agent costs.
        sleepUntil(context.in(link.timeFor(request.length + answerLength)));
        Optional<LegacyMessage> answer = awaitAnswer(context.in(timeout), goOn);
        countDamage();
        return answer;
    }

    private Optional<LegacyMessage> awaitAnswer(Deadline deadline, BooleanSupplier goOn) throws LinkException {
        while (!deadline.passed() && goOn.getAsBoolean()) {
            List<LegacyMessage> answers = read(deadline);
            if (!answers.isEmpty()) {
                return Optional.of(last(answers));
            }
        }
        decoder.abandon();
        answerLength = 0;
        awaitsLateOne = true;
        return Optional.empty();
    }

    /** The answer to this request: the last, if several have come. */
    private LegacyMessage last(List<LegacyMessage> first) throws LinkException {
        List<LegacyMessage> answers = new ArrayList<>(first);
        if (awaitsLateOne) {
            answers.addAll(read(context.in(STEP)));
            awaitsLateOne = false;
        }
        answers.stream().skip(1).forEach(late -> counters.count(SessionCounter.STALE_REPLIES));
        LegacyMessage answer = answers.get(answers.size() - 1);
        answerLength = answer.encode().length();
        return answer;
    }

    /** Drops what comes unasked, and notices where the link is broken. */
    void listen() throws LinkException {
        read(context.in(Duration.ofMillis(1))).forEach(unasked -> counters.count(SessionCounter.STALE_REPLIES));
        countDamage();
    }

    /** Sends an action, and returns when it has left; nobody answers it. */
    void act(LegacyMessage action) throws LinkException {
        byte[] bytes = action.encode().toArray();
        counters.count(SessionCounter.REQUESTS);
        sleepUntil(mayWrite);
        link.write(bytes);
        sleepUntil(context.in(link.timeFor(bytes.length)));
        mayWrite = context.in(ROUND);
    }

    /** How many bytes came that belong to no message. */
    long skipped() {
        return decoder.skipped();
    }

    private void countDamage() {
        if (decoder.skipped() > skippedBefore) {
            counters.count(SessionCounter.DAMAGED_PACKETS);
        }
        skippedBefore = decoder.skipped();
    }

    private List<LegacyMessage> read(Deadline deadline) throws LinkException {
        // A listener or a future's dependant may have interrupted this thread; that is no reason to drop the link.
        Thread.interrupted();
        long nanos = Math.max(1, Math.min(deadline.nanosLeft(), STEP.toNanos()));
        return decoder.feed(buffer, link.read(buffer, Duration.ofNanos(nanos)));
    }

    private void sleepUntil(Deadline deadline) {
        while (!deadline.passed()) {
            Thread.interrupted();
            context.time().pause(deadline.nanosLeft());
        }
    }
}
