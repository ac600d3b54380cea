package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AgentProcess;
import harness.Certificates;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.Transmitter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import keyagreement.BoardKeyAgreement;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A group whose boards have certificates only: its key comes from SUKE. Some boards lose their EEPROM. */
@InEmulatedTime
class GroupKeyTest {

    private static final String AGENT = """
            !start.
            +!start <- .port("@PORT@"); .setMyRFId("@ID@"); .getRFMessages(open); .print("ready"); @THEN@.
            -!start[error(outcome_unknown)] <- !start.
            +!tell(X) <- .diffuse("//SU", tell, hello(X)); .print("told ", X).
            -!tell(X) <- !tell(X).
            +!say(X) <- .diffuse("//SU", tell, hello(X)); .wait(3000); !say(X).
            -!say(X) <- .wait(1000); !say(X).
            +hello(X)[cast(multicast, S)] <- .print("heard ", X, " from ", S).
            """;
    private static final Map<String, String> IDS = Map.of("server", "SUKE", "police", "SUPO");
    private static final String GROUP = "//SU";
    private static final int NONCE_AT = 10;
    private static final int NONCE_END = 16;

    @TempDir
    private Path folder;
    private Path identities;
    private Emulator emulator;

    private AgentProcess start(String board, String then) throws IOException {
        Files.writeString(folder.resolve(board + ".asl"), AGENT.replace("@PORT@", emulator.port(board))
                .replace("@ID@", IDS.get(board)).replace("@THEN@", then));
        return AgentProcess.run(board, folder, List.of("-D" + BoardKeyAgreement.FOLDER_PROPERTY + "=" + identities));
    }

    private static Emulator.Scenario scenario() {
        return new Emulator.Scenario().board("server", "Station").board("police", "Station")
                .board("thief", "Transmitter");
    }

    private void erase(String board) throws IOException {
        Files.delete(folder.resolve("eeprom/" + board + ".bin"));
    }

    /** The police speaks to the group; what was sealed for that. */
    private List<byte[]> tell(int what) throws Exception {
        try (AgentProcess server = start("server", "true")) {
            server.await("ready");
            try (AgentProcess police = start("police", "!tell(" + what + ")")) {
                police.await("told " + what);
                server.await("heard " + what + " from SUPO");
            }
        }
        List<byte[]> sent = emulator.sentBy("police").stream().map(event -> event.bytes("payload"))
                .filter(packet -> new String(packet, 0, 4, StandardCharsets.US_ASCII).equals(GROUP)).toList();
        assertFalse(sent.isEmpty());
        return sent;
    }

    private static Set<String> nonces(List<byte[]> packets) {
        return packets.stream().map(packet -> HexFormat.of().formatHex(packet, NONCE_AT, NONCE_END))
                .collect(Collectors.toSet());
    }

    private String groupsKey(String board) throws Exception {
        try (Host opened = Host.of(emulator, board)) {
            return Host.get(opened.board.keys()).stream().filter(key -> key.address().toString().equals(GROUP))
                    .map(key -> key.check().hex()).findFirst().orElse("none");
        }
    }

    @Test
    @Tag("verify")
    void boardThatWasErased_getsAnotherKeyAndNoNonceAgain_andNoRecordingIsTaken() throws Exception {
        identities = folder.resolve("identities");
        List<byte[]> first;
        String key;
        try (Emulator started = scenario().start(folder)) {
            emulator = started;
            Certificates authority = new Certificates(folder, "authority");
            authority.enroll("SUKE", identities, "--group-key-server");
            authority.enroll("SUPO", identities);
            first = tell(1);
            key = groupsKey("police");
        }
        assertTrue(Files.readString(identities.resolve("SUPO.note")).contains(GROUP + " " + key));

        erase("police");
        List<byte[]> second;
        try (Emulator started = scenario().start(folder)) {
            emulator = started;
            second = tell(2);
            assertFalse(groupsKey("police").equals(key), "a member gets no key again that it has lost");
            assertEquals(groupsKey("server"), groupsKey("police"));
        }
        Set<String> again = nonces(first);
        again.retainAll(nonces(second));
        assertEquals(Set.of(), again);

        erase("server");
        try (Emulator started = scenario().start(folder)) {
            emulator = started;
            try (AgentProcess server = start("server", "true");
                    AgentProcess police = start("police", "!say(3)");
                    Transmitter thief = Transmitter.of(started, "thief")) {
                server.await("heard 3 from SUPO");
                for (byte[] packet : second) {
                    thief.send(packet);
                }
                police.await("ready");
                assertTrue(server.lines().stream().noneMatch(line -> line.contains("heard 2")),
                        server.lines().toString());
            }
        }
    }
}
