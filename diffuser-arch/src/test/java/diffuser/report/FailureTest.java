package diffuser.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;

import jason.JasonException;
import jason.asSyntax.ASSyntax;

import javino.board.AirtimeUsedException;
import javino.board.BoardOfflineException;
import javino.board.LegacyBoardException;
import javino.board.OutcomeUnknownException;
import javino.board.QueueFullException;
import javino.board.RequestFailedException;
import javino.protocol.Status;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class FailureTest {

    static Stream<Arguments> errors() {
        return Stream.of(Arguments.of("port_off", new BoardOfflineException("act go", "unplugged")),
                Arguments.of("outcome_unknown", new OutcomeUnknownException("act go", "unplugged")),
                Arguments.of("legacy_board", new LegacyBoardException("statistics")),
                Arguments.of("queue_full", new QueueFullException("act go", 16)),
                Arguments.of("no_key", new RequestFailedException("act go", Status.NO_KEY)),
                Arguments.of("board_error", new IllegalStateException("odd")),
                Arguments.of("bad_address", new JasonException("no", ASSyntax.createAtom("bad_address"))));
    }

    @ParameterizedTest
    @MethodSource("errors")
    void of_exception_isItsErrorAndMessage(String error, Exception exception) {
        Failure failure = new Failure(error, exception.getMessage());
        assertEquals(failure, Failure.of(exception));
        assertEquals(failure, Failure.of(new CompletionException(new CompletionException(exception))));
        assertEquals("error(" + error + ")", failure.annotation().toString());
        assertEquals(failure, Failure.of(failure.toException()));
    }

    @Test
    void of_exceptionWithoutWords_isATimeoutOrABoardError() {
        assertEquals("timeout", Failure.of(new TimeoutException()).error());
        assertEquals("board_error", Failure.of(new CompletionException("nothing behind", null)).error());
    }

    @Test
    void is_error_isTheOneAskedFor() {
        assertTrue(new Failure("undelivered", "").isUndelivered());
        assertFalse(new Failure("too_long", "").isUndelivered());
        assertTrue(Failure.of(new RequestFailedException("act go", Status.TOO_LONG)).isTooLong());
        assertFalse(new Failure("undelivered", "").isTooLong());
    }

    @Test
    void of_usedAirtime_saysWhenToTryAgain() {
        Failure failure = Failure.of(new AirtimeUsedException("transmit to ROMA", 42));
        assertEquals("airtime_used", failure.error());
        assertEquals("seconds(42)", failure.annotations().get(2).toString());
        assertEquals(failure, Failure.of(failure.toException()));
    }

    @Test
    void brief_messageOfMoreThan80Characters_isTheError() {
        assertEquals("x".repeat(80), new Failure("no_key", "x".repeat(80)).brief());
        assertEquals("no_key", new Failure("no_key", "x".repeat(81)).brief());
    }
}
