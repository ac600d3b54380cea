package keyagreement;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.LocalDate;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import javino.JavinoException;
import javino.cli.AddressOption;
import javino.cli.ClockOption;
import javino.cli.CommandPlugin;
import javino.keyring.PrivateFile;
import javino.protocol.Address;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code javino ca}: the authority whose certificates devices have. */
@Command(name = "ca", description = {"Is the authority that lets devices meet that have no common key.",
        "Keep its file on a computer that is on no network: who has it can make a certificate for any device."})
public final class CaCommand implements CommandPlugin {

    private static final String FILE = "The authority's file, which only you can read.";
    private static final String UNTIL = "The last day on which it is valid, such as 2027-11-30; default: in a year.";
    private static final String GROUP_KEY_SERVER = "The device gives out the key of its group.";

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        throw wrongUsage("init, issue, revoke or list?");
    }

    private ParameterException wrongUsage(String what) {
        return new ParameterException(spec.commandLine(), what);
    }

    private void print(Object line) {
        spec.commandLine().getOut().println(line);
    }

    @Command(name = "init", description = "Makes a new authority.")
    int init(@Option(names = "--ca", required = true, paramLabel = "FILE",
            description = "The authority's file; must not exist yet.") Path file, @Mixin ClockOption clock)
            throws IOException, JavinoException {
        Authority authority = Authority.create(clock.day(), clock.secureRandom());
        PrivateFile.create(file, authority.format());
        print("authority " + authority.keys().fingerprint() + " written to " + file);
        return 0;
    }

    @Command(name = "issue", description = "Gives a device a certificate.")
    int issue(@Option(names = "--ca", required = true, paramLabel = "FILE", description = FILE) Path file,
            @Option(names = "--request", required = true, paramLabel = "FILE",
                    description = "What javino enroll has written on the device's computer.") Path request,
            @Option(names = "--out", required = true, paramLabel = "FILE",
                    description = "Where the certificate goes; must not exist yet.") Path out,
            @Option(names = "--until", paramLabel = "DAY",
                    description = UNTIL) LocalDate until,
            @Option(names = "--group-key-server",
                    description = GROUP_KEY_SERVER) boolean groupKeyServer,
            @Option(names = "--replace",
                    description = "Revoke the device's certificate that is valid. A device has one.") boolean replace,
            @Mixin ClockOption clock)
            throws IOException, JavinoException, InterruptedException {
        LocalDate today = clock.day();
        LocalDate last = until == null ? today.plusYears(1) : until;
        if (last.isBefore(today) || !Days.fits(last)) {
            throw wrongUsage("--until takes a day from today to " + Days.LAST + ", not " + last);
        }
        Request asked = Request.decode(Entries.read(request).get(Request.NAME)
                .orElseThrow(() -> new JavinoException(request + " has no request; javino enroll writes one")));
        mustBeNew(out);
        List<Entries> answer = new ArrayList<>();
        PrivateFile.change(file, text -> {
            Authority authority = Authority.parse(text, file);
            if (replace) {
                authority.revoke(authority.valid(asked.address(), today).stream().map(Certificate::serial).toList(),
                        null, today);
            }
            answer.add(authority.issue(asked, last, groupKeyServer, today, clock.secureRandom()));
            return authority.format();
        });
        Files.writeString(out, answer.get(0).format(), StandardOpenOption.CREATE_NEW);
        print(Authority.parse(PrivateFile.read(file), file).issued().stream().reduce((one, next) -> next).get()
                + " written to " + out + ", for the request " + asked.fingerprint());
        return 0;
    }

    /** Found out before the authority's file notes what goes there. */
    private static void mustBeNew(Path out) throws IOException {
        if (Files.exists(out)) {
            throw new FileAlreadyExistsException(out.toString());
        }
        if (!Files.isDirectory(out.toAbsolutePath().getParent())) {
            throw new NoSuchFileException(out.toString());
        }
    }

    @Command(name = "revoke", description = {"Writes a new revocation list, which ends certificates.",
            "Without any it tells devices only which day it is. They hand it on among themselves."})
    int revoke(@Option(names = "--ca", required = true, paramLabel = "FILE", description = FILE) Path file,
            @Option(names = "--out", required = true, paramLabel = "FILE",
                    description = "Where the revocation list goes; must not exist yet.") Path out,
            @Option(names = "--id", paramLabel = "ADDRESS", converter = AddressOption.Device.class,
                    description = "A device whose certificate ends.") List<Address> devices,
            @Option(names = "--least-until", paramLabel = "DAY",
                    description = "All certificates end whose last day is before this one.") LocalDate leastUntil,
            @Mixin ClockOption clock)
            throws IOException, JavinoException, InterruptedException {
        if (leastUntil != null && !Days.fits(leastUntil)) {
            throw wrongUsage("--least-until takes a day up to " + Days.LAST);
        }
        LocalDate today = clock.day();
        mustBeNew(out);
        String text = PrivateFile.change(file, before -> {
            Authority authority = Authority.parse(before, file);
            List<Integer> serials = new ArrayList<>();
            for (Address device : devices == null ? List.<Address>of() : devices) {
                serials.add(authority.valid(device, today).orElseThrow(() -> new JavinoException(
                        device + " has no certificate that is valid; javino ca list shows all")).serial());
            }
            authority.revoke(serials, leastUntil, today);
            return authority.format();
        });
        RevocationList revocationList = Authority.parse(text, file).revocationList();
        Files.writeString(out, new Entries().add(Identity.REVOCATION_LIST, revocationList.toBytes()).format(),
                StandardOpenOption.CREATE_NEW);
        print(revocationList + ", written to " + out);
        return 0;
    }

    @Command(name = "list", description = "Shows the authority, its last revocation list and all certificates.")
    int list(@Option(names = "--ca", required = true, paramLabel = "FILE", description = FILE) Path file,
            @Mixin ClockOption clock) throws IOException, JavinoException {
        LocalDate today = clock.day();
        Authority authority = Authority.parse(PrivateFile.read(file), file);
        RevocationList revocationList = authority.revocationList();
        print("authority " + authority.keys().fingerprint());
        print(revocationList);
        for (Certificate certificate : authority.issued()) {
            long days = ChronoUnit.DAYS.between(today, certificate.until());
            print(certificate + ": " + (days < 0 ? "expired" : revocationList.revokes(certificate) ? "revoked"
                    : "valid, " + days + " days left"));
        }
        return 0;
    }
}
