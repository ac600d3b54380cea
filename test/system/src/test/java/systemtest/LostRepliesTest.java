package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.ForwardedLink;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import javino.board.SessionCounter;
import javino.link.Link;
import javino.link.LinkException;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Outcome;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Hosts that lose some of what their boards say, or boards some of what hosts say: the model allows it. */
@InEmulatedTime
class LostRepliesTest {

    private static final int MESSAGES = 6;

    @TempDir
    private Path folder;
    @AutoClose
    private Emulator emulator;

    /** Loses each n-th piece that its host would read, or writes; none by 0. */
    private static final class LosingLink extends ForwardedLink {

        private final int ofReplies;
        private final int ofRequests;
        private int replies;
        private int requests;

        LosingLink(Link link, int ofReplies, int ofRequests) {
            super(link);
            this.ofReplies = ofReplies;
            this.ofRequests = ofRequests;
        }

        @Override
        public void write(byte[] bytes) throws LinkException {
            if (ofRequests == 0 || ++requests % ofRequests != 0) {
                link.write(bytes);
            }
        }

        @Override
        public int read(byte[] into, Duration timeout) throws LinkException {
            int count = link.read(into, timeout);
            return count == 0 || ofReplies == 0 || ++replies % ofReplies != 0 ? count : 0;
        }
    }

    private Host host(String board, int ofReplies, int ofRequests) {
        return emulator.closing(Host.atUsualTimes(ForwardedLink.opener(Host.link(emulator.port(board)),
                link -> new LosingLink(link, ofReplies, ofRequests))), Host::close);
    }

    @Test
    @Tag("verify")
    void messages_whereEachTenthPieceIsLost_comeOnce() throws Exception {
        messages_whereEachNthPieceIsLost_comeOnce(10, 0);
    }

    @ParameterizedTest
    @CsvSource({"3, 0", "5, 0", "0, 5", "9, 7"})
    void messages_whereEachNthPieceIsLost_comeOnce(int ofReplies, int ofRequests) throws Exception {
        emulator = new Emulator.Scenario().board("police", "Vehicle").board("support", "Station").start(folder);
        Host police = host("police", ofReplies, ofRequests).as("SUPO", Map.of("SUPP", TestKeys.PAIR));
        Host support = host("support", ofReplies, ofRequests).as("SUPP", Map.of("SUPO", TestKeys.PAIR));
        List<CompletableFuture<Outcome>> ofPolice = new ArrayList<>();
        List<CompletableFuture<Outcome>> ofSupport = new ArrayList<>();
        for (int i = 0; i < MESSAGES; i++) {
            Content content = Content.parse("tell;n(" + i + ")");
            ofPolice.add(police.board.transmit(Address.parse("SUPP"), content).end());
            ofSupport.add(support.board.transmit(Address.parse("SUPO"), content).end());
        }
        assertDelivered(ofPolice, support);
        assertDelivered(ofSupport, police);
    }

    private static void assertDelivered(List<CompletableFuture<Outcome>> ends, Host to) {
        long delivered = ends.stream().map(Host::get).filter(Predicate.isEqual(Outcome.DELIVERED)).count();
        List<String> came = to.messages().stream().map(message -> message.content().toString()).toList();
        assertEquals(new HashSet<>(came).size(), came.size(), came.toString());
        assertTrue(delivered > 0 && delivered <= came.size(), delivered + " of " + came);
        assertTrue(to.board.counters().get(SessionCounter.REPEATS) > 0, "nothing was lost");
    }
}
