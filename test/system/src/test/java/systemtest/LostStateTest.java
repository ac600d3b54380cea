package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import harness.Transmitter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import javino.board.RequestFailedException;
import javino.cli.JavinoCommand;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.Outcome;
import javino.protocol.Status;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** Boards that have lost the state on which security rests: epochs in EEPROM, nonces in RAM. */
@InEmulatedTime
class LostStateTest {

    private static final Address SUPP = Address.parse("SUPP");
    /** The places of the copies of the boot epochs in EEPROM by the library's README, and the length of each. */
    private static final List<Integer> EPOCHS_AT = List.of(751, 4048);
    private static final int EPOCHS_LENGTH = 48;
    private static final int NONCE_AT = 10;
    private static final int NONCE_END = 16;

    @TempDir
    private Path folder;

    private String keys;

    private static void assertDone(List<String> lines) {
        assertEquals("0", lines.get(lines.size() - 1), lines.toString());
    }

    private List<String> javino(Emulator emulator, String command, String board, String id) {
        return JavinoCommand.run(command, "--port", emulator.port(board), "--id", id, "--keyring", keys);
    }

    private void writeOverEpochs() throws Exception {
        Path file = folder.resolve("eeprom/police.bin");
        byte[] eeprom = Files.readAllBytes(file);
        EPOCHS_AT.forEach(at -> Arrays.fill(eeprom, at, at + EPOCHS_LENGTH, (byte) 0x33));
        Files.write(file, eeprom);
    }

    private Emulator start() throws Exception {
        return new Emulator.Scenario().board("police", "Station").board("support", "Station")
                .board("thief", "Transmitter").start(folder);
    }

    private static Status refusal(Host host) {
        ExecutionException failed = assertThrows(ExecutionException.class,
                () -> Host.await(host.board.transmit(SUPP, Content.parse("tell;x")).taken()));
        return ((RequestFailedException) failed.getCause()).status();
    }

    /** Both send; what the police has sealed is added, and no nonce may have been there. */
    private static void exchange(Emulator emulator, String text, Map<String, String> sealed) throws Exception {
        try (Host police = Host.of(emulator, "police").listen(); Host support = Host.of(emulator, "support").listen()) {
            for (int i = 0; i < 3; i++) {
                String content = "tell;" + text + i;
                assertEquals(Outcome.DELIVERED, police.send("SUPP", content));
                assertEquals(content, support.content());
                assertEquals(Outcome.DELIVERED, support.send("SUPO", content));
                assertEquals(content, police.content());
            }
        }
        Map<String, String> here = new HashMap<>();
        for (byte[] packet : sentBy(emulator, "police")) {
            if (packet[0] != '+') {
                here.put(HexFormat.of().formatHex(packet, NONCE_AT, NONCE_END), HexFormat.of().formatHex(packet));
            }
        }
        here.forEach((nonce, packet) -> assertNull(sealed.put(nonce, packet), "nonce " + nonce + " came again"));
    }

    private static List<byte[]> sentBy(Emulator emulator, String board) {
        return emulator.sentBy(board).stream().map(event -> event.bytes("payload")).toList();
    }

    @Test
    void epochs_writtenOverTwice_repeatNoNonceAndLetNoRecordingIn() throws Exception {
        keys = folder.resolve("keys").toString();
        Map<String, String> sealed = new HashMap<>();
        List<byte[]> recorded;
        try (Emulator emulator = start()) {
            // By then in its time, as all random numbers are.
            assertDone(JavinoCommand.run("keygen", "--out", keys, "--pair", "SUPO,SUPP"));
            assertDone(javino(emulator, "provision", "police", "SUPO"));
            assertDone(javino(emulator, "provision", "support", "SUPP"));
            exchange(emulator, "before", sealed);
            recorded = sentBy(emulator, "support");
        }
        for (int loss = 0; loss < 2; loss++) {
            writeOverEpochs();
            try (Emulator emulator = start(); Transmitter thief = Transmitter.of(emulator, "thief")) {
                List<String> examined = javino(emulator, "doctor", "police", "SUPO");
                assertTrue(examined.stream().anyMatch(line -> line.startsWith("nonces")
                        && line.contains("the board has lost its boot epoch")), examined.toString());
                try (Host police = Host.of(emulator, "police").listen()) {
                    assertEquals(Status.EPOCH_LOST, refusal(police));
                    for (byte[] packet : recorded) {
                        thief.send(packet);
                    }
                    assertTrue(police.counter(Counter.RADIO_STALE) + police.counter(Counter.RADIO_REPLAYED) > 0);
                    assertEquals(List.of(), police.messages());
                }
                List<String> done = javino(emulator, "provision", "police", "SUPO");
                assertDone(done);
                assertTrue(done.stream().anyMatch(line -> line.contains("it was raised to ")), done.toString());
                exchange(emulator, "after" + loss, sealed);
            }
        }
    }

    @Test
    @Tag("verify")
    void stack_overTheNonces_takesNoRecordingSealsNothingAndIsTold() throws Exception {
        try (Emulator emulator = start();
                Host support = Host.of(emulator, "support").as("SUPP", Map.of("SUPO", TestKeys.PAIR));
                Host police = Host.of(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR))) {
            assertEquals(Outcome.DELIVERED, police.send("SUPP", "tell;room"));
            assertEquals("tell;room", support.content());
        }
        try (Emulator emulator = new Emulator.Scenario().board("police", "FullRam").board("support", "Station")
                .board("thief", "Transmitter").start(folder);
                Transmitter thief = Transmitter.of(emulator, "thief");
                Host support = Host.of(emulator, "support").listen()) {
            try (Host police = Host.of(emulator, "police").listen()) {
                assertEquals(Outcome.UNDELIVERED, support.send("SUPO", "tell;help"));
                for (TraceEvent sent : emulator.sentBy("support")) {
                    thief.send(sent.bytes("payload"));
                }
                assertEquals(Status.MEMORY_DAMAGED, refusal(police));
                assertTrue(police.counter(Counter.MEMORY_DAMAGED) > 0);
                assertEquals(List.of(), police.messages());
                support.send("////", "tell;help");
                assertEquals("tell;help", police.content(), "what is not sealed works");
            }
            try (Host again = Host.of(emulator, "police")) {
                assertTrue(again.warning().contains("has written over the board's memory of nonces"));
            }
        }
    }
}
