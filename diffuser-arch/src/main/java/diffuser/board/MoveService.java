package diffuser.board;

/** Moves agents by an agent's board (SPEC 9). Without it, an agent is told that others cannot come. */
public interface MoveService extends HostService {

    /** Whether other agents may come; asked in each cycle on the agent's own thread. */
    boolean admits();
}
