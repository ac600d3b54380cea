package diffuser;

import java.util.Map;

import javino.protocol.Address;
import javino.protocol.Bytes;

/**
 * What moves agents by an agent's board (SPEC 9), where a library on the class path can: it is found by Java's
 * {@link java.util.ServiceLoader}. Without one, an agent is told that others cannot come.
 */
public interface MoveService {

    /** Makes the one for an agent with a board. */
    interface Maker {

        /** @param diffuser whose board it uses; called when that one is made, before its agent runs. */
        MoveService of(Diffuser diffuser);
    }

    /** The bytes that another device's host has said, in a unicast. On any thread; returns at once. */
    void received(Address from, Bytes bytes);

    /** Whether other agents may come; asked in each cycle on the agent's own thread. */
    boolean admits();

    /** What it adds to the agent's status. */
    Map<String, Object> status();

    /** The agent is stopped. */
    void stop();
}
