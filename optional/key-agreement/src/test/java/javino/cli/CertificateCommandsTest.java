package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.time.LocalDate;
import java.util.List;
import java.util.stream.Stream;
import javino.board.BoardConfig;
import javino.fake.OtherFileSystem;
import javino.keyring.BoundedClock;
import javino.link.SerialLink;
import javino.link.Time;
import javino.protocol.Address;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import keyagreement.Certificate;
import keyagreement.Identity;

/** {@code javino ca} and {@code javino enroll}, as users call them. */
@Tag("newerJava")
class CertificateCommandsTest {

    /** Of all commands of a test, so that none meets midnight. */
    private static final BoundedClock NOW = BoundedClock.at(Instant.now());

    private static final LocalDate TODAY = NOW.day();

    private final OtherFileSystem stick = OtherFileSystem.stick();
    private boolean onStick;
    private StringWriter out;
    private StringWriter err;

    private BoundedClock clock = NOW;

    @TempDir
    private Path folder;

    private int run(String... args) {
        out = new StringWriter();
        err = new StringWriter();
        CommandLine commandLine = Main.commandLine(PortOption.factory(SerialLink::opener, BoardConfig.create(), clock));
        commandLine.setOut(new PrintWriter(out, true));
        commandLine.setErr(new PrintWriter(err, true));
        commandLine.registerConverter(Path.class, name -> onStick ? stick.of(Path.of(name)) : Path.of(name));
        return commandLine.execute(args);
    }

    private String says(String... args) {
        assertEquals(0, run(args), () -> err.toString());
        assertEquals("", err.toString());
        return out.toString().stripTrailing();
    }

    private String fails(int status, String... args) {
        assertEquals(status, run(args), () -> out.toString());
        assertTrue(err.toString().startsWith("javino: "), err.toString());
        assertEquals(1, err.toString().lines().count(), err.toString());
        assertEquals("", out.toString());
        return err.toString().stripTrailing();
    }

    private String file(String name) {
        return folder.resolve(name).toString();
    }

    private String enroll(String id, String option, String name) {
        return says("enroll", "--id", id, "--folder", file("home"), option, file(name));
    }

    private String enrollFails(String id, String option, String name) {
        return fails(1, "enroll", "--id", id, "--folder", file("home"), option, file(name));
    }

    private String issue(String id, String... more) {
        String[] args = {"ca", "issue", "--ca", file("ca"), "--request", file(id + ".request"), "--out",
                file(id + ".certificate")};
        String[] all = Stream.of(args, more).flatMap(Stream::of)
                .toArray(String[]::new);
        return says(all);
    }

    private void certify(String id, String... more) {
        enroll(id, "--request", id + ".request");
        issue(id, more);
        enroll(id, "--certificate", id + ".certificate");
    }

    private Certificate certificate(String id) throws IOException {
        return Identity.read(folder.resolve("home"), Address.parse(id), Time.REAL).orElseThrow()
                .certificate();
    }

    @Test
    void device_isCertifiedByAnAuthority() throws IOException {
        String fingerprint = says("ca", "init", "--ca", file("ca")).split(" ")[1];
        String asked = enroll("SUPO", "--request", "SUPO.request");
        assertEquals(asked, enroll("SUPO", "--request", "SUPO.request"), "the same request again");
        String request = asked.split(" ")[1];
        assertEquals("certificate 0 of SUPO until " + TODAY.plusYears(1) + " written to " + file("SUPO.certificate")
                + ", for the request " + request, issue("SUPO"));
        assertEquals("certificate 0 of SUPO until " + TODAY.plusYears(1) + " is in "
                + folder.resolve("home").resolve("SUPO.identity") + "; its authority is " + fingerprint,
                enroll("SUPO", "--certificate", "SUPO.certificate"));
        certify("ROMA", "--group-key-server", "--until", TODAY.plusDays(5).toString());
        assertTrue(certificate("ROMA").groupKeyServer());
        assertEquals(TODAY.plusDays(5), certificate("ROMA").until());
        String revocationList = "revocation list 0 of " + TODAY + ", 0 certificates revoked";
        assertEquals("authority " + fingerprint + "\n" + revocationList + "\ncertificate 0 of SUPO until "
                + TODAY.plusYears(1) + ": valid, 365 days left\n" + certificate("ROMA") + ": valid, 5 days left",
                says("ca", "list", "--ca", file("ca")).replace("366 days", "365 days"));
    }

    @Test
    void clock_yearsAhead_endsNothing() throws Exception {
        Instant late = Instant.parse("2050-06-01T00:00:00Z");
        says("ca", "init", "--ca", file("ca"));
        certify("SUPO");
        enroll("ROMA", "--request", "ROMA.request");
        String before = Files.readString(folder.resolve("ca"));
        clock = BoundedClock.at(late);
        String unbelieved = "more than 20 years after this release of Javino; set it, or say --clock-is-right";
        assertTrue(fails(1, "ca", "init", "--ca", file("other")).endsWith(unbelieved));
        assertTrue(fails(1, "ca", "issue", "--ca", file("ca"), "--request", file("ROMA.request"), "--out", file("x"))
                .endsWith(unbelieved));
        assertTrue(fails(1, "ca", "revoke", "--ca", file("ca"), "--out", file("x")).endsWith(unbelieved));
        assertTrue(fails(1, "ca", "list", "--ca", file("ca")).endsWith(unbelieved));
        assertEquals(before, Files.readString(folder.resolve("ca")));
        says("ca", "revoke", "--ca", file("ca"), "--out", file("late"), "--clock-is-right");
        clock = NOW;
        assertTrue(enrollFails("SUPO", "--revocation-list", "late").endsWith(
                "late says 2050-06-01, more than 20 years after this release of Javino; if that is right, say "
                        + "--clock-is-right"));
        says("ca", "issue", "--ca", file("ca"), "--request", file("ROMA.request"), "--out", file("ROMA.certificate"));
        assertTrue(enrollFails("ROMA", "--certificate", "ROMA.certificate").contains("says 2050-06-01"));
    }

    @Test
    void file_withSecrets_isItsOwnersAndTheOthersHaveNone() throws IOException {
        says("ca", "init", "--ca", file("ca"));
        certify("SUPO");
        Path identity = folder.resolve("home").resolve("SUPO.identity");
        for (Path secret : new Path[] {folder.resolve("ca"), identity}) {
            assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(secret)));
        }
        assertEquals("rwx------",
                PosixFilePermissions.toString(Files.getPosixFilePermissions(folder.resolve("home"))));
        String text = Files.readString(identity);
        String secret = text.replaceAll("(?s).*\\bsecret ([0-9a-f]{64}).*", "$1");
        assertEquals(64, secret.length());
        for (String open : new String[] {"SUPO.request", "SUPO.certificate", "ca"}) {
            assertFalse(Files.readString(folder.resolve(open)).contains(secret), open);
        }
        assertFalse(text.contains("request"), text);
    }

    @Test
    void device_withAValidCertificate_getsNoOtherUnlessItIsReplaced() throws IOException {
        says("ca", "init", "--ca", file("ca"));
        certify("SUPO");
        enroll("SUPO", "--request", "again.request");
        String[] again = {"ca", "issue", "--ca", file("ca"), "--request", file("again.request"), "--out",
                file("again")};
        assertEquals("javino: certificate 0 of SUPO until " + TODAY.plusYears(1) + " is valid; --replace revokes it",
                fails(1, again));
        assertFalse(Files.exists(folder.resolve("again")));
        says("ca", "issue", "--ca", file("ca"), "--request", file("again.request"), "--out", file("again"),
                "--replace");
        assertEquals(0, certificate("SUPO").serial(), "until the new one is taken in");
        enroll("SUPO", "--certificate", "again");
        assertEquals(1, certificate("SUPO").serial());
        assertTrue(says("ca", "list", "--ca", file("ca")).contains("certificate 0 of SUPO until "
                + TODAY.plusYears(1) + ": revoked"));
        assertTrue(enrollFails("SUPO", "--certificate", "SUPO.certificate").contains("no request of SUPO waits"));
    }

    @Test
    void certificate_thatIsRevoked_isNamedByARevocationList() throws IOException {
        says("ca", "init", "--ca", file("ca"));
        certify("SUPO");
        certify("ROMA");
        String revocationList = "revocation list 1 of " + TODAY + ", 1 certificate revoked";
        assertEquals(revocationList + ", written to " + file("revoked"),
                says("ca", "revoke", "--ca", file("ca"), "--out", file("revoked"), "--id", "ROMA"));
        assertEquals(revocationList + ", is taken in", enroll("SUPO", "--revocation-list", "revoked"));
        assertEquals(revocationList + ", is no newer than what SUPO has",
                enroll("SUPO", "--revocation-list", "revoked"));
        assertEquals("javino: ROMA has no certificate that is valid; javino ca list shows all",
                fails(1, "ca", "revoke", "--ca", file("ca"), "--out", file("2"), "--id", "ROMA"));
        assertEquals("revocation list 2 of " + TODAY + ", 1 certificate revoked, written to " + file("2"),
                says("ca", "revoke", "--ca", file("ca"), "--out", file("2")));
        says("ca", "revoke", "--ca", file("ca"), "--out", file("3"), "--least-until", TODAY.plusYears(2).toString());
        assertTrue(says("ca", "list", "--ca", file("ca")).endsWith("of ROMA until " + TODAY.plusYears(1)
                + ": revoked"));
    }

    @Test
    void certificate_thatIsForAnotherOrChanged_isNotTakenIn() throws IOException {
        says("ca", "init", "--ca", file("ca"));
        enroll("SUPO", "--request", "SUPO.request");
        enroll("ROMA", "--request", "ROMA.request");
        issue("ROMA");
        issue("SUPO");
        assertTrue(enrollFails("SUPO", "--certificate", "ROMA.certificate").contains("is for ROMA, not for SUPO"));
        String text = Files.readString(folder.resolve("SUPO.certificate"));
        for (String name : new String[] {"certificate 4943ce0001", "contribution "}) {
            Files.writeString(folder.resolve("changed"), text.replaceAll(name + "..",
                    name + (text.contains(name + "00") ? "01" : "00")));
            assertTrue(enrollFails("SUPO", "--certificate", "changed").contains("or damaged"), err.toString());
        }
        Files.writeString(folder.resolve("changed"), text.replaceAll("authority .*\n", ""));
        assertTrue(enrollFails("SUPO", "--certificate", "changed").contains("has no authority"));
        assertTrue(enrollFails("SUPO", "--certificate", "SUPO.request").contains("has no certificate"));
        assertTrue(enrollFails("BUSA", "--certificate", "SUPO.certificate").contains("there is no request of BUSA"));
        enroll("SUPO", "--certificate", "SUPO.certificate");
    }

    @Test
    void authority_beyondTheFirst_isTrustedOnlyByItsFingerprint() throws IOException {
        String first = says("ca", "init", "--ca", file("ca")).split(" ")[1];
        certify("SUPO");
        Files.move(folder.resolve("ca"), folder.resolve("old"));
        String fingerprint;
        do { // one in 256 has the same first digits
            Files.deleteIfExists(folder.resolve("ca"));
            fingerprint = says("ca", "init", "--ca", file("ca")).split(" ")[1];
        } while (fingerprint.startsWith(first.substring(0, 2)));
        Files.delete(folder.resolve("SUPO.certificate"));
        enroll("SUPO", "--request", "SUPO.request");
        issue("SUPO");
        assertEquals("javino: authority " + fingerprint + " is not the one that SUPO trusts; to trust it too, add "
                + "--authority " + fingerprint, enrollFails("SUPO", "--certificate", "SUPO.certificate"));
        says("enroll", "--id", "SUPO", "--folder", file("home"), "--certificate", file("SUPO.certificate"),
                "--authority", fingerprint);
        says("ca", "revoke", "--ca", file("old"), "--out", file("revoked"));
        assertTrue(enroll("SUPO", "--revocation-list", "revoked").endsWith("is taken in"),
                "the old one is still trusted");
    }

    private List<String> files() throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.filter(Files::isRegularFile).map(file -> folder.relativize(file).toString()).sorted().toList();
        }
    }

    @Test
    void secrets_wherePermissionsCannotBeKept_areRefusedAndNotLeft() throws IOException {
        onStick = true;
        String why = ": others could read the secrets in it, as its permissions cannot be kept; choose a folder in "
                + "your home";
        assertEquals("javino: " + file("ca") + why, fails(1, "ca", "init", "--ca", file("ca")));
        assertEquals("javino: " + folder.resolve("home/SUPO.identity") + why,
                enrollFails("SUPO", "--request", "SUPO.request"));
        assertEquals("javino: " + file("keys") + why, fails(1, "keygen", "--out", file("keys"), "--group", "SU"));
        assertEquals(List.of(), files());
    }

    @Test
    void requestAndAnswer_goByAStick() throws IOException {
        says("ca", "init", "--ca", file("ca"));
        Path home = folder.resolve("home");
        enroll("SUPO", "--request", "SUPO.request");
        assertEquals("rw-------",
                PosixFilePermissions.toString(Files.getPosixFilePermissions(folder.resolve("SUPO.request"))));
        CommandLine enroll = Main.commandLine(PortOption.serial()).setOut(new PrintWriter(out));
        enroll.registerConverter(Path.class,
                name -> name.startsWith(home.toString()) ? Path.of(name) : stick.of(Path.of(name)));
        assertEquals(0, enroll.execute("enroll", "--id", "SUPO", "--folder", home.toString(), "--request",
                file("stick.request")));
        assertEquals(Files.readString(folder.resolve("SUPO.request")),
                Files.readString(folder.resolve("stick.request")));
        Files.createSymbolicLink(folder.resolve("link"), folder.resolve("ca"));
        assertEquals("javino: " + file("link") + ": it is a link or no file; choose another path",
                enrollFails("SUPO", "--request", "link"));
    }

    @Test
    void use_thatIsWrong_isSaidInOneLine() throws IOException {
        assertEquals("javino: init, issue, revoke or list? (try --help)", fails(2, "ca"));
        assertTrue(fails(2, "enroll", "--id", "//SU").contains("a device such as SUPO"));
        assertTrue(fails(2, "ca", "init").contains("--ca"));
        says("ca", "init", "--ca", file("ca"));
        assertTrue(fails(1, "ca", "init", "--ca", file("ca")).contains("it is there already"));
        enroll("SUPO", "--request", "SUPO.request");
        String[] issue = {"ca", "issue", "--ca", file("ca"), "--request", file("SUPO.request"), "--out", file("out"),
                "--until", "2026-01-01"};
        assertTrue(fails(2, issue).contains("--until takes a day from today"));
        issue[issue.length - 1] = "2200-01-01";
        assertTrue(fails(2, issue).contains("to 2149-06-06"));
        issue[issue.length - 1] = "tomorrow";
        assertTrue(fails(2, issue).contains("tomorrow"));
        issue[3] = file("shared");
        Files.setPosixFilePermissions(Files.createFile(folder.resolve("shared")),
                PosixFilePermissions.fromString("rw-r--r--"));
        issue[issue.length - 1] = TODAY.toString();
        assertTrue(fails(1, issue).contains("others than you may read"));
        Files.writeString(folder.resolve("no"), "no request\n");
        issue[3] = file("ca");
        issue[5] = file("no");
        assertTrue(fails(1, issue).contains("no, line 1: expected a name and hexadecimal digits"));
        Files.write(folder.resolve("no"), new byte[] {(byte) 0xff});
        assertTrue(fails(1, issue).contains("no text in UTF-8"));
        Files.writeString(folder.resolve("no"), "request 00\n");
        assertTrue(fails(1, issue).contains("no request of a device"));
        Files.writeString(folder.resolve("no"), "revocation-list 00\n");
        assertTrue(fails(1, "enroll", "--id", "SUPO", "--folder", file("home"), "--revocation-list", file("no"))
                .contains("SUPO has no certificate"));
    }
}
