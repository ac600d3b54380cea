package javino.cli;

import java.util.Map;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardListener;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.PollReply;
import javino.protocol.ProtocolException;

/** Listens while a message is on its way, and says what is known if it stays without an acknowledgement. */
final class SilenceCheck implements BoardListener {

    private final Address to;
    private volatile String loss;
    private volatile boolean heard;
    private boolean overhears;
    private Map<Counter, Long> before = Map.of();

    /** @param to the receiver of the message. */
    SilenceCheck(Address to) {
        this.to = to;
    }

    @Override
    public void offline(String reason) {
        loss = reason;
    }

    @Override
    public void overheard(PollReply.Overheard packet) {
        if (packet.how() != PollReply.Reception.DAMAGED && isFrom(to, packet.payload())) {
            heard = true;
        }
    }

    private static boolean isFrom(Address origin, Bytes payload) {
        try {
            return Frame.decode(payload).origin().equals(origin);
        } catch (ProtocolException e) {
            // Other equipment, or a later protocol.
            return false;
        }
    }

    /** Begins, if an acknowledgement is to come at all; a small board goes without overhearing. */
    void begin(Board board) throws JavinoException, InterruptedException {
        if (to.kind() != Address.Kind.DEVICE) {
            return;
        }
        before = Await.result(board, board.statistics());
        overhears = board.time().join(board.overhear(true).handle((begun, failure) -> failure == null));
    }

    /** The known facts about a silence. */
    String end(Board board) throws InterruptedException {
        if (loss != null) {
            return loss;
        }
        try {
            return describe(Await.result(board, board.statistics()));
        } catch (JavinoException e) {
            return e.getMessage();
        }
    }

    private String describe(Map<Counter, Long> now) {
        if (rise(now, Counter.RADIO_SENT) == 0 && rise(now, Counter.RADIO_DEFERRED) > 0) {
            return "the air was never free, so nothing was sent: another transmitter, or noise";
        }
        if (rise(now, Counter.RADIO_BAD_PROOFS) > 0) {
            return to + " has answered under another key: javino info shows the check values on both sides";
        }
        if (rise(now, Counter.RADIO_RECEIVED) + rise(now, Counter.RADIO_DAMAGED) == 0) {
            return "the board has heard no packet of anybody meanwhile: is another board on, near, and its agent "
                    + "running?";
        }
        if (heard) {
            return to + " was heard, but no acknowledgement of it";
        }
        return overhears ? "other packets were heard, but none from " + to + ": is this the right address?"
                : "other packets were heard, but no acknowledgement";
    }

    private long rise(Map<Counter, Long> now, Counter counter) {
        return now.getOrDefault(counter, 0L) - before.getOrDefault(counter, 0L);
    }
}
