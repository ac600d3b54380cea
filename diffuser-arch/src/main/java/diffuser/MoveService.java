package diffuser;

import javino.protocol.Address;
import javino.protocol.Bytes;

/** What moves agents by an agent's board (SPEC 9). Without one, an agent is told that others cannot come. */
public interface MoveService extends BoardService {

    /** The bytes that another device's host has said, in a unicast. On any thread; returns at once. */
    void received(Address from, Bytes bytes);

    /** Whether other agents may come; asked in each cycle on the agent's own thread. */
    boolean admits();
}
