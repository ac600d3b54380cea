package keyagreement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javino.JavinoException;
import javino.Printable;
import javino.cli.AddressOption;
import javino.cli.ClockOption;
import javino.cli.CommandPlugin;
import javino.keyring.DeviceNotes;
import javino.keyring.PrivateFile;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Bytes;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.P256;

/** {@code javino enroll}: has a device certified. */
@Command(name = "enroll", description = {
        "Has a device certified by an authority, so that devices without its key can trust it.",
        "First it writes a request. javino ca issue makes a certificate of it, which --certificate then takes in. The "
                + "device's secret stays in a file that only you can read."})
public final class EnrollCommand implements CommandPlugin {

    /** The secret of a request that waits for its certificate. */
    private static final String REQUEST_SECRET = "request-secret";

    @Option(names = "--id", required = true, paramLabel = "ADDRESS", converter = AddressOption.Device.class,
            description = "The device's address, such as SUPO.")
    private Address id;

    @Option(names = "--folder", paramLabel = "FOLDER",
            description = "The folder of identities; default: .javino in your home.")
    private Path folder = DeviceNotes.defaultFolder();

    @ArgGroup
    private What what = new What();

    @Option(names = "--authority", paramLabel = "FINGERPRINT", converter = Fingerprint.class,
            description = "With --certificate: trust this authority beside those that the device trusts already; as "
                    + "javino ca init or list says it.")
    private String authority;

    @Mixin
    private ClockOption clock;

    @Spec
    private CommandSpec spec;

    private static final class Fingerprint implements ITypeConverter<String> {
        @Override
        public String convert(String text) {
            if (!text.matches("[0-9a-f]{16}")) {
                throw new TypeConversionException(
                        "a fingerprint is 16 of 0-9 a-f, as javino ca list says it, not " + Printable.of(text));
            }
            return text;
        }
    }

    /** The task; {@code --request} if none is given. */
    private static final class What {

        @Option(names = "--request", paramLabel = "FILE",
                description = "Write a request; default: ADDRESS.request here.")
        private Path request;

        @Option(names = "--certificate", paramLabel = "FILE", description = "Take in what javino ca issue has written.")
        private Path certificate;

        @Option(names = "--revocation-list", paramLabel = "FILE",
                description = "Take in what javino ca revoke has written.")
        private Path revocationList;
    }

    @Override
    public Integer call() throws IOException, JavinoException, InterruptedException {
        if (what.certificate != null) {
            certify(Entries.read(what.certificate));
        } else if (what.revocationList != null) {
            take();
        } else {
            request(what.request == null ? Path.of(id.toString().replace('/', '-') + ".request") : what.request);
        }
        return 0;
    }

    private Path file() {
        return DeviceNotes.identity(folder, id);
    }

    private void print(String line) {
        spec.commandLine().getOut().println(line);
    }

    private void request(Path out) throws IOException, JavinoException, InterruptedException {
        PrivateFile.createFolder(folder);
        Request request = Request.decode(Entries.parse(withRequest(), file()).get(Request.NAME).orElseThrow());
        PrivateFile.replaceToCarry(out, new Entries().add(Request.NAME, request.toBytes()).format());
        print("request " + request.fingerprint() + " of " + id + " written to " + out
                + "; javino ca issue on it, which must name the same number");
    }

    private String withRequest() throws IOException, JavinoException, InterruptedException {
        if (Files.exists(file())) {
            return PrivateFile.change(file(), this::withRequest);
        }
        String text = withRequest("");
        PrivateFile.create(file(), text);
        return text;
    }

    /** One that waits for its certificate already is written again: a new one would make that certificate useless. */
    private String withRequest(String text) {
        Entries entries = Entries.parse(text, file());
        if (entries.get(Request.NAME).isEmpty()) {
            P256.Pair pair = P256.generate(clock.secureRandom());
            entries.set(REQUEST_SECRET, pair.number()).set(Request.NAME, new Request(id, pair.point()).toBytes());
        }
        return entries.format();
    }

    private void certify(Entries answer) throws IOException, JavinoException, InterruptedException {
        if (!Files.exists(file())) {
            throw new JavinoException(file() + ": there is no request of " + id + "; javino enroll --id " + id
                    + " first");
        }
        String text = PrivateFile.change(file(), before -> certified(Entries.parse(before, file()), answer).format());
        Identity identity = Identity.of(file(), Entries.parse(text, file()), Time.REAL);
        AuthorityKeys keys = AuthorityKeys.decode(answer.get(Identity.AUTHORITY).orElseThrow());
        print(identity.certificate() + " is in " + file() + "; its authority is " + keys.fingerprint());
    }

    /**
     * The secret is {@code e · request's secret + contribution} (SEC 4 section 3.6). It is computed once, here, on the
     * device's own computer; the time that this takes reaches nobody.
     */
    private Entries certified(Entries own, Entries answer) throws JavinoException {
        Bytes encoded = answer.get(Identity.CERTIFICATE).orElseThrow(() -> new JavinoException(
                what.certificate + " has no certificate; javino ca issue writes one"));
        Certificate certificate = Certificate.decode(encoded);
        if (!certificate.address().equals(id)) {
            throw new JavinoException(what.certificate + " is for " + certificate.address() + ", not for " + id);
        }
        Bytes requestSecret = own.get(REQUEST_SECRET).orElseThrow(() -> new JavinoException(
                "no request of " + id + " waits for a certificate; javino enroll --id " + id + " first"));
        trust(own, answer);
        Bytes secret = P256.bytes(certificate.hash().multiply(P256.number(requestSecret))
                .add(P256.number(answer.get(Identity.CONTRIBUTION).orElse(Bytes.EMPTY))).mod(P256.ORDER));
        own.set(Identity.SECRET, secret).set(Identity.CERTIFICATE, encoded).remove(REQUEST_SECRET).remove(Request.NAME);
        for (Bytes revocationList : answer.all(Identity.REVOCATION_LIST)) {
            clock.check(what.certificate, RevocationList.decode(revocationList).day());
            Identity.keep(RevocationList.decode(revocationList), own);
        }
        try {
            Identity.of(file(), own, Time.REAL).check(certificate);
        } catch (IllegalArgumentException e) {
            throw new JavinoException(what.certificate + " is not for the last request of " + id + ", or damaged: "
                    + "javino ca issue --replace on the request, once more", e);
        }
        return own;
    }

    /** The first authority is trusted as it comes: its file came by hand. Another needs a word. */
    private void trust(Entries own, Entries answer) throws JavinoException {
        AuthorityKeys keys = AuthorityKeys.decode(answer.get(Identity.AUTHORITY).orElseThrow(
                () -> new JavinoException(what.certificate + " has no authority; javino ca issue writes one")));
        for (Bytes each : own.all(Identity.AUTHORITY)) {
            AuthorityKeys known = AuthorityKeys.decode(each);
            if (known.equals(keys)) {
                return;
            }
            if (known.id() == keys.id()) {
                throw new JavinoException("authority " + keys.fingerprint() + " has the same first digits as "
                        + known.fingerprint() + ", which the device trusts; make another by javino ca init");
            }
        }
        if (!own.all(Identity.AUTHORITY).isEmpty() && !keys.fingerprint().hex().equals(authority)) {
            throw new JavinoException("authority " + keys.fingerprint() + " is not the one that " + id
                    + " trusts; to trust it too, add --authority " + keys.fingerprint());
        }
        own.add(Identity.AUTHORITY, keys.toBytes());
    }

    private void take() throws IOException, JavinoException, InterruptedException {
        Bytes revocationList = Entries.read(what.revocationList).get(Identity.REVOCATION_LIST).orElseThrow(
                () -> new JavinoException(
                        what.revocationList + " has no revocation list; javino ca revoke writes one"));
        Identity identity = Identity.read(folder, id, Time.REAL)
                .orElseThrow(() -> new HandshakeException(id + " has no certificate in " + folder));
        clock.check(what.revocationList, RevocationList.decode(revocationList).day());
        boolean isNew = identity.take(revocationList);
        identity.keep();
        print(RevocationList.decode(revocationList)
                + (isNew ? ", is taken in" : ", is no newer than what " + id + " has"));
    }
}
