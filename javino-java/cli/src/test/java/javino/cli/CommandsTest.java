package javino.cli;

import javino.keyring.PrivateFile;
import javino.keyring.SharedKey;
import javino.keyring.Keyring;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicBoolean;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.BoardState;
import javino.fake.FakeBoard;
import javino.protocol.Address;
import javino.protocol.Key;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

@Tag("newerJava")
@Timeout(60)
class CommandsTest {

    private static final Address SUPO = Address.parse("SUPO");
    private static final Key KEY = Key.ofHex("000102030405060708090a0b0c0d0e0f");

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private final FakeBoard fake = new FakeBoard();

    @TempDir
    private Path folder;

    private int run(String... args) {
        CommandLine commandLine = Main.commandLine(PortOption.serial());
        commandLine.setOut(new PrintWriter(out, true));
        commandLine.setErr(new PrintWriter(err, true));
        return commandLine.execute(args);
    }

    private Board open() {
        return Board.open(fake.port, BoardConfig.create(), new BoardListener() {});
    }

    private void assertFails(int code, String reason, String... args) {
        assertEquals(code, run(args));
        assertTrue(err.toString().startsWith("javino: "), err.toString());
        assertTrue(err.toString().contains(reason), err.toString());
        assertEquals(1, err.toString().lines().count(), err.toString());
    }

    private Path secret(String text) throws IOException, JavinoException {
        Path file = folder.resolve("keys");
        PrivateFile.create(file, text);
        return file;
    }

    @Test
    void keygen_pairsAndGroups_writesAKeyringForItsOwner() throws IOException {
        Path file = folder.resolve("keys");
        assertEquals(0, run("keygen", "--out", file.toString(), "--pair", "ROMA,SUPO", "--pair", "SUHO,SUPO",
                "--group", "SU"), err.toString());
        assertEquals(3, Keyring.read(file).keysOf(SUPO).values().stream().map(SharedKey::key).distinct().count());
        if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
        }
        assertFalse(out.toString()
                .contains(Keyring.read(file).keysOf(SUPO).values().iterator().next().key().bytes().hex()));
    }

    @ParameterizedTest
    @CsvSource({"--group SU,1 key", "--group SU --pair ROMA;SUPO,2 keys"})
    void keygen_each_countsItsKeys(String options, String count) {
        Path file = folder.resolve("keys");
        assertEquals(0, run(("keygen --out " + file + " " + options.replace(';', ',')).split(" ")), err.toString());
        assertEquals(count + " written to " + file + System.lineSeparator(), out.toString());
    }

    @Test
    void keygen_fileThere_leavesIt() throws IOException {
        Path file = Files.writeString(folder.resolve("keys"), "precious");
        assertFails(1, "already", "keygen", "--out", file.toString(), "--group", "SU");
        assertEquals("precious", Files.readString(file));
    }

    /**
     * In a folder that others may write to, somebody else takes the file away as soon as it is there, and lays out
     * another.
     */
    @Test
    void keygen_fileTakenAwayMeanwhile_writesNoKeyIntoWhatLiesThere() throws Exception {
        Path file = folder.resolve("keys");
        Path bait = Files.createFile(folder.resolve("bait"));
        AtomicBoolean going = new AtomicBoolean(true);
        Thread thief = new Thread(() -> {
            while (going.get()) {
                try {
                    if (Files.exists(file, LinkOption.NOFOLLOW_LINKS) && !Files.isSymbolicLink(file)) {
                        Files.delete(file);
                        Files.createSymbolicLink(file, bait);
                    }
                } catch (IOException e) {
                    // The other was quicker.
                    continue;
                }
            }
        });
        thief.start();
        try {
            for (int i = 0; i < 30; i++) {
                Files.deleteIfExists(file);
                run("keygen", "--out", file.toString(), "--group", "SU");
            }
        } finally {
            going.set(false);
            thief.join();
        }
        assertEquals("", Files.readString(bait));
    }

    @Test
    void keygen_linkThere_isNotFollowed() throws IOException {
        Path target = folder.resolve("target");
        Path link = Files.createSymbolicLink(folder.resolve("keys"), target);
        assertFails(1, "already", "keygen", "--out", link.toString(), "--group", "SU");
        assertFalse(Files.exists(target));
    }

    @Test
    void keygen_nothingToMake_isWrongUsage() {
        assertFails(2, "--pair or --group", "keygen", "--out", folder.resolve("keys").toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = ' ', value = {
            "--pair ROMA,SU characters", "--pair ROMA,ROM characters", "--pair ROMA ROMA,SUPO",
            "--pair ROMA,SUPO,SUHO ROMA,SUPO",
            "--pair ROMA,ROMA different", "--pair ROMA,//SU different", "--group S characters",
            "--group //SU characters",
            "--group // characters"
    })
    void keygen_badAddress_isWrongUsage(String option, String value, String reason) {
        assertFails(2, reason, "keygen", "--out", folder.resolve("keys").toString(), option, value);
        assertFalse(Files.exists(folder.resolve("keys")));
    }

    @Test
    void keygen_samePairTwice_isWrongUsage() {
        assertFails(2, "two keys for ROMA SUPO", "keygen", "--out", folder.resolve("keys").toString(),
                "--pair", "ROMA,SUPO", "--pair", "SUPO,ROMA");
    }

    @Test
    void keygen_noFolder_namesIt() {
        Path missing = folder.resolve("missing");
        assertFails(1, "there is no folder " + missing, "keygen", "--out", missing.resolve("keys").toString(),
                "--group", "SU");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "send --port fake SUPO hello     | CONTENT: 'hello' has no performative: write 'tell;hello'",
            "send --port fake SUP tell;help  | TO: an address has 4 characters of A-Z a-z 0-9 + /, but \"SUP\" has 3",
            "send --port fake                | missing: TO",
            "provision                       | missing: --port PORT, --id ADDRESS",
            "keygen                          | missing: --out FILE or --renew FILE",
            "info --port                     | missing: --port PORT"})
    void usage_wrong_isToldInTheWordsOfTheHelp(String line, String reason) {
        assertFails(2, "javino: " + reason, line.split(" "));
    }

    @ParameterizedTest
    @CsvSource(delimiter = ' ', value = {"SUP characters", "//SU device", "++++ device", "S!PO '!'"})
    void provision_badId_isWrongUsage(String id, String reason) {
        assertFails(2, reason.replace("'", ""), "provision", "--port", "nowhere", "--id", id);
    }

    @ParameterizedTest
    @ValueSource(strings = {"ROM=key", "////=key", "ROMA"})
    void provision_badKeyOption_isWrongUsage(String key) {
        assertFails(2, "--key", "provision", "--port", "nowhere", "--id", "SUPO", "--key", key);
    }

    @Test
    void provision_keyringWithoutItsKey_saysWhichItHas() throws IOException, JavinoException {
        Path file = secret("ROMA SUPO = " + KEY.bytes().hex() + "\n//SU = " + KEY.bytes().hex() + "\n");
        assertFails(1, file + " has no key for ROMB; it has ROMA, SUPO, //SU", "provision", "--port", "nowhere",
                "--id", "ROMB", "--keyring", file.toString());
    }

    @Test
    void provision_emptyKeyring_saysSo() throws IOException, JavinoException {
        Path file = secret("");
        assertFails(1, "it has none at all", "provision", "--port", "nowhere", "--id", "ROMB",
                "--keyring", file.toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"SUP", "////", "++++"})
    void forget_badAddress_isWrongUsage(String address) {
        assertFails(2, "--key", "forget", "--port", "nowhere", "--key", address);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "--key SUPO --all"})
    void forget_notOneKind_isWrongUsage(String options) {
        List<String> arguments = new ArrayList<>(List.of("forget", "--port", "nowhere"));
        arguments.addAll(Arrays.stream(options.split(" ")).filter(option -> !option.isEmpty()).toList());
        assertFails(2, "--all", arguments.toArray(String[]::new));
    }

    @Test
    void ports_some_areSortedAndNamedAsTheyStay() throws IOException {
        Path device = Files.createFile(folder.resolve("ttyACM0"));
        Path names = Files.createDirectory(folder.resolve("by-id"));
        Path stable = Files.createSymbolicLink(names.resolve("usb-Arduino"), device);
        PrintWriter lines = new PrintWriter(out, true);
        PortsCommand.print(new TreeMap<>(Map.of("/dev/ttyS0", "Physical Port", device.toRealPath().toString(), "Mega")),
                PortsCommand.stableNames(names), lines);
        assertEquals(List.of("/dev/ttyS0  Physical Port", device.toRealPath() + "  Mega  " + stable).stream().sorted()
                .toList(), out.toString().lines().toList());
    }

    @Test
    void ports_none_saysWhatToDo() throws IOException {
        PortsCommand.print(new TreeMap<>(), PortsCommand.stableNames(folder.resolve("missing")),
                new PrintWriter(out, true));
        assertTrue(out.toString().startsWith("no serial port found: plug a board in"), out.toString());
    }

    @Test
    void ports_here_endsWell() {
        assertEquals(0, run("ports"), err.toString());
    }

    @Test
    void port_boardThere_opens() throws JavinoException, InterruptedException {
        try (Board board = new PortOption(name -> fake.port, BoardConfig.create(), Path.of("none")).open()) {
            assertEquals(BoardState.ONLINE, board.state());
        }
    }

    @Test
    void port_noBoardAnswers_saysSo() {
        fake.line.setSilent(true);
        BoardConfig config = BoardConfig.create(builder -> builder.setPatience(Duration.ofMillis(50)));
        JavinoException e = assertThrows(JavinoException.class,
                () -> new PortOption(name -> fake.port, config, Path.of("none")).open());
        assertTrue(e.getMessage().contains("no Javino board answers"), e.getMessage());
    }

    @Test
    void main_alone_listsItsSubcommands() {
        assertEquals(2, run());
        for (String command : List.of("act", "doctor", "forget", "import", "info", "keygen", "monitor", "new",
                "percepts",
                "ports",
                "provision", "send")) {
            assertTrue(err.toString().contains(command), err.toString());
        }
    }

    @ParameterizedTest
    @CsvSource({
            "inf --port x,there is no command inf; did you mean info? (try --help)",
            "ports --hepl,there is no option --hepl; did you mean --help? (try --help)",
            "ports here,there is no place for here (try --help)",
            "--nope,there is no option --nope",
    })
    void main_wordTooMuch_isNamed(String arguments, String reason) {
        assertFails(2, "javino: " + reason, arguments.split(" "));
    }

    @Test
    void main_summaries_endWithAFullStop() {
        run("--help");
        String commands = out.toString().split("Commands:")[1];
        assertTrue(commands.lines().noneMatch(line -> line.stripTrailing().endsWith(":")), commands);
    }

    @Test
    void provision_noKeyring_failsBeforeItOpensThePort() {
        assertFails(1, "no such file", "provision", "--port", "nowhere", "--id", "SUPO",
                "--keyring", folder.resolve("keys").toString());
    }

    @Test
    void provision_badKeyFile_namesIt() throws IOException, JavinoException {
        Path file = secret("secret");
        assertFails(1, "32 hexadecimal digits", "provision", "--port", "nowhere", "--id", "SUPO",
                "--key", "ROMA=" + file);
        assertFalse(err.toString().contains("secret"), err.toString());
    }

    @Test
    void info_noPort_saysWhy() {
        String nowhere = folder.resolve("nowhere").toString();
        assertFails(1, "javino: " + nowhere + ": there is no such port", "info", "--port", nowhere);
    }

    @Test
    void main_noPortOption_isWrongUsage() {
        assertFails(2, "--port", "info");
    }
}
