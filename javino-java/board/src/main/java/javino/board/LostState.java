package javino.board;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javino.protocol.Reply.StoredKey;
import javino.protocol.Status;

/** Texts about what a board may have lost of the state on which security rests (SPEC 5.1). */
public final class LostState {

    private static final String LOST = "the board has lost its boot epoch: something has written over its EEPROM; ";

    private LostState() {
    }

    /** The text that a board's epoch was lost and raised. */
    static String raised(int epoch) {
        return LOST + "it was raised to " + epoch + ", above all that it has had";
    }

    /** The text that a board had a higher epoch than it tells. */
    static String ofOlderImage(int epoch) {
        return "the board tells an earlier boot epoch than it has had: its EEPROM was erased, or is an older copy; the "
                + "epoch is " + epoch + " now, but messages that it has had since that copy could be replayed under "
                + "its keys: make new ones (javino keygen --renew)";
    }

    /** The text that no epoch is left. */
    public static String ofUsedUp() {
        return "the board's nonces are used up, and it seals nothing: clear its EEPROM (the Arduino IDE's example "
                + "eeprom_clear), flash its sketch again, and give it new keys";
    }

    /** The text that a board did not take the epoch that it needs. */
    static String ofRefused(int epoch, Status why) {
        return "the board's epoch could not be raised to " + epoch + " (" + why + "), and it seals nothing: reset it";
    }

    /** The text that a board's epoch was lost, and what to do. */
    public static String notRaised() {
        return LOST + "it seals nothing until javino provision has raised it by its keyring";
    }

    /** The text that floors of keys may be lost, if there are any such. */
    public static Optional<String> ofFloors(List<StoredKey> keys) {
        String doubtful = keys.stream().filter(StoredKey::doubtful).map(key -> key.address().toString()).distinct()
                .collect(Collectors.joining(", "));
        return doubtful.isEmpty() ? Optional.empty()
                : Optional.of("the board may have lost which messages it had under its keys for " + doubtful
                        + ", and refuses those of senders that it does not remember; make new keys for them: "
                        + "javino keygen --renew");
    }

    /** The text that the memory of nonces did not hold. */
    public static String ofMemory() {
        return "the sketch's stack, or a wild pointer, has written over the board's memory of nonces: sealed messages "
                + "are neither sent nor taken until it is reset; make the sketch's variables smaller";
    }
}
