package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.Transmitter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import javino.board.RequestFailedException;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.Reply;
import javino.protocol.Status;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two boards without a key in EEPROM, whose hosts set session keys. */
@InEmulatedTime
class SessionKeysTest {

    private static final Address SUPO = Address.parse("SUPO");
    private static final Address SUPP = Address.parse("SUPP");
    /** The places of keys and floors in EEPROM, by the library's README. */
    private static final int KEYS_AT = 799;
    private static final int FLOORS_END = 4043;
    private static final int PLACES = 8;

    @TempDir
    private Path folder;

    private Emulator emulator;
    private Transmitter thief;
    private Host police;
    private Host support;

    @BeforeEach
    void switchOn() throws Exception {
        emulator = new Emulator.Scenario().board("police", "Station").board("thief", "Transmitter")
                .board("support", "Station").start(folder);
        thief = Transmitter.of(emulator, "thief");
        police = Host.of(emulator, "police").as("SUPO", Map.of());
        support = Host.of(emulator, "support").as("SUPP", Map.of());
        police.awaitOnline(1);
        support.awaitOnline(1);
    }

    /** In none of the tests a key or a floor was ever written. */
    @AfterEach
    void switchOff() throws Exception {
        List.of(police, support).forEach(Host::close);
        thief.close();
        emulator.close();
        for (String board : List.of("police", "support")) {
            byte[] eeprom = Files.readAllBytes(folder.resolve("eeprom/" + board + ".bin"));
            byte[] erased = new byte[FLOORS_END - KEYS_AT];
            Arrays.fill(erased, (byte) 0xFF);
            assertEquals(HexFormat.of().formatHex(erased), HexFormat.of().formatHex(eeprom, KEYS_AT, FLOORS_END));
        }
    }

    private static Key key(int number) {
        return Key.ofHex(String.format("%032x", number));
    }

    private void agree(int number) {
        assertEquals(key(number).check(), Host.get(police.board.setSessionKey(SUPP, key(number))));
        assertEquals(key(number).check(), Host.get(support.board.setSessionKey(SUPO, key(number))));
    }

    private static Status refusal(Host host, Address device, Key key) {
        ExecutionException failed =
                assertThrows(ExecutionException.class, () -> Host.await(host.board.setSessionKey(device, key)));
        return ((RequestFailedException) failed.getCause()).status();
    }

    private void exchange(String prefix) throws Exception {
        assertEquals(Outcome.DELIVERED, police.send("SUPP", "tell;" + prefix + "1"));
        assertEquals("tell;" + prefix + "1", support.content());
        assertEquals(Outcome.DELIVERED, support.send("SUPO", "tell;" + prefix + "2"));
        assertEquals("tell;" + prefix + "2", police.content());
        String fragments = "tell;" + prefix + "3" + "x".repeat(100);
        assertEquals(Outcome.DELIVERED, police.send("SUPP", fragments));
        assertEquals(fragments, support.content());
    }

    /** Plays all that the police has sent so far; nothing of it may be handed to the support. */
    private void replay(int packets) throws Exception {
        for (int i = 0; i < packets; i++) {
            thief.send(HexFormat.of().parseHex(emulator.sentBy("police").get(i).text("payload")));
        }
        support.counter(Counter.RADIO_RECEIVED);
        assertEquals(List.of(), support.messages());
    }

    @Test
    @Tag("verify")
    void message_withoutAKey_isToldToTheHostAndDeliveredOnceBothHaveAKey() throws Exception {
        ExecutionException failed = assertThrows(ExecutionException.class,
                () -> Host.await(police.board.transmit(SUPP, Content.parse("tell;x")).taken()));
        assertEquals(Status.NO_KEY, ((RequestFailedException) failed.getCause()).status());
        Host.get(police.board.setSessionKey(SUPP, key(1)));
        assertEquals(Outcome.UNDELIVERED, police.send("SUPP", "tell;early"));
        assertEquals("SUPO", emulator.await("a frame without a key",
                event -> event.is("host-no-key", "support")).text("origin"));
        assertTrue(support.counter(Counter.RADIO_NO_KEY) > 0);
        Host.get(support.board.setSessionKey(SUPO, key(1)));
        exchange("a");
    }

    @Test
    void recording_ofASessionKey_isRefusedAlsoAfterAReset() throws Exception {
        agree(1);
        exchange("a");
        int recorded = emulator.sentBy("police").size();
        replay(recorded);

        emulator.command(Map.of("do", "reset", "board", "support"));
        support.awaitOnline(1);
        assertEquals(List.of(), Host.get(support.board.keys()), "gone at a boot");
        Host.get(support.board.radio(true));
        replay(recorded);
        assertTrue(support.counter(Counter.RADIO_NO_KEY) > 0);

        assertEquals(List.of(new Reply.StoredKey(SUPP, Reply.Role.SESSION, key(1).check())),
                Host.get(police.board.keys()));
        agree(2);
        exchange("b");
        replay(recorded);
        assertEquals(Status.BAD_ARGUMENT, refusal(police, SUPP, key(1)));
    }

    @Test
    void sessionKeys_moreThanPlaces_takeThatOfTheOneUsedLeastRecently() throws Exception {
        agree(1);
        for (int i = 2; i <= PLACES; i++) {
            Host.get(police.board.setSessionKey(Address.parse("ROM" + (char) ('A' + i)), key(i)));
        }
        exchange("a");
        Host.get(police.board.setSessionKey(Address.parse("ROMZ"), key(100)));
        List<String> held = Host.get(police.board.keys()).stream().map(key -> key.address().toString()).toList();
        assertEquals(PLACES, held.size());
        assertTrue(held.contains("SUPP"), held.toString());
        assertTrue(held.contains("ROMZ") && !held.contains("ROMC"), held.toString());
        exchange("b");
    }
}
