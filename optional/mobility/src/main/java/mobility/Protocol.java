package mobility;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The effects of a move on the agent, and on the MAS that takes it in: the words of Hermes (SPEC 9.1). */
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

    /** Its name for an agent. */
    String atom() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Its name in an offer. */
    int letter() {
        return atom().charAt(0);
    }
}
