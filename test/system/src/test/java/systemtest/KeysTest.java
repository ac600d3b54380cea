package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.Transmitter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Supplier;
import javino.board.RequestFailedException;
import javino.cli.JavinoCommand;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.Status;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Three emulated Megas of a group, and their keys. */
@InEmulatedTime
class KeysTest {

    private static final Map<String, String> IDS = new LinkedHashMap<>();
    static {
        IDS.put("police", "SUPO");
        IDS.put("support", "SUPP");
        IDS.put("hospital", "SUHO");
    }

    private static final int NONCE_AT = 10;
    private static final int NONCE_END = 16;
    private static final double BUSY_PAUSE_SECONDS = 0.1;

    @TempDir
    private Path folder;

    private Emulator.Scenario scenario() {
        Emulator.Scenario scenario = new Emulator.Scenario();
        IDS.keySet().forEach(board -> scenario.board(board, "Station"));
        return scenario;
    }

    // ---- A board whose EEPROM is erased.

    private List<String> provision(Emulator emulator, String board) {
        return JavinoCommand.run("provision", "--port", emulator.port(board), "--id", IDS.get(board), "--keyring",
                folder.resolve("keys").toString());
    }

    private static void assertDone(List<String> lines) {
        assertEquals("0", lines.get(lines.size() - 1), lines.toString());
    }

    /** Each sends a unicast to each, and a multicast; all must arrive. */
    private static void exchange(Emulator emulator, String prefix) throws InterruptedException {
        Map<String, Host> hosts = new LinkedHashMap<>();
        try {
            for (String board : IDS.keySet()) {
                hosts.put(board, Host.of(emulator, board).listen());
            }
            for (String from : IDS.keySet()) {
                for (String to : IDS.keySet()) {
                    String text = "tell;" + prefix + from + to;
                    hosts.get(from).send(from.equals(to) ? "//SU" : IDS.get(to), text);
                    for (String at : IDS.keySet()) {
                        if (at.equals(from) || !to.equals(from) && !at.equals(to)) {
                            continue;
                        }
                        assertEquals(text, hosts.get(at).content());
                    }
                }
            }
        } finally {
            hosts.values().forEach(Host::close);
        }
    }

    private List<byte[]> record(Emulator emulator) {
        return IDS.keySet().stream().flatMap(board -> emulator.sentBy(board).stream())
                .map(event -> event.bytes("payload")).toList();
    }

    /** The nonces that an origin has used, whatever for. */
    private static Set<String> noncesOf(String origin, List<byte[]> packets) {
        Set<String> nonces = new HashSet<>();
        for (byte[] packet : packets) {
            boolean sealed = packet.length > NONCE_END && packet[0] != '+'
                    && new String(packet, 4, 4, java.nio.charset.StandardCharsets.US_ASCII).equals(origin);
            if (sealed) {
                nonces.add(HexFormat.of().formatHex(packet, NONCE_AT, NONCE_END));
            }
        }
        return nonces;
    }

    @Test
    @Tag("verify")
    void erasedBoard_getsNewKeysOnly_andNoRecordingIsTakenAndNoNonceComesTwice() throws Exception {
        String keys = folder.resolve("keys").toString();
        List<byte[]> recorded;
        try (Emulator emulator = scenario().start(folder)) {
            // In the time of the emulator, as all random numbers are.
            assertDone(JavinoCommand.run("keygen", "--out", keys, "--pair", "SUPO,SUPP", "--pair", "SUPO,SUHO",
                    "--pair", "SUPP,SUHO", "--group", "SU"));
            for (String board : IDS.keySet()) {
                assertDone(provision(emulator, board));
            }
            exchange(emulator, "a");
            recorded = record(emulator);
        }
        Files.delete(folder.resolve("eeprom/police.bin"));
        try (Emulator emulator = scenario().board("thief", "Transmitter").start(folder)) {
            List<String> refused = provision(emulator, "police");
            assertEquals("1", refused.get(refused.size() - 1));
            assertTrue(refused.get(0).contains("the board has lost keys that SUPO was given (for SUPP, SUHO, //SU)"),
                    refused.toString());
            assertDone(JavinoCommand.run("keygen", "--renew", keys, "--id", "SUPO"));
            // The police comes first and has to wait for the others; each of them takes three steps.
            List<String> early = provision(emulator, "police");
            assertTrue(early.get(early.size() - 2).contains("nothing can be done with SUPO yet"), early.toString());
            for (int round = 0; round < 3; round++) {
                for (String board : List.of("support", "hospital", "police")) {
                    provision(emulator, board);
                }
            }
            assertFalse(Files.readString(folder.resolve("keys")).contains("next"), "the renewal is finished");
            exchange(emulator, "b");
            replay(emulator, recorded);
            exchange(emulator, "c");

            List<byte[]> later = record(emulator);
            for (String id : IDS.values()) {
                Set<String> again = noncesOf(id, later);
                assertFalse(again.isEmpty());
                again.retainAll(noncesOf(id, recorded));
                assertEquals(Set.of(), again, id);
            }
        }
    }

    /** Plays all of it to boards whose radios are open; nobody may be handed anything. */
    private static void replay(Emulator emulator, List<byte[]> recorded) throws Exception {
        List<Host> hosts = new ArrayList<>();
        try (Transmitter thief = Transmitter.of(emulator, "thief")) {
            for (String board : IDS.keySet()) {
                hosts.add(Host.of(emulator, board).listen());
            }
            for (byte[] packet : recorded) {
                thief.send(packet);
            }
            for (Host host : hosts) {
                Host.get(host.board.statistics());
                assertEquals(List.of(), host.messages());
            }
        } finally {
            hosts.forEach(Host::close);
        }
    }

    // ---- Renewal, by hosts that speak all the while.

    private static final Key OLD = Key.of(Bytes.ofText("an old test key!"));
    private static final Key NEW = Key.of(Bytes.ofText("a new test key!!"));

    private final Map<String, Host> hosts = new LinkedHashMap<>();
    private final Map<String, CompletableFuture<Outcome>> unicasts = new LinkedHashMap<>();
    private final Map<String, Set<String>> expected = new LinkedHashMap<>();
    private int sent;

    private List<Address> partners(String board) {
        List<Address> partners = new ArrayList<>(List.of(Address.parse("//SU")));
        IDS.forEach((other, id) -> {
            if (!other.equals(board)) {
                partners.add(Address.parse(id));
            }
        });
        return partners;
    }

    /** A unicast to each other board, which are not waited for. */
    private void sendFrom(String board) throws Exception {
        for (String to : IDS.keySet()) {
            if (to.equals(board)) {
                continue;
            }
            String text = "tell;n" + sent++;
            unicasts.put(text, hosts.get(board).board.transmit(Address.parse(IDS.get(to)), Content.parse(text)).end());
            expected.computeIfAbsent(to, any -> new HashSet<>()).add(text);
        }
    }

    /** Asks again while a message is under way that is sealed with the key so far. */
    private static void take(Supplier<CompletableFuture<?>> step) throws Exception {
        while (true) {
            try {
                Host.await(step.get());
                return;
            } catch (ExecutionException e) {
                if (!(e.getCause() instanceof RequestFailedException refused) || refused.status() != Status.BUSY) {
                    throw e;
                }
                Host.pause(BUSY_PAUSE_SECONDS);
            }
        }
    }

    private void round(List<String> order, java.util.function.BiFunction<Host, Address, CompletableFuture<?>> step)
            throws Exception {
        for (String board : order) {
            for (String sender : IDS.keySet()) {
                sendFrom(sender);
            }
            for (Address partner : partners(board)) {
                take(() -> step.apply(hosts.get(board), partner));
            }
            multicastFrom(board);
        }
    }

    /** When all unicasts have ended: nobody acknowledges a multicast, so two that collide may be lost. */
    private void multicastFrom(String board) throws Exception {
        settle();
        String text = "tell;n" + sent++;
        assertEquals(Outcome.SENT, hosts.get(board).send("//SU", text));
        for (String to : IDS.keySet()) {
            if (!to.equals(board)) {
                assertEquals(text, hosts.get(to).content(), to);
            }
        }
    }

    private void settle() throws InterruptedException {
        unicasts.forEach((text, end) -> assertEquals(Outcome.DELIVERED, Host.get(end), text));
        unicasts.clear();
        for (Map.Entry<String, Set<String>> each : expected.entrySet()) {
            while (!each.getValue().isEmpty()) {
                String text = hosts.get(each.getKey()).content();
                assertTrue(each.getValue().remove(text), text + " came to " + each.getKey() + " unasked, or twice");
            }
        }
    }

    @Test
    @Tag("soak")
    void renewal_amongMessages_losesNone() throws Exception {
        try (Emulator emulator = scenario().start(folder)) {
            for (String board : IDS.keySet()) {
                Map<String, byte[]> keys = new LinkedHashMap<>();
                partners(board).forEach(partner -> keys.put(partner.toString(), OLD.bytes().toArray()));
                hosts.put(board, Host.of(emulator, board).as(IDS.get(board), keys));
            }
            round(List.of("police", "support", "hospital"), (host, with) -> host.board.renewKey(with, NEW));
            round(List.of("support", "hospital", "police"), (host, with) -> host.board.useKey(with));
            round(List.of("hospital", "police", "support"), (host, with) -> host.board.finishRenewal(with));
            for (String board : IDS.keySet()) {
                multicastFrom(board);
            }
            assertEquals(List.of(), hosts.values().stream().flatMap(host -> host.messages().stream()).toList());
        } finally {
            hosts.values().forEach(Host::close);
        }
    }
}
