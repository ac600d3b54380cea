package javino.board;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.PollReply;
import javino.protocol.ProtocolException;
import javino.protocol.Request;

/** Makes polls, and turns what they bring into calls of the listener. For the session's thread only. */
final class Inbox {

    private final Wishes wishes;
    private final BoardListener listener;
    private final Tally tally;
    private BoardInfo source;
    private int taken = Request.Poll.NOTHING_TAKEN;
    private List<Bytes> percepts;
    private boolean leftOut;
    private Deadline nextPercepts = Deadline.in(Duration.ZERO);

    Inbox(Wishes wishes, BoardListener listener, Tally tally) {
        this.wishes = wishes;
        this.listener = listener;
        this.tally = tally;
    }

    /** A board came online: percepts will be told anew; after a boot its messages are counted anew, too. */
    void greeted(BoardInfo board) {
        if (!board.equals(source)) {
            taken = Request.Poll.NOTHING_TAKEN;
        }
        source = board;
        percepts = null;
        leftOut = false;
    }

    /** The same board has a new address. */
    void renamed(BoardInfo board) {
        source = board;
    }

    Request.Poll nextPoll() {
        boolean wanted = wishes.percepts();
        if (!wanted && percepts != null) {
            tellPercepts(List.of());
            percepts = null;
        }
        boolean now = wanted && (percepts == null || nextPercepts.passed());
        if (now) {
            nextPercepts = Deadline.in(wishes.perceptInterval());
        }
        return new Request.Poll(now, taken);
    }

    /** Takes over all that a poll brought. */
    void take(Request.Poll poll, PollReply reply) {
        List<Bytes> literals = new ArrayList<>();
        for (PollReply.Item item : reply.records()) {
            if (item instanceof PollReply.Percept percept) {
                literals.add(percept.literal());
            } else if (item instanceof PollReply.Message message) {
                takeMessage(message);
            } else if (item instanceof PollReply.Transmission transmission) {
                listener.transmitted(transmission.number(), transmission.outcome());
            }
        }
        if (poll.percepts()) {
            takePercepts(literals, reply.leftOut());
        }
    }

    private void takeMessage(PollReply.Message message) {
        taken = message.number();
        tally.count(SessionCounter.MESSAGES);
        try {
            Content content = Content.decode(message.content());
            listener.message(new ReceivedMessage(message.origin(), message.destination(), message.id(), content));
        } catch (ProtocolException e) {
            skip("a message from " + message.origin(), e);
        }
    }

    private void takePercepts(List<Bytes> literals, boolean someLeftOut) {
        if (someLeftOut && !leftOut) {
            listener.warning("the board has more percepts than fit one reply; the last ones are left out");
        }
        leftOut = someLeftOut;
        if (!literals.equals(percepts)) {
            tellPercepts(literals);
            percepts = literals;
        }
    }

    private void tellPercepts(List<Bytes> literals) {
        List<String> texts = new ArrayList<>();
        for (Bytes literal : literals) {
            try {
                texts.add(literal.text());
            } catch (ProtocolException e) {
                skip("a percept", e);
            }
        }
        listener.percepts(List.copyOf(texts));
    }

    private void skip(String what, ProtocolException why) {
        tally.count(SessionCounter.DAMAGED_RECORDS);
        listener.warning(what + " was skipped: " + why.getMessage());
    }
}
