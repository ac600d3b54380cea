package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.AgentProcess;
import harness.BrokerClient;
import harness.Emulator;
import harness.Host;
import harness.Mosquitto;
import harness.TestKeys;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The example of an agent that publishes into MQTT what it chooses (examples/home). */
class HomeTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final Path EXAMPLE = ROOT.resolve("examples/home");
    private static final long PATIENCE_SECONDS = 240;

    private final BlockingQueue<String> published = new LinkedBlockingQueue<>();

    @Test
    @Tag("soak")
    void agent_publishesTheLightThatItIsToldSealed_andNothingElse(@TempDir Path folder) throws Exception {
        try (Mosquitto broker = Mosquitto.start(folder.resolve("broker"));
                Emulator emulator = new Emulator.Scenario().board("home", "Station").board("garden", "Station")
                        .start(folder);
                BrokerClient watcher = BrokerClient.enter(broker, Mosquitto.OWNER)) {
            watcher.watch("#", this::told);
            Host.of(emulator, "home").as("HOME", Map.of("GARD", TestKeys.PAIR)).close();
            Host garden = Host.of(emulator, "garden").as("GARD", Map.of("HOME", TestKeys.PAIR));
            try (garden; AgentProcess agent = start(folder, broker)) {
                assertEquals(
                        "homeassistant/sensor/garden_light/config {\"name\": \"Light in the garden\", \"unique_id\": "
                                + "\"garden_light\", \"state_topic\": \"garden/light\"}",
                        next(), () -> agent.lines().toString());
                garden.send("////", "tell;light(1)");
                garden.send("HOME", "tell;door(open)");
                garden.send("HOME", "tell;light(300)");
                assertEquals("garden/light 300", next());
                garden.send("HOME", "tell;light(dark)");
                garden.send("HOME", "tell;light(200)");
                assertEquals("garden/light 200", next());
                assertEquals(List.of(), List.copyOf(published));
                broker.stop();
                garden.send("HOME", "tell;light(100)");
                agent.await("the broker does not take garden/light");
                broker.start();
                garden.send("HOME", "tell;light(50)");
                try (BrokerClient later = BrokerClient.enter(broker, Mosquitto.OWNER)) {
                    later.watch("garden/#", this::told);
                    String last = next();
                    assertEquals("garden/light 50", last.endsWith("200") ? next() : last);
                }
            }
        }
    }

    private static AgentProcess start(Path folder, Mosquitto broker) throws Exception {
        Files.copy(EXAMPLE.resolve("home.mas2j"), folder.resolve("home.mas2j"));
        Files.writeString(folder.resolve("home.asl"), Files.readString(EXAMPLE.resolve("home.asl"))
                .replace("ttyACM0", '"' + folder.resolve("ports/home").toString() + '"'));
        Path home = Path.of(System.getProperty("java.home"), "bin");
        Process keytool = new ProcessBuilder(home.resolve("keytool").toString(), "-importcert", "-noprompt", "-file",
                broker.ca().toString(), "-keystore", "trusted", "-storepass", "public").directory(folder.toFile())
                .start();
        assertEquals(0, keytool.waitFor());
        ProcessBuilder command = new ProcessBuilder(home.resolve("java").toString(),
                "-Djavax.net.ssl.trustStore=trusted", "-Djavax.net.ssl.trustStorePassword=public", "-cp",
                System.getProperty("java.class.path"),
                "jason.infra.local.RunLocalMAS", "home.mas2j", "--log-conf",
                ROOT.resolve("examples/highway/logging.properties").toString(), "--no-net").directory(folder.toFile());
        command.environment().putAll(Map.of("MQTT_BROKER", "mqtts://localhost:" + broker.port(), "MQTT_USER",
                Mosquitto.OWNER, "MQTT_PASSWORD", Mosquitto.PASSWORD));
        return AgentProcess.start(command);
    }

    private void told(String topic, byte[] what) {
        published.add(topic + " " + new String(what, StandardCharsets.UTF_8));
    }

    private String next() throws InterruptedException {
        return published.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
    }
}
