package strangers;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;
import strangers.edhoc.HandshakeException;
import strangers.edhoc.Party;
import strangers.edhoc.Secret;

/** What a device is to strangers: its certificate and secret, the authorities that it trusts, their last notices. */
public final class Identity {

    private Identity() {
    }

    /** Where {@code javino enroll} puts identities unless told otherwise: {@code ~/.javino}. */
    public static Path defaultFolder() {
        throw new UnsupportedOperationException();
    }

    /**
     * Reads the identity of a device, which {@code javino enroll} wrote.
     *
     * @return nothing where the device has no certificate.
     * @throws IllegalArgumentException if the file is damaged, or others may read it.
     */
    public static Optional<Identity> read(Path folder, Address device) throws IOException {
        throw new UnsupportedOperationException();
    }

    /** Its own certificate. */
    public Certificate certificate() {
        throw new UnsupportedOperationException();
    }

    /**
     * This device in a handshake with another.
     *
     * @param other whom it wants, or whose address the frame has. Only a certificate for this address is accepted, and
     *              only one that passes {@link #check}.
     */
    public Party with(Address other) {
        throw new UnsupportedOperationException();
    }

    /**
     * Whether a certificate may be believed now: its authority is trusted, its day not past, no notice names it, and it
     * is not this device's own. To be asked again before a renewal.
     */
    public void check(Certificate certificate) throws HandshakeException {
        throw new UnsupportedOperationException();
    }

    /** The newest notice of each authority that was trusted, to be handed on. */
    public List<Notice> notices() {
        throw new UnsupportedOperationException();
    }

    /**
     * Takes a notice that came from anybody, and keeps it in the file.
     *
     * @return whether it is newer than all before.
     * @throws HandshakeException if it is forged or of no trusted authority.
     */
    public boolean take(Bytes notice) throws HandshakeException, IOException, JavinoException, InterruptedException {
        throw new UnsupportedOperationException();
    }

    /** The key of a session, for the boards of both: the same at both sides (SPEC 11.3). */
    public static Key key(Secret secret, Address initiator, Address responder) {
        throw new UnsupportedOperationException();
    }
}
