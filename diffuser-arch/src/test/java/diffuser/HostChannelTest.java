package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

import org.junit.jupiter.api.Test;

import javino.board.BoardOfflineException;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.Outcome;

class HostChannelTest {

    private static final Address ROMA = Address.parse("ROMA");
    private static final Address SUPO = Address.parse("SUPO");

    private final List<Kind> taken = new ArrayList<>();
    private final List<String> warnings = new ArrayList<>();
    private final List<HostMessage> sent = new ArrayList<>();
    private final Deque<CompletableFuture<Outcome>> ends = new ArrayDeque<>();

    /** Takes what is for these uses. */
    private record Taker(Set<HostMessage.Use> uses, List<Kind> taken) implements HostService {

        @Override
        public void received(Address from, HostMessage message) {
            taken.add(message.kind());
        }

        @Override
        public Map<String, Object> status() {
            return Map.of();
        }

        @Override
        public void stop() {
            // It has begun nothing.
        }
    }

    private HostChannel channel(HostMessage.Use... uses) {
        return new HostChannel(List.of(new Taker(Set.of(uses), taken)), this::transmit, warnings::add);
    }

    private Transmission transmit(Address to, HostMessage message) {
        sent.add(message);
        ends.add(new CompletableFuture<>());
        return new Transmission(CompletableFuture.completedFuture(null), ends.getLast());
    }

    private static HostMessage message(Kind kind) {
        boolean plain = kind.compareTo(Kind.GROUP) <= 0;
        Bytes body = Bytes.copyOf(new byte[kind.length() < 0 ? 5 : kind.length()]);
        return plain ? HostMessage.fragments(kind, SUPO, body).get(0) : new HostMessage(kind, body);
    }

    /** What SPEC 3.1 says of each kind, and nothing else: handshakes broadcast, all else sealed for this device. */
    @Test
    void receive_eachKindByEachCastAndKey_reachesItsLibraryOnlyAsTheSpecificationSays() {
        HostChannel channel = channel(HostMessage.Use.values());
        long refused = 0;
        for (Kind kind : Kind.values()) {
            for (Address to : List.of(Address.BROADCAST, Address.multicast(SUPO.group()), SUPO)) {
                for (TrustLevel key : TrustLevel.values()) {
                    boolean session = key == TrustLevel.CERTIFIED;
                    boolean stored = key == TrustLevel.PROVISIONED;
                    boolean right = kind.compareTo(Kind.GROUP) <= 0 ? to.equals(Address.BROADCAST) && session
                            : to.equals(SUPO) && (session || stored && kind.name().startsWith("MOVE_"));
                    taken.clear();
                    channel.receive(ROMA, to, key, message(kind));
                    assertEquals(right ? List.of(kind) : List.of(), taken, () -> kind + " to " + to + ", " + key);
                    refused += right ? 0 : 1;
                    assertEquals(refused, channel.refused());
                }
            }
        }
        assertEquals(EnumSet.allOf(TrustLevel.class).size() * 3L * Kind.values().length, refused + 8 + 5 + 2 * 8);
    }

    @Test
    void receive_whereItsLibraryIsNotThere_isCountedAndNamedUnlessItWasBroadcast() {
        HostChannel channel = channel();
        channel.receive(ROMA, Address.BROADCAST, TrustLevel.CERTIFIED, message(Kind.MESSAGE_1));
        assertEquals(List.of(), warnings);
        channel.receive(ROMA, SUPO, TrustLevel.PROVISIONED, message(Kind.MOVE_GO));
        assertEquals(List.of("dropped a host message MOVE_GO from ROMA: the library for it is not there"), warnings);
        assertEquals(2, channel.refused());
    }

    @Test
    void receive_inTheNameOfNoDevice_isRefused() {
        HostChannel channel = channel(HostMessage.Use.values());
        channel.receive(Address.BROADCAST, Address.BROADCAST, TrustLevel.CERTIFIED, message(Kind.MESSAGE_1));
        assertEquals(List.of(), taken);
        assertEquals(1, channel.refused());
    }

    private static HostMessage sequences(int number) {
        return new HostMessage(Kind.SEQUENCES, Bytes.of(number));
    }

    @Test
    void send_severalToOneAddress_oneIsUnderWayAtATimeAndEachHasItsEnd() {
        HostChannel channel = channel();
        List<Transmission> all = List.of(channel.send(ROMA, sequences(1)), channel.send(ROMA, sequences(2)),
                channel.send(SUPO, sequences(3)), channel.send(ROMA, sequences(4)));
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
        channel.send(ROMA, sequences(5));
        assertEquals(5, sent.size(), "nothing is under way any more");
    }

    @Test
    void send_whatTheBoardRefusesAtOnce_failsAndLetsTheNextOneGo() {
        HostChannel channel = new HostChannel(List.of(), (to, message) -> {
            if (message.equals(sequences(2))) {
                throw new IllegalArgumentException("too long");
            }
            return transmit(to, message);
        }, warnings::add);
        channel.send(ROMA, sequences(1));
        Transmission refused = channel.send(ROMA, sequences(2));
        channel.send(ROMA, sequences(3));
        ends.poll().complete(Outcome.DELIVERED);
        assertTrue(refused.taken().isCompletedExceptionally());
        assertTrue(refused.end().isCompletedExceptionally());
        assertEquals(List.of(sequences(1), sequences(3)), sent);
    }

    @Test
    void send_whatWaitsAlreadyOrTooMany_failsAndIsCounted() {
        HostChannel channel = channel();
        channel.send(ROMA, sequences(0));
        assertFalse(channel.send(ROMA, sequences(0)).end().isDone(), "what is under way may be said again");
        assertEquals("queue_full", error(channel.send(ROMA, sequences(0))));
        for (int i = 1; i < HostChannel.MOST_WAITING; i++) {
            assertFalse(channel.send(ROMA, sequences(i)).end().isDone());
        }
        assertEquals("queue_full", error(channel.send(ROMA, sequences(99))));
        assertEquals(2, channel.notSent());
        assertFalse(channel.send(SUPO, sequences(99)).end().isDone());
    }

    private static String error(Transmission transmission) {
        assertTrue(transmission.taken().isCompletedExceptionally());
        return Failure.of(assertThrows(CompletionException.class, () -> transmission.end().join())).error();
    }
}
