package javino.board;

import java.util.List;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.PollReply;
import javino.protocol.HostMessage;

/**
 * Callbacks for events of a board.
 *
 * <p>The session's own thread calls all methods, one at a time and without a lock; while one runs, no request goes to
 * the board. If one throws, that is logged and counted as {@link SessionCounter#LISTENER_FAILURES}.
 */
public interface BoardListener {

    /** The board has answered hello: for the first time, or again after it was offline. */
    default void online(BoardInfo info) {
    }

    /**
     * The board cannot be reached. Called once for each reason, however often the session tries again. Its percepts are
     * no longer valid; if they are switched on, they are told anew after {@link #online}.
     *
     * @param why one line.
     */
    default void offline(String why) {
    }

    /**
     * The board's percepts have changed, or were asked for the first time since the board came online.
     *
     * @param literals all percepts now: AgentSpeak literals according to the board, not parsed.
     */
    default void percepts(List<String> literals) {
    }

    /**
     * A message came by radio. In one session each message comes once, except broadcasts, whose repeats nobody can
     * recognise. When this returns (or throws), the session tells the board at once that the message was taken, and the
     * sender learns that it was delivered.
     */
    default void message(ReceivedMessage message) {
    }

    /**
     * A host message came by radio (SPEC 3.1), under the same rules as a message.
     *
     * @param from the device that sent it.
     * @param to   this device, if it was sealed, or all.
     */
    default void hostMessage(Address from, Address to, HostMessage message) {
    }

    /**
     * A sealed frame came for the board or its group, and the board has no key for it; only while the radio is open.
     * Its sender tries again, so it may be told several times. The board could not check it: anybody may have sent it,
     * in anybody's name.
     */
    default void noKey(PollReply.NoKey frame) {
    }

    /**
     * The board has heard a packet on the air, whoever it is for; only if {@link Board#overhear} asks for it.
     */
    default void overheard(PollReply.Overheard packet) {
    }

    /**
     * The sketch has printed on the board's serial line, between two packets.
     *
     * @param text some of it; it may have several lines.
     */
    default void printed(String text) {
    }

    /**
     * A percept or message from the board was skipped, since it is no text or no content; or the board has lost what
     * its security rests on, or its sketch prints on the line.
     *
     * @param what one line that says what, why, and what to do.
     */
    default void warning(String what) {
    }

    /**
     * A percept of a reading has no number that the board can write, as of a sensor that does not answer (SPEC 4.3).
     * Called once for a row of such readings; if not overridden, a {@link #warning}.
     *
     * @param what one line that names the percept and says why.
     */
    default void numberLeftOut(String what) {
        warning(what);
    }

    /**
     * Another part of the board's sketch uses the radio's timer too (SPEC 4.3). Called once for each boot of the board;
     * if not overridden, a {@link #warning}.
     *
     * @param timer the number of the timer, 0…5.
     * @param what  one line that says what to do.
     */
    default void timerTaken(int timer, String what) {
        warning(what);
    }
}
