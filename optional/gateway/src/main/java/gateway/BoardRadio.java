package gateway;

import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import javino.JavinoException;
import javino.board.AirtimeHour;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.BoardState;
import javino.cli.Await;
import javino.cli.Overhearing;
import javino.link.LinkOpener;
import javino.protocol.BoardInfo;
import javino.protocol.Frame;
import javino.protocol.Outcome;
import javino.protocol.PollReply;
import javino.protocol.Status;

/** The radio of a board that overhears. */
final class BoardRadio implements Radio {

    private final Board board;

    private BoardRadio(Board board) {
        this.board = board;
    }

    /** Finds a board. @throws JavinoException if it is not there, or cannot do what a gateway needs. */
    static Radio open(LinkOpener link, Listener listener) throws JavinoException, InterruptedException {
        BoardRadio radio = new BoardRadio(Board.open(link, BoardConfig.create(), new BoardListener() {

            @Override
            public void online(BoardInfo info) {
                listener.online(info.firmware());
            }

            @Override
            public void offline(String why) {
                listener.offline(why);
            }

            @Override
            public void overheard(PollReply.Overheard packet) {
                if (packet.how() == PollReply.Reception.DAMAGED) {
                    listener.damaged();
                } else {
                    listener.heard(packet.payload());
                }
            }
        }));
        try {
            if (Await.result(radio.board, radio.board.greeted()).hasUnicastsOnly()) {
                throw new JavinoException(link.name() + ": " + Status.UNICASTS_ONLY.explanation());
            }
            Overhearing.begin(radio.board, link.name());
            return radio;
        } catch (JavinoException | InterruptedException e) {
            radio.close();
            throw e;
        }
    }

    @Override
    public boolean isOnline() {
        return board.state() == BoardState.ONLINE;
    }

    @Override
    public long airtimeWait() {
        return TimeUnit.SECONDS.toMillis(board.airtime().map(AirtimeHour.Use::waitSeconds).orElse(0L));
    }

    @Override
    public CompletionStage<Boolean> relay(Frame frame) {
        return board.relay(frame).end().handle((outcome, failure) -> outcome == Outcome.SENT);
    }

    /** The board no longer overhears. */
    @Override
    public void close() {
        Overhearing.end(board);
        board.close();
    }
}
