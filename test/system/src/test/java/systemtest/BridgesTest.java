package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.BrokerClient;
import harness.Mosquitto;
import harness.SlowNetwork;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javino.protocol.Outcome;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Two regions, each with a cell and a broker of its own, which bridges join to a third broker (docs/mqtt.md). */
class BridgesTest extends JoinedCells {

    private static final double MINUTE = 60;

    @AutoClose
    private Mosquitto western;
    @AutoClose
    private Mosquitto eastern;
    @AutoClose
    private SlowNetwork link;
    @AutoClose
    private SlowNetwork other;

    @Override
    void joinRegions(Path folder) throws Exception {
        link = SlowNetwork.open(broker.port(), 0, 0, 1);
        other = SlowNetwork.open(broker.port(), 0, 0, 2);
        western = Mosquitto.start(folder.resolve("western"), "west");
        western.bridge(broker, link.port(), "west");
        eastern = Mosquitto.start(folder.resolve("eastern"), "east");
        eastern.bridge(broker, other.port(), "east");
        awaitBridges();
    }

    @Override
    Mosquitto brokerOf(String cell) {
        return cell.equals("west") ? western : eastern;
    }

    /** Waits until what is published in a region comes to the other. */
    private void awaitBridges() throws Exception {
        awaitBridge(western, eastern, "javino/seek/AAAA/from/probe1");
        awaitBridge(eastern, western, "javino/seek/AAAA/from/probe2");
    }

    private static void awaitBridge(Mosquitto from, Mosquitto to, String topic) throws Exception {
        CountDownLatch came = new CountDownLatch(1);
        try (BrokerClient sender = BrokerClient.enter(from, Mosquitto.OWNER);
                BrokerClient receiver = BrokerClient.enter(to, Mosquitto.OWNER)) {
            receiver.watch(topic, (any, payload) -> came.countDown());
            do {
                sender.say(topic, "");
            } while (!came.await(100, TimeUnit.MILLISECONDS));
        }
    }

    @Test
    @Tag("soak")
    void regions_ofWhichOneOrTheMiddleIsKilledOrCutOff_areJoinedAgainAndNothingComesTwice() throws Exception {
        exchange(0, 2);
        link.block();
        western.kill();
        western.start();
        link.reopen();
        west.await(2, line -> line.contains("connected to"));
        awaitBridges();
        exchange(2, 4);
        link.block();
        double since = now();
        while (now() < since + MINUTE) {
            assertEquals(Outcome.UNDELIVERED, police.send("ROMA", "tell;lost"));
        }
        link.reopen();
        awaitBridges();
        exchange(4, 6);
        link.block();
        other.block();
        broker.kill();
        broker.start();
        link.reopen();
        other.reopen();
        awaitBridges();
        exchange(6, 8);
        assertNothingTwice("police", "east");
        assertNothingTwice("bus", "west");
    }
}
