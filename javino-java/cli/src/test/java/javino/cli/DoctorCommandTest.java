package javino.cli;

import javino.keyring.PrivateFile;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import javino.JavinoException;
import java.util.stream.Stream;
import javino.protocol.Capability;
import javino.protocol.Counter;
import javino.protocol.Key;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DoctorCommandTest extends CommandFixture {

    private static final Key KEY = Key.ofHex("000102030405060708090a0b0c0d0e0f");
    private static final String PROVISION = "javino provision --port fake --id ";

    @TempDir
    private Path folder;

    /** A board that nothing is wrong with; it has a key for SUPO. */
    @BeforeEach
    void makeWell() {
        fake.setRfId("ROMA");
        fake.setCounter(Counter.RADIO_RECEIVED, 3);
    }

    private int examine(String... more) {
        return run(Stream.concat(Stream.of("doctor", "--port", "fake", "--listen", "0"), Stream.of(more))
                .toArray(String[]::new));
    }

    private Path keyring(String... lines) throws IOException, JavinoException {
        Path file = folder.resolve("keys");
        PrivateFile.create(file, String.join("\n", lines));
        return file;
    }

    /** The file in which Linux shows the latency timer of an FTDI chip at the port {@code device}. */
    private Path ftdi(String device, String millis) throws IOException {
        system = folder;
        Path timer = system.resolve("sys/bus/usb-serial/devices").resolve(device).resolve("latency_timer");
        Files.createDirectories(timer.getParent());
        return Files.writeString(timer, millis + "\n");
    }

    /** All was ok but for one thing, of which the line says this. */
    private void assertTrouble(String what, String remedy, String... options) {
        assertEquals(1, examine(options), err.toString());
        assertEquals("", err.toString());
        List<String> troubles = new ArrayList<>(lines());
        troubles.removeIf(line -> line.substring(20).startsWith("ok, "));
        assertEquals(1, troubles.size(), out.toString());
        assertEquals(what, troubles.get(0).substring(0, 20).strip());
        assertTrue(troubles.get(0).contains(remedy), troubles.get(0));
    }

    @Test
    void board_well_isOk() {
        assertEquals(0, examine("--id", "ROMA"), out.toString());
        List<String> expected = List.of("port                ok, fake", "board               ok, fake",
                "protocol            ok, version 1", "RF id               ok, ROMA", "keys                ok, 1",
                "nonces              ok, epoch 1 of 16777214");
        assertEquals(expected, lines().subList(0, expected.size()));
        assertTrue(lines().get(6).matches("serial line         ok, 0 of \\d+ packets were damaged"), out.toString());
        assertEquals("radio               ok, 3 packets received, 0 damaged", lines().get(7));
        assertEquals("airtime             ok, 0.0 % of the last hour, at most 0.0 % of one", lines().get(8));
        assertEquals(9, lines().size());
    }

    @Test
    void board_examined_isAskedButNotChanged() {
        examine();
        assertEquals(2, fake.line.count('L'), "after hello too");
        assertEquals(2, fake.line.count('S'), "after hello too");
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void port_missing_endsThere() {
        port.unplug();
        assertTrouble("port", "fake: there is no such port");
        assertEquals(1, lines().size());
    }

    @Test
    void board_silent_endsThere() {
        patience = Duration.ofMillis(50);
        fake.line.setSilent(true);
        assertTrouble("board", "no Javino board answers; is its sketch flashed, without a delay() in loop(), "
                + "and at the same baud rate?");
        assertEquals("port                ok, fake", lines().get(0));
        assertEquals(2, lines().size());
    }

    @Test
    void protocol_otherVersion_endsThere() {
        fake.setVersion(2);
        assertTrouble("protocol", "flash a sketch");
        assertEquals(3, lines().size());
    }

    @Test
    void protocol_older_saysWhatDoesNotWork() {
        assertEquals(1, run("doctor", "--port", "older"));
        assertEquals(List.of("port                ok, older",
                "board               ok, a sketch with the older Javino library",
                "protocol            older protocol: percepts and actions work, the radio does not; for that flash a "
                        + "sketch "
                        + "with the library JavinoBDI"),
                lines());
    }

    @Test
    void latency_short_isOk() throws IOException {
        Path timer = ftdi("fake", "1");
        assertEquals(0, examine(), out.toString());
        assertEquals(List.of("port                ok, fake", "latency             ok, 1 ms",
                "board               ok, fake"), lines().subList(0, 3));
        assertEquals("1\n", Files.readString(timer));
    }

    @ParameterizedTest
    @ValueSource(strings = {"2", "16", "255"})
    void latency_long_isShortened(String millis) throws IOException {
        Path timer = ftdi("fake", millis);
        assertEquals(0, examine(), out.toString());
        assertEquals("latency             ok, set from " + millis + " to 1 ms until the board is plugged in again; for "
                + "good by a udev rule (docs/errors.md)", lines().get(1));
        assertEquals("1", Files.readString(timer));
    }

    @Test
    void latency_portIsALink_isFollowed() throws IOException {
        Path timer = ftdi("ttyUSB7", "16");
        Path device = Files.createFile(folder.resolve("ttyUSB7"));
        Path name = Files.createSymbolicLink(folder.resolve("usb-FTDI"), Path.of("ttyUSB7"));
        Path alias = Files.createSymbolicLink(folder.resolve("robot"), name);
        assertEquals(0, run("doctor", "--port", alias.toString(), "--listen", "0"), out.toString());
        assertTrue(lines().get(1).startsWith("latency             ok, set from 16"), out.toString());
        assertEquals("1", Files.readString(timer));
        assertEquals(0, Files.size(device));
    }

    /** The kernel's own number stands for a timer that may not be written: even root cannot change it. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void latency_mayNotBeWritten_saysWhatToDo() throws IOException {
        Path number = Path.of("/proc/sys/kernel/cap_last_cap");
        Path timer = ftdi("fake", "16");
        Files.delete(timer);
        Files.createSymbolicLink(timer, number);
        assertTrouble("latency", "the port's FTDI chip holds bytes back for " + Files.readString(number).strip()
                + " ms; sudo setserial fake low_latency, or for good a udev rule (docs/errors.md)");
        Files.delete(timer);  // JUnit warns of links out of its folder
    }

    @Test
    void latency_boardSilent_isToldNevertheless() throws IOException {
        ftdi("fake", "1");
        patience = Duration.ofMillis(50);
        fake.line.setSilent(true);
        assertTrouble("board", "no Javino board answers");
        assertEquals("latency             ok, 1 ms", lines().get(1));
    }

    @Test
    void latency_portMissing_isLeftAlone() throws IOException {
        Path timer = ftdi("fake", "16");
        port.unplug();
        assertTrouble("port", "there is no such port");
        assertEquals("16\n", Files.readString(timer));
    }

    private void running(String... names) throws IOException {
        system = folder;
        for (int i = 0; i < names.length; i++) {
            Path process = Files.createDirectories(folder.resolve("proc/" + (100 + i)));
            Files.writeString(process.resolve("comm"), names[i] + "\n");
        }
        Files.createDirectories(folder.resolve("proc/sys"));
    }

    @Test
    void programs_boardThere_areNamed() throws IOException {
        running("init", "ModemManager", "brltty");
        assertEquals(0, examine(), out.toString());
        assertEquals("programs            ok, ModemManager runs, and may take the port; where there is no modem: sudo "
                + "systemctl disable --now ModemManager; brltty runs, and may take the port; where nobody reads "
                + "Braille: sudo apt-get remove brltty, and plug the board in anew", lines().get(1));
    }

    @Test
    void programs_portMissing_areATrouble() throws IOException {
        running("init", "brltty");
        port.unplug();
        assertEquals(1, examine(), out.toString());
        assertTrue(lines().get(1).startsWith("programs            brltty runs, and may take the port; "),
                out.toString());
    }

    @Test
    void programs_others_areNotNamed() throws IOException {
        running("init", "bash");
        assertEquals(0, examine(), out.toString());
        assertFalse(out.toString().contains("programs"), out.toString());
    }

    @Test
    void rfId_none_isToBeProvisioned() {
        fake.setRfId("++++");
        assertTrouble("RF id", "none; " + PROVISION + "ADDRESS --keyring FILE");
    }

    @Test
    void rfId_another_isTold() {
        assertTrouble("RF id", "ROMA instead of SUHO; another board, or " + PROVISION + "SUHO", "--id", "SUHO");
    }

    @Test
    void keys_none_areToBeProvisioned() {
        run("forget", "--port", "fake", "--all");
        out.getBuffer().setLength(0);
        assertTrouble("keys", "none, so that only broadcasts");
    }

    @Test
    void key_asInTheKeyring_isOk() throws IOException, JavinoException {
        fake.keys.set("SUPO", KEY.check());
        Path keys = keyring("ROMA SUPO = " + KEY.bytes().hex());
        assertEquals(0, examine("--id", "ROMA", "--keyring", keys.toString()), out.toString());
        assertTrue(lines().contains("key SUPO            ok, check value " + KEY.check()), out.toString());
        assertFalse(out.toString().contains(KEY.bytes().hex()));
    }

    @Test
    void key_other_tellsBothCheckValues() throws IOException, JavinoException {
        Path keys = keyring("ROMA SUPO = " + KEY.bytes().hex());
        assertTrouble("key SUPO", "check value 010203 instead of " + KEY.check() + "; " + PROVISION + "ROMA",
                "--id", "ROMA", "--keyring", keys.toString());
    }

    @Test
    void key_missing_isToBeProvisioned() throws IOException, JavinoException {
        fake.keys.set("SUPO", KEY.check());
        Path keys = keyring("ROMA SUPO = " + KEY.bytes().hex(), "//RO = " + KEY.bytes().hex());
        assertTrouble("key //RO", "missing; " + PROVISION + "ROMA", "--id", "ROMA", "--keyring", keys.toString());
    }

    @Test
    void keyring_withoutTheDevice_saysWhichItHas() throws IOException, JavinoException {
        Path keys = keyring("ROMA SUPO = " + KEY.bytes().hex());
        assertFails(1, keys + " has no key for SUHO; it has ROMA, SUPO", "doctor", "--port", "fake", "--id", "SUHO",
                "--keyring", keys.toString());
    }

    @Test
    void keyring_withoutId_isWrongUsage() {
        assertFails(2, "--keyring needs --id", "doctor", "--port", "fake", "--keyring", "keys");
    }

    @ParameterizedTest
    @ValueSource(strings = {"-1", "3601", "soon"})
    void listen_badTime_isWrongUsage(String seconds) {
        assertFails(2, "--listen", "doctor", "--port", "fake", "--listen", seconds);
    }

    @Test
    void nonces_usedUp_isTold() {
        fake.keys.setEpoch(0xFFFFFF);
        assertTrouble("nonces", "the epochs are used up");
    }

    @Test
    void nonces_lost_isToBeProvisioned() {
        fake.keys.loseEpoch();
        assertTrouble("nonces", "the board has lost its boot epoch: something has written over its EEPROM; it seals "
                + "nothing until javino provision has raised it by its keyring: " + PROVISION
                + "ADDRESS --keyring FILE");
    }

    @Test
    void nonces_belowTheNote_isTold() throws IOException, JavinoException {
        fake.keys.set("SUPO", KEY.check());
        fake.keys.setEpoch(7);
        Path keys = keyring("ROMA SUPO = " + KEY.bytes().hex(), "ROMA: epoch 470012, SUPO " + KEY.check().hex());
        assertTrouble("nonces", "epoch 7, but the keyring notes 470012 of ROMA: what it seals is refused; " + PROVISION
                + "ROMA", "--id", "ROMA", "--keyring", keys.toString());
        fake.keys.setEpoch(470_012);
        assertEquals(0, examine("--id", "ROMA", "--keyring", keys.toString()), out.toString());
    }

    @Test
    void floors_thatMayBeLost_areTold() {
        fake.keys.set("SUPO", KEY.check());
        fake.keys.loseEpoch("SUPO");
        fake.keys.setEpoch(8);
        assertTrouble("floors", "the board may have lost which messages it had under its keys for SUPO");
    }

    @Test
    void memory_thatDidNotHold_isTold() {
        fake.setCounter(Counter.MEMORY_DAMAGED, 1);
        assertTrouble("memory", "the sketch's stack, or a wild pointer, has written over the board's memory of nonces");
    }

    @Test
    void radioTimer_thatIsTaken_isTold() {
        fake.setTakenTimer(1);
        assertTrouble("timer", "another part of the sketch uses the radio's timer 1,");
    }

    @Test
    void serialLine_bootLoaderAnsweredFirst_isOk() {
        fake.line.setLoading();
        assertEquals(0, examine(), out.toString());
        assertTrue(lines().get(6).matches("serial line         ok, 0 of \\d+ packets were damaged"), out.toString());
    }

    @Test
    void serialLine_manyDamaged_isTold() {
        fake.setCounter(Counter.SERIAL_DAMAGED, 1000);
        assertTrouble("serial line", "1000 of ");
    }

    @Test
    void serialLine_manyDamagedAsTheLoopWaits_isLaidToTheSketch() {
        fake.setCounter(Counter.SERIAL_DAMAGED, 1000).setCounter(Counter.LOOP_MILLIS, 2000);
        assertEquals(1, examine(), out.toString());
        assertTrue(lines().get(6).startsWith("loop()              up to 2000 ms"), out.toString());
        assertTrue(lines().get(7).startsWith("serial line         1000 of "), out.toString());
        assertTrue(lines().get(7).contains("; first do what is said above of the sketch"), out.toString());
    }

    @Test
    void radio_nothingHeard_tellsWhereToLook() {
        fake.setCounter(Counter.RADIO_RECEIVED, 0);
        assertTrouble("radio", "nothing was heard in 0 s; if another board was sending");
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "3, 4"})
    void radio_moreDamagedThanReceived_isTold(int received, int damaged) {
        fake.setCounter(Counter.RADIO_RECEIVED, received);
        fake.setCounter(Counter.RADIO_DAMAGED, damaged);
        assertTrouble("radio", received + " packets received, " + damaged + " damaged; antenna");
    }

    @Test
    void radio_mostPacketsAreFragmentsOfAnotherLength_isTold() {
        fake.setCounter(Counter.RADIO_RECEIVED, 5).setCounter(Counter.RADIO_FRAGMENTS_DROPPED, 3);
        assertTrouble("radio", "5 packets received, 0 damaged, 3 fragments that do not fit; the same radio");
    }

    @Test
    void radio_heardWhileListening_isOk() throws Exception {
        fake.setCounter(Counter.RADIO_RECEIVED, 0);
        start("doctor", "--port", "fake", "--listen", "3600");
        await(out, written -> fake.line.count('S') > 1);
        fake.setCounter(Counter.RADIO_RECEIVED, 1);
        assertEquals(0, status());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "LOOP_MILLIS | 6 | loop() | up to 6 ms passed between two calls of run()",
            "PERCEPTS_MILLIS | 250 | percepts | up to 250 ms passed in the sketch's function of percepts",
            "ACTION_MILLIS | 1000 | actions | up to 1000 ms passed in a function of an action",
            "RADIO_LATE_MICROS | 1800 | interrupts | up to 1800 us passed before the radio was served"})
    void sketch_thatTakesItsTime_isTold(Counter counter, long time, String what, String remedy) {
        fake.setCounter(counter, time);
        assertTrouble(what, remedy);
    }

    @ParameterizedTest
    @CsvSource({"LOOP_MILLIS, 5", "PERCEPTS_MILLIS, 5", "ACTION_MILLIS, 5", "RADIO_LATE_MICROS, 200"})
    void sketch_thatReturnsSoon_isOk(Counter counter, long time) {
        fake.setCounter(counter, time);
        assertEquals(0, examine(), out.toString());
    }

    @Test
    void airtime_beyondWhatMostLawsAllow_isTold() {
        fake.setRise(Counter.RADIO_AIRTIME, 400);
        assertTrouble("airtime", "11.1 % of the last hour, at most 11.1 % of one; few laws allow more than 10 %: "
                + "send less, or give the sketch an airtime limit (docs/law-of-the-air.md)");
    }

    @Test
    void airtime_limitHoldsMessagesBack_isTold() {
        fake.setCounter(Counter.AIRTIME_WAIT, 3600);
        assertTrouble("airtime", "; its limit holds messages back for ");
        assertTrue(lines().toString().contains("; wait, or send less (docs/law-of-the-air.md)"), out.toString());
    }

    @Test
    void radio_nothingHeardWhileTheSketchTakesItsTime_doesNotBlameTheAntenna() {
        fake.setCounter(Counter.RADIO_RECEIVED, 0).setCounter(Counter.RADIO_LATE_MICROS, 5000);
        assertEquals(1, examine());
        assertTrue(out.toString().contains("radio               nothing was heard in 0 s; first do what is said above "
                + "of the sketch, which may be why"), out.toString());
        assertFalse(out.toString().contains("antenna"));
    }

    @Test
    void board_withoutRadio_isOk() {
        fake.setCapabilities(Capability.SAYS_TAKEN).setCounter(Counter.PERCEPTS_MILLIS, 200);
        assertEquals(0, examine(), out.toString());
        assertEquals(List.of("port                ok, fake", "board               ok, fake",
                "protocol            ok, version 1"), lines().subList(0, 3));
        assertTrue(lines().get(3).startsWith("serial line         ok, "), out.toString());
        assertEquals("radio               ok, none", lines().get(4));
        assertEquals(5, lines().size());
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void board_examined_readsItsSensorsFirst() {
        fake.perceive("dark");
        assertEquals(0, examine(), out.toString());
        List<String> messages = fake.line.messages();
        List<String> before = messages.subList(0, messages.lastIndexOf("53"));
        assertTrue(before.stream().anyMatch(message -> message.matches("50.[37b].*")), messages::toString);
    }

    @Test
    void board_withoutRadioThatTakesItsTime_isTold() {
        fake.setCapabilities(Capability.SAYS_TAKEN).setCounter(Counter.PERCEPTS_MILLIS, 201);
        assertTrouble("percepts", "up to 201 ms passed in the sketch's function of percepts");
    }

    @Test
    void board_withoutRadioThatShouldHaveAnId_isTold() {
        fake.setCapabilities(Capability.SAYS_TAKEN);
        assertTrouble("RF id", "none; the board has no radio", "--id", "ROMA");
    }

    @Test
    void doctor_perceptWithoutANumber_isNamed() {
        fake.setRfId("ROMA");
        fake.perceive("light(3)", "celsius(NaN)");
        assertTrouble("numbers", "percept celsius is left out: it is no number (NaN), as of a sensor that does not "
                + "answer");
    }

    @Test
    void prints_ofTheSketch_areShown() {
        fake.line.setPrints("t = 20.99\r\n");
        assertTrouble("prints", "the sketch prints on the serial line: \"t = 20.99\"; remove that print");
    }

    @Test
    void firmware_commandsForTheTerminal_areWritten() {
        fake.setFirmware("\033[2J");
        assertEquals(0, examine(), out.toString());
        assertTrue(lines().contains("board               ok, \\u001b[2J"), out.toString());
    }

    @Test
    void report_tellsVersionsAndCountersButNoAddressKeyOrPort() throws IOException {
        fake.setFirmware("blink 1.0");
        fake.setActions("ledOn", "ledOff");
        fake.setCounter(Counter.RADIO_RECEIVED, 0).setCounter(Counter.SERIAL_DAMAGED, 1);
        assertEquals(1, examine("--report"), err.toString());
        for (String line : List.of("Java                  " + System.getProperty("java.version"),
                "device                not known", "firmware              blink 1.0", "protocol version      1",
                "capabilities          radio, memory, says taken", "actions               2", "serialDamaged         1",
                "host greetings        1", "troubles              radio")) {
            assertTrue(lines().contains(line), line + " is not in " + out);
        }
        for (String secret : List.of("ROMA", "SUPO", "010203", "fake")) {
            assertFalse(out.toString().contains(secret), secret);
        }
    }

    @Test
    void report_tellsHowFeaturesHaveGoneOnARealBoard(@TempDir Path runs) throws IOException {
        Files.writeString(runs.resolve("real-board.txt"), "3 passed; steps not checked: 2\n");
        System.setProperty("javino.runs", runs.toString());
        try {
            assertEquals(0, examine("--report"), err.toString());
        } finally {
            System.clearProperty("javino.runs");
        }
        assertTrue(lines().contains("features              3 passed; steps not checked: 2"), out.toString());
    }

    @Test
    void report_ofASilentBoard_tellsVersions() {
        patience = Duration.ofMillis(50);
        fake.line.setSilent(true);
        assertEquals(1, examine("--report"));
        assertEquals(List.of("javino", "Java", "system", "device", "troubles"),
                lines().stream().map(line -> line.split(" ")[0]).toList());
        assertTrue(lines().contains("troubles              board"), out.toString());
    }

    @Test
    void report_ofKeys_namesNoDevice() throws IOException, JavinoException {
        Path keys = keyring("ROMA SUPO = " + KEY.bytes().hex());
        assertEquals(1, examine("--report", "--id", "ROMA", "--keyring", keys.toString()));
        assertTrue(lines().contains("troubles              key"), out.toString());
        assertFalse(out.toString().contains("SUPO"));
    }
}
