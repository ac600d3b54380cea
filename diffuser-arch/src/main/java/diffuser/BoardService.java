package diffuser;

import java.util.Map;

/**
 * What a library on the class path does by an agent's board, such as {@link MoveService} and {@link KeyService}. It is
 * found by Java's {@link java.util.ServiceLoader}.
 */
public interface BoardService {

    /** Makes the one for an agent with a board. */
    interface Maker {

        /** @param diffuser whose board it uses; called when that one is made, before its agent runs. */
        BoardService of(Diffuser diffuser);
    }

    /** What it adds to the agent's status. */
    Map<String, Object> status();

    /** The agent is stopped; called on the thread of its {@link HostClock}, on which nothing new comes any more. */
    void stop();
}
