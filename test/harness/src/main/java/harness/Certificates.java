package harness;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javino.cli.ClockOption;
import keyagreement.CaCommand;
import keyagreement.EnrollCommand;
import picocli.CommandLine;
import lockstep.Simulation;

/** An authority, and the certificates that it gives, made by the commands that a user has. */
public final class Certificates {

    /** Makes commands in the time of the test. */
    private static final CommandLine.IFactory FACTORY = new CommandLine.IFactory() {
        @Override
        public <K> K create(Class<K> type) throws Exception {
            return type == ClockOption.class ? type.cast(new ClockOption(Simulation.here()))
                    : CommandLine.defaultFactory().create(type);
        }
    };

    private final Path folder;
    private final String name;
    private int files;

    /** A new authority, whose files are in a folder and begin with a name. */
    public Certificates(Path folder, String name) {
        this.folder = folder;
        this.name = name;
        run(new CaCommand(), "init", "--ca", file());
    }

    private String file() {
        return folder.resolve(name + ".ca").toString();
    }

    private String fresh(String kind) {
        return folder.resolve(name + files++ + "." + kind).toString();
    }

    private static void run(Object command, String... arguments) {
        StringWriter said = new StringWriter();
        CommandLine line =
                new CommandLine(command, FACTORY).setOut(new PrintWriter(said)).setErr(new PrintWriter(said));
        if (line.execute(arguments) != 0) {
            throw new AssertionError(String.join(" ", arguments) + ": " + said);
        }
    }

    /**
     * Gives a device a certificate.
     *
     * @param identities the folder for the device's identity.
     * @param issue      further words for {@code javino ca issue}.
     */
    public void enroll(String device, Path identities, String... issue) {
        String request = fresh("request");
        String certificate = fresh("certificate");
        run(new EnrollCommand(), "--id", device, "--folder", identities.toString(), "--request", request);
        List<String> issuing =
                new ArrayList<>(List.of("issue", "--ca", file(), "--request", request, "--out", certificate));
        issuing.addAll(Arrays.asList(issue));
        run(new CaCommand(), issuing.toArray(String[]::new));
        run(new EnrollCommand(), "--id", device, "--folder", identities.toString(), "--certificate", certificate);
    }

    /** Revokes a device's certificate, and gives another device the revocation list. */
    public void revoke(String device, String told, Path identities) {
        String revocationList = fresh("revoked");
        run(new CaCommand(), "revoke", "--ca", file(), "--out", revocationList, "--id", device);
        run(new EnrollCommand(), "--id", told, "--folder", identities.toString(), "--revocation-list", revocationList);
    }
}
