package diffuser.gate;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Structure;

import javino.protocol.Address;

/** The receivers of a message, and so the devices that can have forged it. */
public enum Cast {
    /** To all in range, sealed by no key. */
    BROADCAST,
    /** To a group, sealed by the key that all members have. */
    MULTICAST,
    /** To one device, sealed by the key that two have. */
    UNICAST,
    /** Within the MAS. */
    LOCAL;

    /** The cast of what was sent to an address. */
    public static Cast of(Address to) {
        return switch (to.kind()) {
            case DEVICE -> UNICAST;
            case MULTICAST -> MULTICAST;
            default -> BROADCAST;
        };
    }

    /** The annotation of what came so, such as {@code cast(unicast,ROMA)}. */
    Structure mark(String from) {
        return ASSyntax.createStructure("cast", ASSyntax.createAtom(Policy.word(this)), ASSyntax.createAtom(from));
    }
}
