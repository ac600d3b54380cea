package mobility;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** What becomes of an agent that moves in, and of the MAS that takes it in: the words of Hermes (SPEC 9.1). */
public enum Protocol {
    /** The newcomer lives as any agent of the MAS. */
    MUTUALISM,
    /** The newcomer lives there as a {@link GuestAgent}, without the board. */
    INQUILINISM,
    /** As mutualism, but the original stays where it is. */
    CLONING,
    /** The newcomer takes the MAS over: its other agents end. */
    PREDATION;

    /** The protocol of an atom's name, such as {@code cloning}. */
    public static Optional<Protocol> of(String atom) {
        return Arrays.stream(values()).filter(protocol -> protocol.atom().equals(atom)).findFirst();
    }

    /** The protocol of a letter in an offer. */
    static Optional<Protocol> of(int letter) {
        return Arrays.stream(values()).filter(protocol -> protocol.letter() == letter).findFirst();
    }

    /** What an agent calls it. */
    String atom() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** What an offer calls it. */
    int letter() {
        return atom().charAt(0);
    }
}
