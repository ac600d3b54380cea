package diffuser.board;

import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;

import diffuser.report.Failure;

import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Key;
import javino.protocol.PollReply;
import javino.protocol.Reply;
import javino.protocol.Message;

/**
 * Finds keys for devices with which the board has none (SPEC 11). Without it, a message to such a device fails with
 * {@code no_key}. All methods are called on any thread, and return at once.
 */
public interface KeyService extends HostService {

    /** The board, and the agent behind it. For any thread; no method waits, and futures fail as a board's. */
    interface Host {

        /** Whether the board has broadcasts, by which devices agree on keys. */
        boolean hasBroadcasts();

        /** For how many s the board's airtime limit holds back a new message; 0: not at all, as far as is known. */
        long airtimeWait();

        /** Sends a message under the key that the board has, as {@link Sender#send}. */
        Transmission send(Address to, Message message);

        /** Gives the board the session key of a pair. The device counts as certified from now on. */
        CompletableFuture<?> setSessionKey(Address device, Key key);

        /** Gives the board the key of a group, which it stores. */
        CompletableFuture<?> setGroupKey(Address group, Key key);

        /** Has the board delete a session key. */
        CompletableFuture<?> deleteKey(Address device);

        /** Tells the agent with which devices the board has session keys now. */
        void met(Set<Address> peers);

        /** A message of a certified device for the agent. */
        void received(Address from, Content content);

        /** Tells the user something. */
        void warn(String what);
    }

    /**
     * The board is there and has an address: for the first time, or again after it was lost or was given another.
     *
     * @param bootEpoch another one than before if it has booted meanwhile (SPEC 4.3, hello).
     * @param keys      the keys that it has.
     */
    void online(Host host, Address self, int bootEpoch, List<Reply.StoredKey> keys);

    /** A sealed frame has come for which the board has no key. */
    void noKey(PollReply.NoKey frame);

    /**
     * Sends a message to a device or group for which the board has no stored key.
     *
     * @return both fail with what {@link Failure#of} reads.
     */
    Transmission transmit(Host host, Address to, Message message);

    /** Whether certified devices can get the key of the own group. */
    boolean sharesGroup();
}
