package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.Transmitter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import javino.cli.JavinoCommand;
import javino.keyring.KeyringNotes;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Outcome;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/**
 * A short one of the sequences that {@code KeySequence} of key-agreement has in memory, on the firmware itself: boards
 * are erased and set back to a copy of their EEPROM, and provisioned from the keyring and from a copy of that.
 */
@InEmulatedTime
class KeySequenceTest {

    private static final Map<String, String> IDS = Map.of("police", "SUPO", "support", "SUPP");
    private static final List<String> BOARDS = List.of("police", "support");
    private static final int NONCE_AT = 10;
    private static final int NONCE_END = 16;
    private static final int MOST_REPLAYED = 8;

    @TempDir
    private Path folder;
    private final Random random = new Random(56);
    private final Map<String, String> sealed = new HashMap<>();
    private final Set<String> taken = new HashSet<>();
    private final List<byte[]> recorded = new ArrayList<>();
    private int said;

    @AfterEach
    void forget() {
        System.clearProperty(KeyringNotes.PROPERTY);
    }

    private static boolean isDone(List<String> lines) {
        return lines.get(lines.size() - 1).equals("0");
    }

    private Path file(String name) {
        return folder.resolve(name);
    }

    private Path eeprom(String board) {
        return folder.resolve("eeprom").resolve(board + ".bin");
    }

    private static void copy(Path from, Path to) throws Exception {
        Files.copy(from, to, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.COPY_ATTRIBUTES);
    }

    private boolean provision(Emulator emulator, String board, String keyring) {
        return isDone(JavinoCommand.run("provision", "--port", emulator.port(board), "--id", IDS.get(board),
                "--keyring", file(keyring).toString()));
    }

    @Test
    @Tag("verify")
    void boards_erasedSetBackAndProvisionedByOldKeyrings_repeatNoNonceAndTakeNothingTwice() throws Exception {
        System.setProperty(KeyringNotes.PROPERTY, file("keys").toString());
        live("keys");
        copy(file("keys"), file("older"));
        for (String board : BOARDS) {
            copy(eeprom(board), file(board));
        }
        live("keys");
        for (String step : List.of("restore", "erase", "restore", "restore")) {
            String board = BOARDS.get(random.nextInt(BOARDS.size()));
            if (step.equals("erase")) {
                Files.delete(eeprom(board));
            } else {
                copy(file(board), eeprom(board));
            }
            live(random.nextBoolean() ? "keys" : "older");
        }
        assertTrue(sealed.size() >= 2 * BOARDS.size(), "so many messages were sealed: " + sealed.size());
    }

    /** Boards get power and keys; agents' hosts send what they can; and all that was on the air is heard once more. */
    private void live(String keyring) throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("police", "Station").board("support", "Station")
                .board("thief", "Transmitter").start(folder); Transmitter thief = Transmitter.of(emulator, "thief")) {
            // In the time of the first emulator, as all random numbers are.
            boolean all = Files.exists(file("keys")) || isDone(JavinoCommand.run("keygen", "--out",
                    file("keys").toString(), "--pair", "SUPO,SUPP", "--group", "SU"));
            for (String board : BOARDS) {
                all &= provision(emulator, board, keyring);
            }
            // The refusal says what to do: new keys, and each board in turn, until all have them.
            if (!all && isDone(JavinoCommand.run("keygen", "--renew", file("keys").toString()))) {
                for (int turn = 0; turn < 3 * BOARDS.size(); turn++) {
                    provision(emulator, BOARDS.get(turn % BOARDS.size()), "keys");
                }
            }
            try (Host police = Host.noting(emulator, "police").listen();
                    Host support = Host.noting(emulator, "support").listen()) {
                for (Host from : List.of(police, support)) {
                    String to = from == police ? "SUPP" : "SUPO";
                    for (String address : List.of(to, "//SU")) {
                        // Whether it has a key or not.
                        CompletableFuture<Outcome> end = from.board.transmit(Address.parse(address), content()).end();
                        Host.get(end.handle((how, why) -> how));
                    }
                }
                for (byte[] packet : recorded.subList(Math.max(0, recorded.size() - MOST_REPLAYED),
                        recorded.size())) {
                    thief.send(packet);
                }
                for (Host host : List.of(police, support)) {
                    String board = host == police ? "police" : "support";
                    // The reply comes behind all messages that have come.
                    Host.get(host.board.statistics());
                    host.messages().forEach(message -> assertTrue(taken.add(board + " " + message.content()),
                            message + " came twice to " + board));
                }
            }
            see(emulator);
        }
    }

    private Content content() {
        return Content.parse("tell;x" + said++);
    }

    /** A board repeats a message byte by byte; with no other does a nonce come again. */
    private void see(Emulator emulator) {
        Map<String, String> here = new HashMap<>();
        for (String board : BOARDS) {
            for (TraceEvent sent : emulator.sentBy(board)) {
                byte[] packet = sent.bytes("payload");
                if (packet.length > NONCE_END && packet[0] != '+') {
                    String nonce = board + HexFormat.of().formatHex(packet, NONCE_AT, NONCE_END);
                    String before = here.put(nonce, sent.text("payload"));
                    assertEquals(before == null ? sent.text("payload") : before, sent.text("payload"), nonce);
                    recorded.add(packet);
                }
            }
        }
        here.forEach((nonce, packet) -> assertNull(sealed.put(nonce, packet), nonce + " came again"));
    }
}
