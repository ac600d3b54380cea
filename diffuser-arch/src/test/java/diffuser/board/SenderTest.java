package diffuser.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

import diffuser.report.Failure;

import javino.board.BoardOfflineException;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.Message;
import javino.protocol.HostMessage.Kind;
import javino.protocol.Outcome;

import org.junit.jupiter.api.Test;

class SenderTest {

    private static final Address ROMA = Address.parse("ROMA");
    private static final Address SUPO = Address.parse("SUPO");

    private final List<Message> sent = new ArrayList<>();
    private final Deque<CompletableFuture<Outcome>> ends = new ArrayDeque<>();
    private final Sender sender = new Sender(this::transmit);

    private Transmission transmit(Address to, Message message) {
        sent.add(message);
        ends.add(new CompletableFuture<>());
        return new Transmission(CompletableFuture.completedFuture(null), ends.getLast());
    }

    private static HostMessage sequences(int number) {
        return new HostMessage(Kind.SEQUENCES, Bytes.of(number));
    }

    @Test
    void send_severalToOneAddress_oneIsUnderWayAtATimeAndEachHasItsEnd() {
        List<Transmission> all = List.of(sender.send(ROMA, sequences(1)), sender.send(ROMA, sequences(2)),
                sender.send(SUPO, sequences(3)), sender.send(ROMA, sequences(4)));
        assertEquals(List.of(sequences(1), sequences(3)), sent);
        assertFalse(all.get(1).taken().isDone());
        ends.poll().complete(Outcome.UNDELIVERED);
        assertEquals(Outcome.UNDELIVERED, all.get(0).end().join());
        assertEquals(List.of(sequences(1), sequences(3), sequences(2)), sent);
        assertTrue(all.get(1).taken().isDone());
        ends.getLast().completeExceptionally(new BoardOfflineException("transmit", "it is off"));
        assertTrue(all.get(1).end().isCompletedExceptionally());
        ends.getLast().complete(Outcome.DELIVERED);
        assertEquals(Outcome.DELIVERED, all.get(3).end().join());
        sender.send(ROMA, sequences(5));
        assertEquals(5, sent.size(), "nothing is under way any more");
    }

    @Test
    void send_whatTheBoardRefusesAtOnce_failsAndLetsTheNextOneGo() {
        Sender refusing = new Sender((to, message) -> {
            if (message.equals(sequences(2))) {
                throw new IllegalArgumentException("too long");
            }
            return transmit(to, message);
        });
        refusing.send(ROMA, sequences(1));
        Transmission refused = refusing.send(ROMA, sequences(2));
        refusing.send(ROMA, sequences(3));
        ends.poll().complete(Outcome.DELIVERED);
        assertTrue(refused.taken().isCompletedExceptionally());
        assertTrue(refused.end().isCompletedExceptionally());
        assertEquals(List.of(sequences(1), sequences(3)), sent);
    }

    @Test
    void send_whatWaitsAlreadyOrTooMany_failsAndIsCounted() {
        sender.send(ROMA, sequences(0));
        assertFalse(sender.send(ROMA, sequences(0)).end().isDone(), "what is under way may be said again");
        assertEquals("queue_full", error(sender.send(ROMA, sequences(0))));
        for (int i = 1; i < Sender.MOST_WAITING; i++) {
            assertFalse(sender.send(ROMA, sequences(i)).end().isDone());
        }
        assertEquals("queue_full", error(sender.send(ROMA, sequences(99))));
        assertEquals(2, sender.notSent());
        assertFalse(sender.send(SUPO, sequences(99)).end().isDone());
    }

    private static String error(Transmission transmission) {
        assertTrue(transmission.taken().isCompletedExceptionally());
        return Failure.of(assertThrows(CompletionException.class, () -> transmission.end().join())).error();
    }
}
