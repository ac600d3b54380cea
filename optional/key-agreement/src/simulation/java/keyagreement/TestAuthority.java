package keyagreement;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.LocalDate;
import java.util.List;
import javino.JavinoException;
import javino.link.Time;
import javino.protocol.Address;
import picocli.CommandLine;

/** An authority, and devices that it certifies: by {@code javino enroll}, as users do. */
final class TestAuthority {

    /** The day on which the tests began: it may be past already. */
    static final LocalDate TODAY = LocalDate.now();

    private static final SecureRandom RANDOM = new SecureRandom();

    final Authority authority = Authority.create(TODAY, RANDOM);
    private final Path folder;

    TestAuthority(Path folder) {
        this.folder = folder;
    }

    Identity certified(String id) {
        return certified(id, TODAY.plusDays(100));
    }

    Identity certified(String id, LocalDate until) {
        return certified(id, until, false);
    }

    /** The device that gives out the key of its group. */
    Identity groupKeyServer(String id) {
        return certified(id, TODAY.plusDays(100), true);
    }

    private Identity certified(String id, LocalDate until, boolean groupKeyServer) {
        try {
            Path request = folder.resolve(id + ".request");
            enroll(id, "--request", request);
            Request asked = Request.decode(Entries.read(request).get(Request.NAME).orElseThrow());
            Path answer = folder.resolve(id + ".certificate");
            Files.writeString(answer, authority.issue(asked, until, groupKeyServer, TODAY, RANDOM).format());
            enroll(id, "--certificate", answer);
            return Identity.read(folder, Address.parse(id), Time.REAL).orElseThrow();
        } catch (IOException | JavinoException e) {
            throw new IllegalStateException(e);
        }
    }

    private void enroll(String id, String option, Path file) {
        StringWriter said = new StringWriter();
        PrintWriter out = new PrintWriter(said);
        int status = new CommandLine(new EnrollCommand()).setOut(out).setErr(out).execute("--id", id, "--folder",
                folder.toString(), option, file.toString());
        if (status != 0) {
            throw new IllegalStateException("javino enroll ended with " + status + ": " + said);
        }
    }

    RevocationList revoke(Identity... revoked) throws JavinoException {
        List<Integer> serials = List.of(revoked).stream().map(each -> each.certificate().serial()).toList();
        return authority.revoke(serials, null, TODAY);
    }
}
