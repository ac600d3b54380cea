package diffuser;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Structure;

import javino.protocol.Address;

/** What a device is to this one, by the key that they share. */
public enum Peer {
    /** Somebody has put the key on both boards. */
    PROVISIONED("provisioned"),
    /** The hosts have agreed on the key, as both have a certificate: they may never have met before. */
    CERTIFIED("certified");

    private static final String NAME = "peer";

    private final String atom;

    Peer(String atom) {
        this.atom = atom;
    }

    /** The annotation of what came sealed from the device, such as {@code peer(certified,ROMA)}. */
    public Structure mark(Address from) {
        return ASSyntax.createStructure(NAME, ASSyntax.createAtom(atom), ASSyntax.createAtom(from.toString()));
    }

    /** The belief that the board has a key for the device, such as {@code peer(ROMA,certified)}. */
    Literal belief(Address device) {
        return ASSyntax.createLiteral(NAME, ASSyntax.createAtom(device.toString()), ASSyntax.createAtom(atom));
    }
}
