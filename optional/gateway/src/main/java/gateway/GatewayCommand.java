package gateway;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import javino.JavinoException;
import javino.Printable;
import javino.TextFile;
import javino.cli.AddressOption;
import javino.cli.CommandPlugin;
import javino.cli.UntilInterrupted;
import javino.link.SerialLink;
import javino.protocol.Address;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code javino gateway}: joins this radio cell to others. */
@Command(name = "gateway", description = {"Joins this radio cell to others by an MQTT broker, until Ctrl-C.",
        "It publishes what its board hears, and has the board send what is for devices here. It needs no key and "
                + "reads nothing that is sealed; the board needs no address."})
public final class GatewayCommand implements CommandPlugin {

    /** The environment variable for the password, so that it is on no command line. */
    private static final String PASSWORD = "JAVINO_MQTT_PASSWORD";

    @Option(names = "--port", required = true, paramLabel = "PORT",
            description = "The board's serial port, such as /dev/ttyACM0 or COM5.")
    private String port;

    @Option(names = "--broker", required = true, paramLabel = "URL",
            description = "The broker, such as mqtts://broker.example:8883. mqtt:// is not encrypted.")
    private String broker;

    @Option(names = "--cell", required = true, paramLabel = "NAME",
            description = "What this radio cell is called: up to 32 letters, digits, - and _. Gateways whose boards "
                    + "hear the same devices have the same cell, all others another one.")
    private String cell;

    @Option(names = "--user", paramLabel = "NAME", description = "The user at the broker.")
    private String user;

    @Option(names = "--password-file", paramLabel = "FILE",
            description = "The file whose first line is the user's password; or set " + PASSWORD + ".")
    private Path passwordFile;

    @Option(names = "--ca", paramLabel = "FILE",
            description = "The certificate of the CA that vouches for the broker, as PEM; default: those of Java.")
    private Path ca;

    @Option(names = "--topic", paramLabel = "PREFIX", defaultValue = "javino",
            description = "What all topics begin with; default: ${DEFAULT-VALUE}.")
    private String prefix;

    @Option(names = "--broadcasts", description = "Relay broadcasts of other cells, too.")
    private boolean broadcasts;

    @Option(names = "--group", paramLabel = "GG", converter = AddressOption.Group.class,
            description = "Relay multicasts to this group, such as SU, even if no member of it was heard here; for "
                    + "more groups say it again.")
    private Set<Address> groups = Set.of();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, IOException {
        check(cell.matches(Topics.NAME), "--cell takes up to 32 letters, digits, - and _, not " + Printable.of(cell));
        check(prefix.matches("[^+#\\p{Cntrl}]+"), "--topic takes no + and no #, not " + Printable.of(prefix));
        check(user != null || passwordFile == null, "--password-file needs --user");
        Gateway.Config config = new Gateway.Config(brokerConfig(), cell, prefix, broadcasts, groups);
        UntilInterrupted.run(() -> work(config));
        return 0;
    }

    private void check(boolean right, String otherwise) {
        if (!right) {
            throw new ParameterException(spec.commandLine(), otherwise);
        }
    }

    private BrokerConfig brokerConfig() throws JavinoException, IOException {
        BrokerConfig config;
        try {
            config = BrokerConfig.parse(broker);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), Printable.of(e.getMessage()), e);
        }
        check(ca == null || config.tls(), "--ca needs a broker by mqtts://");
        config = user == null ? config : config.as(user, password());
        return ca == null ? config : config.trusting(ca);
    }

    private Optional<String> password() throws JavinoException, IOException {
        if (passwordFile == null) {
            return Optional.ofNullable(System.getenv(PASSWORD));
        }
        try {
            Optional<String> line = TextFile.read(passwordFile).lines().findFirst();
            if (line.filter(text -> text.matches("\\P{Cntrl}+")).isEmpty()) {
                throw new JavinoException(passwordFile + " has no password in its first line");
            }
            return line;
        } catch (IllegalArgumentException e) {
            throw new JavinoException(e.getMessage(), e);
        }
    }

    private void work(Gateway.Config config) throws JavinoException, InterruptedException {
        if (!config.broker().tls() && config.broker().password().isPresent()) {
            log("the password goes to " + config.broker() + " unencrypted: mqtts:// would hide it");
        }
        try (Gateway gateway = Gateway.start(
                listener -> BoardRadio.open(SerialLink.opener(port), listener), config, this::log)) {
            log("cell " + cell + " is joined");
            awaitEnd(gateway);
        }
    }

    private void awaitEnd(Gateway gateway) throws InterruptedException {
        try {
            new CountDownLatch(1).await();
        } finally {
            log(gateway.counters());
        }
    }

    private void log(String line) {
        spec.commandLine().getOut().println("gateway: " + Printable.of(line));
        spec.commandLine().getOut().flush();
    }
}
