package diffuser.gate;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Structure;

import javino.protocol.Address;

/** The trust in another device, by the key that it shares with this one. */
public enum TrustLevel {
    /** Somebody has put the key on both boards. */
    PROVISIONED,
    /** The hosts have agreed on the key, as both have a certificate: they may never have met before. */
    CERTIFIED,
    /** There is no key: anybody can have sent it. */
    NONE;

    private static final String NAME = "peer";

    /** The annotation of what came sealed from the device, such as {@code peer(certified,ROMA)}. */
    public Structure mark(String from) {
        return ASSyntax.createStructure(NAME, ASSyntax.createAtom(Policy.word(this)), ASSyntax.createAtom(from));
    }

    /** The belief that the board has a key for the device, such as {@code peer(ROMA,certified)}. */
    public Literal belief(Address device) {
        return ASSyntax.createLiteral(NAME, ASSyntax.createAtom(device.toString()),
                ASSyntax.createAtom(Policy.word(this)));
    }
}
