package javino.cli;

import javino.keyring.KeyringNotes;
import javino.keyring.PrivateFile;
import javino.keyring.BoardNote;
import javino.keyring.BoardNotes;
import javino.keyring.BoundedClock;
import javino.keyring.HeldKeys;
import javino.keyring.SharedKey;
import javino.keyring.Keyring;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.fake.FakeBoard;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Status;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Three boards, each at the port of its name, and one keyring. */
@Timeout(120)
class ProvisionCommandTest {

    private static final List<String> IDS = List.of("SUPO", "SUPP", "ROMA");

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private final Map<String, FakeBoard> boards = new TreeMap<>();

    private BoundedClock clock = BoundedClock.SYSTEM;

    @TempDir
    private Path folder;
    private Path keys;

    @BeforeEach
    void makeBoards() {
        for (String id : IDS) {
            boards.put(id, new FakeBoard());
            boards.get(id).keys.setEpoch(1);
        }
        keys = folder.resolve("keys");
        succeed("keygen", "--out", keys.toString(), "--pair", "ROMA,SUPO", "--pair", "SUPO,SUPP", "--group", "SU");
    }

    private int run(String... args) {
        CommandLine commandLine = Main.commandLine(PortOption.factory(name -> boards.get(name).port,
                BoardConfig.create(), clock));
        commandLine.setOut(new PrintWriter(out, true));
        commandLine.setErr(new PrintWriter(err, true));
        return commandLine.execute(args);
    }

    private List<String> succeed(String... args) {
        out.getBuffer().setLength(0);
        assertEquals(0, run(args), err.toString());
        return out.toString().lines().toList();
    }

    private String fail(String... args) {
        err.getBuffer().setLength(0);
        assertEquals(1, run(args), out.toString());
        assertEquals(1, err.toString().lines().count(), err.toString());
        return err.toString().strip();
    }

    private String[] provisionOf(String id) {
        return new String[] {"provision", "--port", id, "--id", id, "--keyring", keys.toString()};
    }

    private List<String> provision(String id) {
        return succeed(provisionOf(id));
    }

    private List<String> provisionAll() {
        return IDS.stream().flatMap(id -> provision(id).stream()).toList();
    }

    private Keyring keyring() throws Exception {
        return Keyring.read(keys);
    }

    private String check(String device, String with) throws Exception {
        return keyring().keyOf(Address.parse(device), Address.parse(with)).orElseThrow().key().check().hex();
    }

    private long performed(String id, String what) {
        return boards.get(id).requests.stream().filter(each -> each.startsWith(what)).count();
    }

    @Test
    void provision_newBoard_getsEpochIdAndKeysAndIsNoted() throws Exception {
        assertEquals(List.of("RF id SUPO", "key for ROMA, check value " + check("SUPO", "ROMA"),
                "key for SUPP, check value " + check("SUPO", "SUPP"),
                "key for //SU, check value " + check("SUPO", "//SU")),
                provision("SUPO"));
        List<String> performed = List.copyOf(boards.get("SUPO").requests);
        assertTrue(performed.get(0).startsWith("epoch "), performed.toString());
        assertEquals(List.of("id SUPO", "key ROMA", "key SUPP", "key //SU"), performed.subList(1, performed.size()));
        BoardNote note = keyring().note(Address.parse("SUPO"));
        assertEquals(boards.get("SUPO").keys.epoch(), note.epoch());
        assertEquals("[ROMA, SUPP, //SU]", note.keys().keySet().toString());
        assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(keys)));
    }

    @Test
    void provision_thatEndedHalfWayAndErased_putsNoKeyBack() throws Exception {
        boards.get("SUPO").refuse("key //SU", Status.STORE_FULL, 1);
        fail(provisionOf("SUPO"));
        assertEquals("[ROMA, SUPP]", keyring().note(Address.parse("SUPO")).keys().keySet().toString());
        boards.get("SUPO").eraseEeprom();
        boards.get("SUPO").reset();
        String refused = fail(provisionOf("SUPO"));
        assertTrue(refused.contains("the board has lost keys that SUPO was given (for ROMA, SUPP)"), refused);
    }

    @Test
    void provision_boardWithSessionKeys_takesThemForNoKeys() throws Exception {
        provision("SUPO");
        boards.get("SUPO").keys.setSession("CAFE", Bytes.of(4, 5, 6));
        assertEquals(List.of("RF id SUPO", "key for ROMA, check value " + check("SUPO", "ROMA"),
                "key for SUPP, check value " + check("SUPO", "SUPP"),
                "key for //SU, check value " + check("SUPO", "//SU")),
                provision("SUPO"));
        assertEquals("[ROMA, SUPP, //SU]", keyring().note(Address.parse("SUPO")).keys().keySet().toString());
    }

    @Test
    void provision_again_changesNoKey() throws Exception {
        provision("SUPO");
        String before = Files.readString(keys).replaceAll("epoch [0-9]+", "");
        provision("SUPO");
        assertEquals(before, Files.readString(keys).replaceAll("epoch [0-9]+", ""));
    }

    @Test
    void provision_keyringOfBefore_works() throws Exception {
        assertFalse(Files.readString(keys).contains(":"), "keygen writes just the keys");
        provisionAll();
        assertEquals(3, Files.readString(keys).lines().filter(line -> line.contains(": epoch ")).count());
    }

    private void provisionAt(Instant now) throws Exception {
        out.getBuffer().setLength(0);
        err.getBuffer().setLength(0);
        clock = BoundedClock.at(now);
        if (run(provisionOf("SUPO")) != 0) {
            throw new JavinoException(err.toString());
        }
    }

    @Test
    void epoch_byTheClock_isMinutes() throws Exception {
        provisionAt(Instant.parse("2026-11-22T12:30:00Z"));
        assertEquals((325 * 24 + 12) * 60 + 30, boards.get("SUPO").keys.epoch());
    }

    @Test
    void epoch_withoutAClock_isAboveAllThatTheBoardHad() throws Exception {
        provisionAt(Instant.parse("2026-02-01T00:00:00Z"));
        boards.get("SUPO").keys.setEpoch(60_000);
        provisionAt(Instant.EPOCH);
        assertEquals(60_000, keyring().note(Address.parse("SUPO")).epoch(), "its boots are noted too");
        boards.get("SUPO").keys.setEpoch(1);
        provisionAt(Instant.EPOCH);
        assertEquals(60_001, boards.get("SUPO").keys.epoch());
    }

    // ---- A board that claims too much, and one that has lost its epoch.

    private static final Instant AUTUMN = Instant.parse("2026-11-22T12:30:00Z");
    private static final int OF_AUTUMN = (325 * 24 + 12) * 60 + 30;

    private int noted(String id) throws Exception {
        return keyring().note(Address.parse(id)).epoch();
    }

    @Test
    void epoch_thatAFalseBoardClaims_isNotNotedBeforeItHasShownItsKeys() throws Exception {
        boards.get("SUPO").keys.setEpoch(0xFFFFFE);
        boards.get("SUPO").keys.corrupt();
        for (Instant now : List.of(Instant.EPOCH, AUTUMN)) {
            assertThrows(JavinoException.class, () -> provisionAt(now));
        }
        assertTrue(noted("SUPO") <= OF_AUTUMN, "only what it was to be given");
        FakeBoard genuine = new FakeBoard();
        genuine.keys.setEpoch(1);
        boards.put("SUPO", genuine);
        provisionAt(AUTUMN);
        assertEquals(OF_AUTUMN + 1, genuine.keys.epoch());
    }

    @Test
    void epoch_thatABoardClaims_isNeverNotedYearsAheadOfTheClock() throws Exception {
        boards.get("SUPO").keys.setEpoch(0xFFFFFE);
        provisionAt(AUTUMN);
        assertEquals(OF_AUTUMN, noted("SUPO"));
        int inFourYears = OF_AUTUMN + 4 * 365 * 24 * 60;
        boards.get("SUPO").keys.setEpoch(inFourYears);
        provisionAt(AUTUMN);
        assertEquals(inFourYears, noted("SUPO"));
    }

    @Test
    void epoch_thatIsNotedYearsAheadOfTheClock_isRefused() throws Exception {
        provisionAt(AUTUMN);
        Files.writeString(keys, Files.readString(keys).replace("epoch " + OF_AUTUMN, "epoch 16777214"));
        JavinoException refused = assertThrows(JavinoException.class, () -> provisionAt(AUTUMN));
        assertTrue(refused.getMessage().contains("had epoch 16777214, which is years ahead of this computer's clock"),
                refused.getMessage());
        assertEquals(OF_AUTUMN, boards.get("SUPO").keys.epoch());
    }

    @Test
    void epoch_thatWasLost_isRaisedAboveAllBootsSinceTheNote() throws Exception {
        provisionAt(AUTUMN);
        for (int loss = 1; loss <= 2; loss++) {
            boards.get("SUPO").keys.loseEpoch("SUPP", "//SU");
            out.getBuffer().setLength(0);
            provisionAt(AUTUMN);
            int above = OF_AUTUMN + loss * 400_000;
            assertEquals(above, boards.get("SUPO").keys.epoch());
            assertEquals(above, noted("SUPO"));
            assertTrue(out.toString().contains("it was raised to " + above + ", above all that it has had"),
                    out.toString());
            assertTrue(out.toString().contains("under its keys for SUPP, //SU"), out.toString());
        }
    }

    @Test
    void epoch_thatWasLostAndIsNotNoted_isNotGuessed() throws Exception {
        provisionAt(AUTUMN);
        Files.writeString(keys, Files.readString(keys).replaceAll("SUPO: .*", ""));
        boards.get("SUPO").keys.loseEpoch();
        JavinoException refused = assertThrows(JavinoException.class, () -> provisionAt(AUTUMN));
        assertTrue(refused.getMessage().contains("javino forget --port SUPO --all, then new keys"),
                refused.getMessage());
        assertEquals(0, boards.get("SUPO").keys.epoch());
        assertEquals(0, noted("SUPO"));
    }

    @Test
    void notes_forAnAgentsHost_raiseOnlyTheBoardThatHasTheKeys() throws Exception {
        provisionAt(AUTUMN);
        FakeBoard board = boards.get("SUPO");
        board.keys.loseEpoch();
        System.setProperty(KeyringNotes.PROPERTY, keys.toString());
        try {
            BoardConfig config = BoardConfig.create(each -> each.setNotes(BoardNotes.ofHost()));
            FakeBoard other = new FakeBoard();
            other.setRfId("SUPO");
            other.keys.set("SUPO", Bytes.of(1, 2, 3));
            other.keys.loseEpoch();
            try (Board session = Board.open(other.port, config, new BoardListener() {})) {
                assertTrue(session.greeted().get().hasLostEpoch());
            }
            assertEquals(OF_AUTUMN, noted("SUPO"));
            try (Board session = Board.open(board.port, config, new BoardListener() {})) {
                assertTrue(session.greeted().get().bootEpoch() >= OF_AUTUMN + 400_000);
            }
            assertEquals(board.keys.epoch(), noted("SUPO"));
        } finally {
            System.clearProperty(KeyringNotes.PROPERTY);
        }
    }

    @Test
    void keyThatWasReplaced_isNotPutBackByAnOlderKeyring() throws Exception {
        Path older = folder.resolve("older");
        Files.copy(keys, older, StandardCopyOption.COPY_ATTRIBUTES);
        provisionAll();
        succeed("keygen", "--renew", keys.toString());
        for (int i = 0; i < 3; i++) {
            provisionAll();
        }
        System.setProperty(KeyringNotes.PROPERTY, keys.toString());
        try {
            BoardConfig config = BoardConfig.create(each -> each.setNotes(BoardNotes.ofHost()));
            CommandLine line = Main.commandLine(PortOption.factory(name -> boards.get(name).port, config, clock));
            line.setOut(new PrintWriter(out, true));
            line.setErr(new PrintWriter(err, true));
            assertEquals(1, line.execute("provision", "--port", "SUPO", "--id", "SUPO", "--keyring",
                    older.toString()));
            assertTrue(err.toString().contains("the board has lost the key for "), err.toString());
        } finally {
            System.clearProperty(KeyringNotes.PROPERTY);
        }
    }

    @Test
    void clock_yearsAhead_isNotBelievedBeforeAPersonSaysSo() throws Exception {
        clock = BoundedClock.at(Instant.parse("2046-11-30T00:00:00Z"));
        assertEquals("javino: this computer's clock says 2046-11-30, more than 20 years after this release of Javino; "
                + "set it, or say --clock-is-right", fail(provisionOf("SUPO")));
        assertEquals(List.of(), List.copyOf(boards.get("SUPO").requests), "nothing is asked of the board");
        succeed(Stream.concat(Stream.of(provisionOf("SUPO")), Stream.of("--clock-is-right")).toArray(String[]::new));
        assertTrue(boards.get("SUPO").keys.epoch() > 10_900_000);
    }

    @Test
    void clock_atTheEndOfTime_leavesTheBoardEpochs() throws Exception {
        clock = BoundedClock.at(Instant.parse("2090-01-01T00:00:00Z"));
        succeed(Stream.concat(Stream.of(provisionOf("SUPO")), Stream.of("--clock-is-right")).toArray(String[]::new));
        assertEquals(0xFFFFFE - 0x100000, boards.get("SUPO").keys.epoch());
    }

    @Test
    void board_withoutNonces_beginsAnewWithNewKeysOnly() throws Exception {
        provisionAll();
        boards.get("SUPO").keys.setEpoch(0xFFFFFF);
        Files.writeString(keys, Files.readString(keys).replaceAll("SUPO: epoch [0-9]+", "SUPO: epoch 16777214"));
        assertTrue(fail(provisionOf("SUPO")).contains("nonces are used up, and it seals nothing: clear its EEPROM"));
        boards.get("SUPO").eraseEeprom();
        assertTrue(fail(provisionOf("SUPO")).contains("the board has lost keys"));
        succeed("keygen", "--renew", keys.toString(), "--id", "SUPO");
        for (int round = 0; round < 3; round++) {
            for (String id : List.of("SUPP", "ROMA", "SUPO")) {
                run(provisionOf(id));
            }
        }
        int epoch = boards.get("SUPO").keys.epoch();
        assertTrue(epoch < 10_900_000, "by the clock: " + epoch);
        assertEquals(epoch, noted("SUPO"));
    }

    @Test
    void board_withAnOlderImage_getsAnEpochAboveAllThatWasSeen() throws Exception {
        provisionAt(AUTUMN);
        Files.writeString(keys, Files.readString(keys).replace("epoch " + OF_AUTUMN, "epoch 600000"));
        provisionAt(AUTUMN);
        assertEquals(600_001, boards.get("SUPO").keys.epoch());
        assertTrue(out.toString().contains("its EEPROM was erased, or is an older copy"), out.toString());
    }

    @Test
    void provision_erasedBoard_isRefusedAndSaysWhatToDo() throws Exception {
        provisionAll();
        boards.get("SUPO").eraseEeprom();
        int before = boards.get("SUPO").requests.size();
        assertEquals(
                "javino: SUPO: the board has lost keys that SUPO was given (for ROMA, SUPP, //SU): its EEPROM was "
                        + "erased, "
                        + "they were deleted, or it is another board. With them it would take recordings of old "
                        + "messages for new "
                        + "ones. Make new keys: javino keygen --renew " + keys
                        + " --id SUPO, then javino provision on each board",
                fail(provisionOf("SUPO")));
        fail(provisionOf("SUPO"));
        assertEquals(List.of(), boards.get("SUPO").requests.stream().skip(before)
                .filter(each -> !each.startsWith("epoch")).toList(), "no key is written");
    }

    @Test
    void provision_erasedBoardAfterNewKeys_getsTheseAndNeverTheOld() throws Exception {
        provisionAll();
        int highest = keyring().note(Address.parse("SUPO")).epoch();
        List<String> old = List.of(check("SUPO", "ROMA"), check("SUPO", "SUPP"), check("SUPO", "//SU"));
        boards.get("SUPO").eraseEeprom();
        fail(provisionOf("SUPO"));
        succeed("keygen", "--renew", keys.toString(), "--id", "SUPO");
        for (int round = 0; round < 3; round++) {
            for (String id : List.of("SUPP", "ROMA", "SUPO")) {
                run(provisionOf(id));
            }
        }
        assertTrue(boards.get("SUPO").keys.epoch() > highest);
        for (SharedKey key : keyring().keysOf(Address.parse("SUPO")).values()) {
            assertEquals(null, key.next(), "the renewal is finished");
        }
        assertTrue(Stream.of(check("SUPO", "ROMA"), check("SUPO", "SUPP"), check("SUPO", "//SU"))
                .noneMatch(old::contains));
        assertEquals(0, performed("SUPO", "renew key"), "it had nothing to be renewed");
        assertEquals(1, performed("ROMA", "use key SUPO"));
        provisionAll();
    }

    @Test
    void provision_erasedInTheMiddleOfARenewal_isNotGivenTheNextKeyAgain() throws Exception {
        provisionAll();
        succeed("keygen", "--renew", keys.toString());
        provisionAll();
        boards.get("SUPO").eraseEeprom();
        assertTrue(fail(provisionOf("SUPO")).contains("has lost keys"));
        assertTrue(fail("keygen", "--renew", keys.toString(), "--id", "SUPO")
                .contains("is not finished; javino provision on"));
        for (String id : List.of("SUPP", "ROMA", "SUPP", "ROMA")) {
            provision(id);
        }
        succeed("keygen", "--renew", keys.toString(), "--id", "SUPO");
        for (String id : List.of("SUPP", "ROMA", "SUPO", "SUPP", "ROMA", "SUPP", "ROMA")) {
            run(provisionOf(id));
        }
        assertEquals(List.of(), keyring().keys().values().stream().filter(key -> key.next() != null).toList());
    }

    @Test
    void provision_anotherIdsBoard_isRefusedWithTheRemedy() {
        provisionAll();
        assertEquals(
                "javino: ROMA: the board holds pair keys of another id, ROMA (for SUPO); take the board of SUPP, or "
                        + "make "
                        + "this one it by javino forget --port ROMA --all first",
                fail("provision", "--port", "ROMA", "--id", "SUPP", "--keyring", keys.toString()));
        boards.get("ROMA").setRfId("SUPP");
        assertTrue(fail("provision", "--port", "ROMA", "--id", "SUPP", "--keyring", keys.toString())
                .contains("pair keys of another id, the key of ROMA SUPO"));
    }

    @Test
    void provision_sharedKeyring_isRefusedWithTheRemedy() throws Exception {
        Files.setPosixFilePermissions(keys, PosixFilePermissions.fromString("rw-r--r--"));
        assertEquals("javino: " + keys + ": others than you may read or write it; chmod 600 " + keys
                + "; if that changes nothing, move it to your home",
                fail(provisionOf("SUPO")));
        assertEquals(List.of(), List.copyOf(boards.get("SUPO").requests));
    }

    @Test
    void provision_keyFile_isGivenAndNoted() throws Exception {
        Path group = folder.resolve("group");
        PrivateFile.create(group,
                keyring().keyOf(Address.parse("SUPO"), Address.parse("//SU")).orElseThrow().key().bytes().hex());
        succeed("provision", "--port", "ROMA", "--id", "ROMA", "--keyring", keys.toString(), "--key", "//SU=" + group);
        assertTrue(keyring().boardsWith(Keyring.Members.group(Address.parse("//SU"))).contains(Address.parse("ROMA")));
        succeed("provision", "--port", "SUPP", "--id", "SUPP", "--key", "ROMA=" + group);
        Files.setPosixFilePermissions(group, PosixFilePermissions.fromString("rw-r--r--"));
        assertTrue(fail("provision", "--port", "SUPP", "--id", "SUPP", "--key", "ROMA=" + group).contains("chmod 600"));
    }

    @Test
    void provision_wrongCheckValue_fails() {
        boards.get("SUPO").keys.corrupt();
        assertTrue(fail(provisionOf("SUPO")).contains("the board has another key for ROMA"));
    }

    @Test
    void renewal_stepByStep_isFinished() throws Exception {
        provisionAll();
        String old = check("ROMA", "SUPO");
        assertEquals(
                List.of("new keys for ROMA SUPO, SUPO SUPP, //SU in " + keys
                        + "; now javino provision on each board, three times"),
                succeed("keygen", "--renew", keys.toString()));
        String next = keyring().keyOf(Address.parse("ROMA"), Address.parse("SUPO")).orElseThrow().next().check().hex();
        assertNotEquals(old, next);
        assertEquals(List.of("RF id ROMA", "next key for SUPO, check value " + next + ", accepted"), provision("ROMA"));
        provision("SUPO");
        provision("SUPP");
        assertEquals(List.of("RF id ROMA", "key for SUPO, check value " + next + ", in use"), provision("ROMA"));
        provision("SUPO");
        provision("SUPP");
        assertEquals(List.of("RF id ROMA", "previous key for SUPO, check value " + old + ", forgotten"),
                provision("ROMA"));
        assertTrue(provision("SUPO").contains("renewal of ROMA SUPO finished"));
        assertEquals(List.of("renewal of SUPO SUPP finished", "renewal of //SU finished"),
                provision("SUPP").stream().filter(line -> line.startsWith("renewal")).toList());
        assertEquals(next, check("ROMA", "SUPO"));
        assertFalse(Files.readString(keys).contains("next"));
        assertEquals(1, performed("SUPP", "finish renewal //SU"));
        provisionAll();
    }

    @Test
    void renewal_wrongOrder_isRefusedAndChangesNothing() throws Exception {
        provisionAll();
        succeed("keygen", "--renew", keys.toString());
        provision("SUPO");
        assertEquals(
                "javino: nothing can be done with SUPO yet: key for ROMA waits until ROMA accept the next one; key "
                        + "for SUPP "
                        + "waits until SUPP accept the next one; key for //SU waits until SUPP accept the next one; "
                        + "javino provision on "
                        + "these first",
                fail(provisionOf("SUPO")));
        assertEquals(0, performed("SUPO", "use key ROMA"));
        provision("SUPP");
        List<String> partly = provision("SUPO");
        assertTrue(partly.contains("key for ROMA waits until ROMA accept the next one"), partly.toString());
        assertEquals(1, performed("SUPO", "use key SUPP"), "what is due is done");
        assertEquals(0, performed("SUPO", "use key ROMA"));
        assertTrue(fail(provisionOf("SUPO")).contains("key for SUPP waits until SUPP seal with the next one"));
        assertEquals(0, performed("SUPO", "finish renewal SUPP"));
    }

    @Test
    void renewal_someKeys_leavesTheOthers() throws Exception {
        provisionAll();
        succeed("keygen", "--renew", keys.toString(), "--group", "SU");
        assertEquals(1, keyring().keys().values().stream().filter(key -> key.next() != null).count());
        assertTrue(fail("keygen", "--renew", keys.toString(), "--group", "SU")
                .contains("the renewal of //SU is not finished"));
        assertTrue(fail("keygen", "--renew", keys.toString(), "--group", "RO")
                .contains(keys + " has no key for //RO; it has ROMA"));
        assertEquals(2, run("keygen", "--out", folder.resolve("x").toString(), "--group", "SU", "--id", "SUPO"));
    }

    @Test
    void renewal_interrupted_isTakenUp() throws Exception {
        provisionAll();
        String before = Files.readString(keys);
        succeed("keygen", "--renew", keys.toString());
        String begun = Files.readString(keys);
        provision("SUPO");
        // The computer's power went before it was noted.
        Files.writeString(keys, begun);
        assertTrue(fail(provisionOf("SUPO")).contains("waits until"), "the board tells that it has accepted");
        assertEquals(3, performed("SUPO", "renew key"));
        // The keyring of before, from a copy: the next keys go.
        Files.writeString(keys, before);
        provision("SUPO");
        assertEquals(HeldKeys.NONE, keyring().note(Address.parse("SUPO")).held(Address.parse("SUHO")));
        assertEquals(null, keyring().note(Address.parse("SUPO")).held(Address.parse("ROMA")).next());
    }

    @Test
    void renewal_messageUnderWay_isWaitedFor() {
        provisionAll();
        succeed("keygen", "--renew", keys.toString(), "--pair", "ROMA,SUPO");
        provision("SUPO");
        provision("ROMA");
        boards.get("SUPO").refuse("use key", Status.BUSY, 3);
        assertTrue(provision("SUPO").stream().anyMatch(line -> line.endsWith("in use")));
    }

    @Test
    void doctor_duringARenewal_isContent() {
        provisionAll();
        succeed("keygen", "--renew", keys.toString());
        provisionAll();
        provisionAll();
        run("doctor", "--port", "SUPO", "--id", "SUPO", "--keyring", keys.toString(), "--listen", "0");
        assertEquals(3, out.toString().lines().filter(line -> line.startsWith("key ") && line.contains("ok, ")).count(),
                out.toString());
    }

    @Test
    void provision_keyringThatCannotBeChanged_failsBeforeTheBoardGetsAKey() throws Exception {
        try (FileChannel held = FileChannel.open(folder.resolve("keys.part"), StandardOpenOption.CREATE_NEW,
                StandardOpenOption.WRITE)) {
            held.lock();
            assertTrue(fail(provisionOf("SUPO")).contains("is being changed by another program; if none runs, delete"));
        }
        assertEquals(0, performed("SUPO", "key"));
    }

    @Test
    void provision_boardWithUnicastsOnly_refusesGroupsAndRenewalBeforeAnythingIsDone() {
        for (String id : IDS) {
            boards.get(id).setCapabilities(Capability.RADIO, Capability.MEMORY, Capability.UNICASTS_ONLY,
                    Capability.SAYS_TAKEN);
        }
        String group = fail(provisionOf("SUPO"));
        assertTrue(group.contains("nothing was changed for //SU: the board has neither groups"), group);
        assertTrue(group.endsWith("makes a JavinoRadioBoard in place of a JavinoUnicastBoard"), group);
        provision("ROMA");
        succeed("keygen", "--renew", keys.toString(), "--id", "ROMA");
        boards.get("ROMA").requests.clear();
        String renewal = fail(provisionOf("ROMA"));
        assertTrue(renewal.contains("changed for SUPO: "), renewal);
        for (String id : List.of("SUPO", "ROMA")) {
            assertTrue(boards.get(id).requests.stream().noneMatch(request -> request.matches("(id|key|.* key) .*")),
                    boards.get(id).requests.toString());
        }
    }
}
