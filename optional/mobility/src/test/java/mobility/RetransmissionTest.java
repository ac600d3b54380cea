package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import javino.protocol.Outcome;

class RetransmissionTest {

    @Test
    void say_untilAnswered_atTheTimesOfSpec(@TempDir Path folder) {
        Simulation simulation = new Simulation(1, folder);
        Simulation.Side side = simulation.side(Simulation.STATION);
        side.host.start();
        Deque<CompletableFuture<Outcome>> outcomes =
                new ArrayDeque<>(Collections.nCopies(6, CompletableFuture.completedFuture(Outcome.UNDELIVERED)));
        outcomes.add(CompletableFuture.failedFuture(new IllegalStateException("the board takes nothing")));
        outcomes.add(CompletableFuture.completedFuture(Outcome.UNDELIVERED));
        outcomes.add(CompletableFuture.completedFuture(Outcome.DELIVERED));
        List<Long> seconds = new ArrayList<>();
        Retransmission call = new Retransmission(side.host, said -> {
            seconds.add(simulation.millis() / 1_000);
            return outcomes.isEmpty() ? new CompletableFuture<>() : outcomes.remove();
        }, event -> {});
        call.say(Optional.of(new MoveMessage.Go()), 1_000);
        simulation.runUntil(200_000);
        assertEquals(List.of(1L, 3L, 7L, 15L, 31L, 61L, 91L, 93L, 95L, 98L), seconds);
    }
}
