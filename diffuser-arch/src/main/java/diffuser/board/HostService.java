package diffuser.board;

import java.util.Set;

import javino.protocol.Address;
import javino.protocol.HostMessage;

/** A library's service for messages of other hosts. */
public interface HostService {

    /** Which messages are for it. */
    Set<HostMessage.Use> uses();

    /** One of these has come, which may come by its cast and key. On any thread; returns at once. */
    void received(Address from, HostMessage message);
}
