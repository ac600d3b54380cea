package javino.protocol;

import java.util.Optional;

/** How a board answers a request (SPEC 4.4). The ordinal is the value on the line. */
public enum Status {
    /** Done. */
    OK("done"),
    /** The board has (re)started. */
    NOT_GREETED("the board has restarted and was not greeted yet"),
    /** No such command in this version. */
    UNKNOWN_COMMAND("the board's firmware does not know this command; flash a current one"),
    /** The body is not what the command takes. */
    BAD_ARGUMENT("the board does not take this argument"),
    /** The sketch has no action of this name. */
    UNKNOWN_ACTION("the sketch has no action of this name"),
    /** The sketch refused the action or its arguments. */
    ACTION_FAILED("the sketch refused the action or its arguments"),
    /** The board has no RF id yet. */
    NO_RF_ID("the board has no RF id yet; give it one by .setMyRFId or javino provision"),
    /** The frame's origin is not the board's RF id. */
    WRONG_ORIGIN("the origin is not the board's RF id"),
    /** Nothing can be sent to this address. */
    BAD_DESTINATION("nothing can be sent to this address: it is reserved or the board's own"),
    /** No key is stored for this address. */
    NO_KEY("the board has no key for this address; give it one with javino provision"),
    /** The content does not fit. */
    TOO_LONG("the content is too long: it has at most 494 bytes of UTF-8, on an Uno 67"),
    /** The transmit queue is full. */
    QUEUE_FULL("the board's transmit queue is full; try again later"),
    /** The key store is full. */
    STORE_FULL("the board's key store is full; delete a key first"),
    /** The EEPROM did not keep what was written. */
    STORE_FAILED("the board's EEPROM did not keep what was written"),
    /** No nonce is left. */
    NONCE_EXHAUSTED(
            "the board has used all its nonces; reset it; if that does not help, clear its EEPROM, for new keys"),
    /** Messages are under way that the change would harm. */
    BUSY("messages are under way; try again when they have ended"),
    /** A key is stored for this address: it gets no session key. */
    HAS_KEY("the board has a stored key for this address, and sets no session key beside it"),
    /** Keys are stored, but no epoch. */
    EPOCH_LOST("the board has lost its boot epoch, and seals nothing until javino provision has raised it"),
    /** The memory of nonces does not hold. */
    MEMORY_DAMAGED(
            "the sketch's stack, or a wild pointer, has written over the board's memory of nonces, and the board "
                    + "seals and opens nothing until it is reset; make the sketch's variables smaller"),
    /** The board has no radio. */
    NO_RADIO("the board has no radio; for one, its sketch makes a JavinoRadioBoard"),
    /** The board has sealed unicasts only. */
    UNICASTS_ONLY(
            "the board has neither groups, broadcasts, relaying of frames nor renewal of keys; for these, its sketch "
                    + "makes a JavinoRadioBoard in place of a JavinoUnicastBoard");

    private static final Status[] VALUES = values();

    private final String explanation;

    Status(String explanation) {
        this.explanation = explanation;
    }

    /** The status of a value on the line, if there is one. */
    public static Optional<Status> of(int value) {
        return value >= 0 && value < VALUES.length ? Optional.of(VALUES[value]) : Optional.empty();
    }

    /** What it means and, where something can be done, what; for people. */
    public String explanation() {
        return explanation;
    }
}
