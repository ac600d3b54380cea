package javino.board;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import javino.keyring.BoardNotes;
import javino.keyring.BoundedClock;
import javino.link.Time;
import javino.protocol.Request;

/**
 * The settings of a session. All times are positive.
 *
 * @param hold           how long the board may hold its reply to a poll while it has nothing to tell, at most
 *                       65 535 ms; 2 s by default.
 * @param replyTimeout   how long a reply may take before its request is repeated; 200 ms by default, and 400 ms more if
 *                       the board writes to its EEPROM (SPEC 4.2).
 * @param attempts       for how many times {@code replyTimeout} an overdue request is repeated before the board counts
 *                       as lost, at least 1; 15 by default, which is 3 s: a busy machine may take a second over a
 *                       reply.
 * @param actionTime     how long a board may take to reply to a request that it has taken, and to take one: the
 *                       sketch's function of an action or of percepts may take its time; 10 s by default (SPEC 4.2). A
 *                       board that hangs in one is lost after this time and that of all attempts.
 * @param helloInterval  from one hello to the next until the board answers; 100 ms by default.
 * @param reopenInterval from one attempt to open the link to the next; 200 ms by default. After a board was silent the
 *                       link is opened anew after twice as long each time, up to a minute.
 * @param patience       how long a request may wait for the board to come online, and how long an open link may be
 *                       silent before the listener is told; 5 s by default, as a Mega takes 2 s to boot.
 * @param queueCapacity  how many requests may wait, at least 1; 512 by default.
 * @param notes          notes about boards, by which no nonce and no lost key comes again; none by default.
 * @param clock          by which epochs are raised; that of the time by default.
 * @param time           of the session, with its random numbers and threads; the computer's by default.
 */
public record BoardConfig(Duration hold, Duration replyTimeout, int attempts, Duration actionTime,
        Duration helloInterval, Duration reopenInterval, Duration patience, int queueCapacity, List<BoardNotes> notes,
        BoundedClock clock, Time time) {

    private static final Duration MAX_HOLD = Duration.ofMillis(Request.MAX_HOLD_MILLIS);

    /** @throws IllegalArgumentException if a value is out of its range. */
    public BoardConfig {
        checkPositive("hold", hold);
        if (hold.compareTo(MAX_HOLD) > 0) {
            throw new IllegalArgumentException("hold must be at most " + MAX_HOLD.toMillis() + " ms, not " + hold);
        }
        checkPositive("replyTimeout", replyTimeout);
        checkPositive("actionTime", actionTime);
        checkPositive("helloInterval", helloInterval);
        checkPositive("reopenInterval", reopenInterval);
        checkPositive("patience", patience);
        checkPositive("attempts", attempts);
        checkPositive("queueCapacity", queueCapacity);
    }

    private static void checkPositive(String name, Duration value) {
        if (value.isNegative() || value.isZero()) {
            throw new IllegalArgumentException(name + " must be positive, not " + value);
        }
    }

    private static void checkPositive(String name, int value) {
        if (value < 1) {
            throw new IllegalArgumentException(name + " must be at least 1, not " + value);
        }
    }

    /** All defaults. */
    public static BoardConfig create() {
        return create(builder -> {});
    }

    /** The defaults, except for values that the consumer sets. */
    public static BoardConfig create(Consumer<Builder> configure) {
        Builder builder = new Builder();
        configure.accept(builder);
        return builder.build();
    }

    /** The same, but for its notes and its clock. */
    public BoardConfig with(List<BoardNotes> known, BoundedClock right) {
        return new BoardConfig(hold, replyTimeout, attempts, actionTime, helloInterval, reopenInterval, patience,
                queueCapacity, known, right, time);
    }

    /** The same in another time; so is its clock, unless it was set to another than that of the time. */
    public BoardConfig in(Time other) {
        BoundedClock told = clock.source() == time ? new BoundedClock(other, clock.isRight()) : clock;
        return new BoardConfig(hold, replyTimeout, attempts, actionTime, helloInterval, reopenInterval, patience,
                queueCapacity, notes, told, other);
    }

    /** Collects settings; see {@link BoardConfig} for their meanings. */
    public static final class Builder {

        private Duration hold = Duration.ofSeconds(2);
        private Duration replyTimeout = Duration.ofMillis(200);
        private int attempts = 15;
        private Duration actionTime = Duration.ofSeconds(10);
        private Duration helloInterval = Duration.ofMillis(100);
        private Duration reopenInterval = Duration.ofMillis(200);
        private Duration patience = Duration.ofSeconds(5);
        private int queueCapacity = 512;
        private List<BoardNotes> notes = List.of();
        private BoundedClock clock = BoundedClock.SYSTEM;

        private Builder() {
        }

        /** Sets {@link BoardConfig#hold()}. */
        public Builder setHold(Duration longest) {
            hold = longest;
            return this;
        }

        /** Sets {@link BoardConfig#replyTimeout()}. */
        public Builder setReplyTimeout(Duration timeout) {
            replyTimeout = timeout;
            return this;
        }

        /** Sets {@link BoardConfig#attempts()}. */
        public Builder setAttempts(int count) {
            attempts = count;
            return this;
        }

        /** Sets {@link BoardConfig#actionTime()}. */
        public Builder setActionTime(Duration longest) {
            actionTime = longest;
            return this;
        }

        /** Sets {@link BoardConfig#helloInterval()}. */
        public Builder setHelloInterval(Duration interval) {
            helloInterval = interval;
            return this;
        }

        /** Sets {@link BoardConfig#reopenInterval()}. */
        public Builder setReopenInterval(Duration interval) {
            reopenInterval = interval;
            return this;
        }

        /** Sets {@link BoardConfig#patience()}. */
        public Builder setPatience(Duration longest) {
            patience = longest;
            return this;
        }

        /** Sets {@link BoardConfig#queueCapacity()}. */
        public Builder setQueueCapacity(int capacity) {
            queueCapacity = capacity;
            return this;
        }

        /** Sets {@link BoardConfig#notes()}. */
        public Builder setNotes(List<BoardNotes> known) {
            notes = List.copyOf(known);
            return this;
        }

        /** Sets {@link BoardConfig#clock()}. */
        public Builder setClock(BoundedClock right) {
            clock = right;
            return this;
        }

        private BoardConfig build() {
            return new BoardConfig(hold, replyTimeout, attempts, actionTime, helloInterval, reopenInterval,
                    patience, queueCapacity, notes, clock, Time.REAL);
        }
    }
}
