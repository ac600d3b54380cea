package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;

import diffuser.Diffuser;
import diffuser.report.Failure;

import javino.link.Time;
import javino.protocol.Address;

import org.junit.jupiter.api.Test;

class BoardMovesTest {

    private static final Time.Timer AT_ONCE = new Time.Timer() {

        @Override
        public long millis() {
            return 0;
        }

        @Override
        public void after(long millis, Runnable step) {
            step.run();
        }

        @Override
        public void close() {
            // There is nothing to end.
        }
    };

    @Test
    void depart_byABoardWithoutARadio_failsAndSaysSo() {
        Diffuser diffuser = Stage.of("a.").front(new Diffuser() {
            private static final long serialVersionUID = 1L;

            @Override
            public boolean hasRadio() {
                return false;
            }

            @Override
            public Time time() {
                return Time.REAL;
            }

            @Override
            public Time.Timer timer() {
                return AT_ONCE;
            }
        });
        BoardMoves moves = (BoardMoves) new BoardMoves.Maker().of(diffuser);
        try {
            CompletableFuture<String> end =
                    moves.depart("walker", Protocol.MUTUALISM, Address.parse("SUPO"), List.of());
            Failure failure = Failure.of(assertThrows(ExecutionException.class, end::get).getCause());
            assertEquals(new Failure("no_radio", "agents move by a board's radio, which this one has not"), failure);
        } finally {
            moves.stop();
        }
    }
}
