package keyagreement;

import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.HostMessage;
import javino.protocol.Key;

/** An effect that {@link KeyAgreement} asks for. */
sealed interface Effect {

    /**
     * To send a host message to all, and to call {@link KeyAgreement#said}, however that ends.
     *
     * @param handshake its handshake; 0 for none, and then nothing has to be called.
     */
    record Broadcast(int handshake, HostMessage message) implements Effect {
    }

    /** To send a host message to a device, and to call {@link KeyAgreement#sent}. There is one at a time for each. */
    record Unicast(Address to, HostMessage message, Optional<Object> ticket) implements Effect {
    }

    /** To send a message of {@link KeyAgreement#sendToGroup}: the board has the key. */
    record Multicast(Object ticket) implements Effect {
    }

    /** To give the board a session key, and to call {@link KeyAgreement#keySet}. */
    record SetSessionKey(Address device, Key key) implements Effect {
    }

    /** To have the board delete a session key. */
    record DeleteKey(Address device) implements Effect {
    }

    /** To give the board the key of the own group, and to call {@link KeyAgreement#groupKeySet} if it takes it; or
     * {@link KeyAgreement#groupKeyRefused} if it has lost it. */
    record SetGroupKey(Key key) implements Effect {
    }

    /** To keep the own group's key for {@link KeyAgreement#KeyAgreement}, as its server. */
    record KeepGroupKey(GroupKeys.Kept kept) implements Effect {
    }

    /** To keep the identity's revocation lists. */
    record KeepRevocationLists() implements Effect {
    }

    /** To tell the agent that there is a fresh key with a device that has shown a certificate that counts. */
    record Met(Address peer) implements Effect {
    }

    /** To hand a content on, which came from a device with a certificate, sealed. */
    record Receive(Address from, Content content) implements Effect {
    }

    /** To tell what became of a message. */
    record End(Object ticket, Ending how) implements Effect {
    }

    /** To log the state of a machine, before what follows from it. */
    record Transition(String machine, Address peer, String id, Enum<?> state) implements Effect {
    }
}
