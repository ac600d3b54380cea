package javino.protocol;

import java.util.Optional;

/** The counters of a board since its boot (SPEC 4.5). */
public enum Counter {
    /** Requests that came undamaged. */
    SERIAL_REQUESTS("serialRequests"),
    /** Packets refused: COBS, length or CRC. */
    SERIAL_DAMAGED("serialDamaged"),
    /** Packets refused: frame. */
    SERIAL_BAD_FRAMES("serialBadFrames"),
    /** Repeats of requests. */
    SERIAL_REPEATS("serialRepeats"),
    /** Radio packets with a right CRC. */
    RADIO_RECEIVED("radioReceived"),
    /** Radio packets with a wrong symbol, count or CRC. */
    RADIO_DAMAGED("radioDamaged"),
    /**
     * Radio packets that came while no buffer was free, or were broken off because the board began to send or to block.
     */
    RADIO_MISSED("radioMissed"),
    /** Right packets that have no frame, or a frame whose origin is no device. */
    RADIO_BAD_FRAMES("radioBadFrames"),
    /** Frames to reserved addresses. */
    RADIO_RESERVED("radioReserved"),
    /** Frames to other devices or groups. */
    RADIO_NOT_FOR_US("radioNotForUs"),
    /** Frames whose origin is the board's own RF id. */
    RADIO_OWN("radioOwn"),
    /** Sealed frames for us without a key for them. */
    RADIO_NO_KEY("radioNoKey"),
    /** Sealed frames too short or with a wrong tag. */
    RADIO_BAD_TAG("radioBadTag"),
    /** Sealed frames whose nonce is not newer than the last. */
    RADIO_REPLAYED("radioReplayed"),
    /** Sealed frames refused because their origin's nonce could not be remembered. */
    RADIO_REPLAY_FULL("radioReplayFull"),
    /** Good messages dropped because the receive queue was full. */
    RADIO_QUEUE_FULL("radioQueueFull"),
    /** Packets sent. */
    RADIO_SENT("radioSent"),
    /** Percepts that did not fit a reply. */
    PERCEPTS_LEFT_OUT("perceptsLeftOut"),
    /** Messages that came again and are not delivered twice. */
    RADIO_REPEATS("radioRepeats"),
    /** Fragments of an impossible shape, or for which no memory was free. */
    RADIO_FRAGMENTS_DROPPED("radioFragmentsDropped"),
    /** Half-received messages that were forgotten. */
    RADIO_EXPIRED("radioExpired"),
    /** Unicasts reported delivered. */
    RADIO_ACKNOWLEDGED("radioAcknowledged"),
    /** Unicasts reported undelivered. */
    RADIO_UNDELIVERED("radioUndelivered"),
    /** Acknowledgements for the message under way with a wrong proof or shape. */
    RADIO_BAD_PROOFS("radioBadProofs"),
    /** Packets sent again. */
    RADIO_RESENT("radioResent"),
    /** Packets delayed because a carrier was heard. */
    RADIO_DEFERRED("radioDeferred"),
    /** Sealed frames refused because they are not above the floor that a reboot left (SPEC 5.1). */
    RADIO_STALE("radioStale"),
    /** Packets of which one symbol was corrected. */
    RADIO_MENDED("radioMended"),
    /** Frames other than acknowledgements that came while the radio was blocked. */
    RADIO_BLOCKED("radioBlocked"),
    /** Acknowledgements that were not sent because too many waited; their senders ask again. */
    RADIO_ANSWERS_DROPPED("radioAnswersDropped"),

    /** Broadcasts, plain or in fragments, that were dropped since what mended them left a doubt. */
    RADIO_DOUBTFUL("radioDoubtful"),

    /** Acknowledgements that were taken though some bits of their proof were wrong. */
    RADIO_ANSWERS_TOLERATED("radioAnswersTolerated"),

    /** Packets that were overheard and did not fit the memory for them. */
    RADIO_OVERHEARD_DROPPED("radioOverheardDropped"),
    /** Copies of unicasts that the board has sent as a relay. */
    RELAY_COPIES("relayCopies"),
    /** Copies of acknowledgements that it has sent as a relay. */
    RELAY_ANSWERS("relayAnswers"),
    /** Unicasts that it did not copy, since its memory was full or too many went unanswered. */
    RELAY_REFUSED("relayRefused"),
    /** Sealed frames and hellos that came while the memory of nonces did not hold, and boots after it did not. */
    MEMORY_DAMAGED("memoryDamaged"),
    /** The longest time between two calls of the library by the sketch, in ms. */
    LOOP_MILLIS("loopMillis"),
    /** The longest time in the sketch's function of percepts, in ms. */
    PERCEPTS_MILLIS("perceptsMillis"),
    /** The longest time in a function of an action, in ms. */
    ACTION_MILLIS("actionMillis"),
    /** How late the radio's interrupt began at most, in microseconds. */
    RADIO_LATE_MICROS("radioLateMicros");

    private static final Counter[] VALUES = values();

    private final String specName;

    Counter(String specName) {
        this.specName = specName;
    }

    /** The counter of a number on the line, if there is one. */
    public static Optional<Counter> of(int number) {
        return number >= 1 && number <= VALUES.length ? Optional.of(VALUES[number - 1]) : Optional.empty();
    }

    /** The number on the line, from 1. */
    public int number() {
        return ordinal() + 1;
    }

    /** Whether it counts nothing, but is the longest of the times since the boot. */
    public boolean isTime() {
        return compareTo(LOOP_MILLIS) >= 0;
    }

    /** The name as in SPEC 4.5, such as {@code serialRequests}. */
    @Override
    public String toString() {
        return specName;
    }
}
