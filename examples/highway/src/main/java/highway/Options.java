package highway;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;
import javino.board.Transitions;
import keyagreement.BoardKeyAgreement;
import trace.TransitionHandler;

/** The options of a run on the command line, and the commands that follow from them. */
final class Options {

    /** The emulator's control socket. */
    private static final String CONTROL = "build/control";
    /** The socket at which agents tell the page of themselves. */
    static final Path LIVE = Path.of("build", "live");
    /** All that the page shows, and what agents decide: {@code javino watch --trace}, {@code javino why}. */
    static final Path RUN = Path.of("build", "run.jsonl");
    /** Certificates and secrets of all devices: on real computers each has its own. */
    static final Path IDENTITIES = Path.of("build", "identities");

    @Option(names = "--emulator", required = true, hidden = true, description = "The emulator's program.")
    private Path emulator;

    @Option(names = "--radioBitErrorRate",
            description = "Share of bits that the air inverts, 0 to 1; default: the scenario file's.")
    private Double radioBitErrorRate;

    @Option(names = "--radioRange", description = "How far the radio reaches, in metres; default: the scenario file's.")
    private Double radioRange;

    @Option(names = "--radio", converter = SerialModule.class,
            description = "A serial module in place of the ASK pair: hc-12 or e32.")
    private String radio;

    @Option(names = "--seed", defaultValue = "1", description = "Seed of the air's errors; default ${DEFAULT-VALUE}.")
    private long seed;

    @Option(names = "--timeout", defaultValue = "90", converter = Seconds.class,
            description = "Seconds to wait for each step: the boards, the keys, the agents, the behaviours; default "
                    + "${DEFAULT-VALUE}.")
    private int timeout;

    @Option(names = "--live", converter = Live.class,
            description = "Show the run in the browser, until Ctrl-C; with the value now, wait for no viewer.")
    private String live;

    @Option(names = "--headless", converter = Given.class, description = "With live: open no browser.")
    private String headless;

    @Option(names = "--certificates", converter = Given.class,
            description = "Give the boards no keys: the devices have certificates, and agree on keys by radio.")
    private String certificates;

    private int cells;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--javino", hidden = true, description = "The class path of the javino command.")
    private String javino = System.getProperty("java.class.path");

    @Option(names = "--agents", hidden = true, description = "The class path of the agents.")
    private String agents = System.getProperty("java.class.path");

    @Option(names = "--plain", hidden = true, description = "No colours.")
    private boolean plain;

    @Option(names = "--boards-only", hidden = true, description = "Run the boards only, until Ctrl-C.")
    private boolean boardsOnly;

    @Option(names = "--inspector", hidden = true, description = "With an agent that travels by radio.")
    private boolean inspector;

    /** Gradle gives an option without a value an empty one. */
    private static final class Given implements ITypeConverter<String> {
        @Override
        public String convert(String value) {
            if (!value.isEmpty()) {
                throw new TypeConversionException("takes no value, not " + value);
            }
            return value;
        }
    }

    private static final class Live implements ITypeConverter<String> {
        @Override
        public String convert(String value) {
            return value.equals("now") ? value : new Given().convert(value);
        }
    }

    private static final class SerialModule implements ITypeConverter<String> {
        @Override
        public String convert(String name) {
            if (!List.of("hc-12", "e32").contains(name)) {
                throw new TypeConversionException("hc-12 or e32 was expected, not " + name);
            }
            return name;
        }
    }

    private static final class Seconds implements ITypeConverter<Integer> {
        @Override
        public Integer convert(String text) {
            if (!text.matches("[1-9]\\d{0,5}")) {
                throw new TypeConversionException("1 second or more was expected, not " + text);
            }
            return Integer.valueOf(text);
        }
    }

    /** What is to be observed. */
    List<Path> features() {
        Path rescue = Path.of("highway.feature");
        return inspector ? List.of(rescue, Path.of("inspector", "inspector.feature")) : List.of(rescue);
    }

    @Option(names = "--cells", defaultValue = "1",
            description = "With 2: support station and hospital are 5 km away, and two gateways join the cells; needs "
                    + "mosquitto.")
    private void setCells(int count) {
        if (count != 1 && count != 2) {
            throw new ParameterException(command.commandLine(), "--cells takes 1 or 2, not " + count);
        }
        cells = count;
    }

    /** Whether two cells are to be joined by gateways. */
    boolean twoCells() {
        return cells == 2;
    }

    /** Whether the devices have certificates, and no keys. */
    boolean certificates() {
        return certificates != null;
    }

    /** Seconds. */
    int timeout() {
        return timeout;
    }

    boolean boardsOnly() {
        return boardsOnly;
    }

    /** Whether the run is watched in the browser, and goes on until the user ends it. */
    boolean live() {
        return live != null;
    }

    /** Whether the story begins only when somebody looks at the page, and is told slowly then. */
    boolean awaitsViewer() {
        return live() && live.isEmpty();
    }

    /** Colours, unless asked for none here or by the environment (no-color.org). */
    boolean coloured() {
        String terminal = System.getenv("TERM");
        return !plain && System.getenv("NO_COLOR") == null && System.getenv("CI") == null
                && terminal != null && !terminal.equals("dumb");
    }

    /** The scenario; with serial modules, one of sketches for them. */
    Path scenario() throws IOException {
        Path file = Path.of(twoCells() ? "two-cells.json" : "highway.json");
        if (radio == null) {
            return file;
        }
        String text = Files.readString(file)
                .replaceAll("\\.\\./\\.\\./javino-firmware/build/(vehicle|station)/",
                        "../../../javino-firmware/build/$1-" + radio + "/")
                .replace("\"bitRate\": 2000", "\"module\": \"" + radio + "\"");
        return Files.writeString(Files.createDirectories(Path.of("build")).resolve(file), text);
    }

    /** @param keys the file in which it writes the keys that hosts agree on. */
    List<String> emulatorCommand(Path keys) throws IOException {
        List<String> command =
                new ArrayList<>(List.of(emulator.toString(), "" + scenario(), "--trace", "-", "--seed", "" + seed,
                        "--control", CONTROL));
        if (radioBitErrorRate != null) {
            command.addAll(List.of("--set", "radio.bitErrorRate=" + radioBitErrorRate));
        }
        if (radioRange != null) {
            command.addAll(List.of("--set", "radio.range=" + radioRange));
        }
        if (certificates()) {
            command.addAll(List.of("--keys", keys.toString()));
        }
        return command;
    }

    /** {@code javino watch}: the page, which takes the events from its standard input. */
    List<String> watchCommand() {
        List<String> command = javino("watch", "--trace", "-", "--control", CONTROL, "--agents", "" + LIVE,
                "--record", "" + RUN);
        if (headless != null) {
            command.add("--no-browser");
        }
        return command;
    }

    /** The broker between the cells, as {@link Scenario} configures it. */
    static List<String> brokerCommand(Path configuration) {
        return List.of("/usr/sbin/mosquitto", "-c", configuration.toString());
    }

    /** {@code javino gateway}: joins a cell, by the board of that name. Nobody has heard the group's members yet. */
    List<String> gatewayCommand(String cell, int brokerPort) {
        return javino("gateway", "--port", "ports/" + cell, "--cell", cell, "--group", "SU", "--broker",
                "mqtt://127.0.0.1:" + brokerPort);
    }

    /** {@code javino keygen}: a key for each pair that talks, and one for the group. */
    List<String> keygenCommand(Path keyring) {
        List<String> command = javino("keygen", "--out", keyring.toString(), "--group", "SU",
                "--pair", "SUPP,SUHO", "--pair", "SUHO,SUAM", "--pair", "SUPP,SUPO", "--pair", "SUPO,ROMA");
        if (inspector) {
            command.addAll(List.of("--pair", "SUPP,ROMA"));
        }
        return command;
    }

    /** {@code javino provision}: its id and those keys that it needs. */
    List<String> provisionCommand(Device device, Path keyring) {
        return javino("provision", "--port", "ports/" + device.id(),
                "--id", device.address, "--keyring", keyring.toString());
    }

    /** {@code javino ca init}. */
    List<String> authorityCommand(Path authority) {
        return javino("ca", "init", "--ca", authority.toString());
    }

    /** {@code javino enroll}: a request. */
    List<String> requestCommand(Device device, Path request) {
        return javino("enroll", "--id", device.address, "--folder", IDENTITIES.toString(), "--request",
                request.toString());
    }

    /** {@code javino ca issue}: a certificate; the support station's says that it gives out the key of the group. */
    List<String> issueCommand(Path authority, Device device, Path request, Path certificate) {
        List<String> command = javino("ca", "issue", "--ca", authority.toString(), "--request",
                request.toString(), "--out", certificate.toString());
        if (device == Device.SUPPORT) {
            command.add("--group-key-server");
        }
        return command;
    }

    /** {@code javino enroll}: takes the certificate in. */
    List<String> enrollCommand(Device device, Path certificate) {
        return javino("enroll", "--id", device.address, "--folder", IDENTITIES.toString(),
                "--certificate", certificate.toString());
    }

    /** Jason, in a Java virtual machine of its own, without a window and without any network. */
    List<String> agentCommand(Device device) throws IOException {
        List<String> words = new ArrayList<>(List.of("jason.infra.local.RunLocalMAS", mas(device), "--log-conf",
                logging(device), "--no-net"));
        if (live()) {
            words.add(0, "live.ObservedMas");
        }
        return java(agents, words.toArray(String[]::new));
    }

    /** Agents tell the emulator of their state machines, too. */
    private static String logging(Device device) throws IOException {
        return Files.writeString(Path.of("build", device.id() + ".properties"),
                Files.readString(Path.of("logging.properties"))
                        + TransitionHandler.configuration(Transitions.LOGGER, Path.of(CONTROL)))
                .toString();
    }

    private String mas(Device device) {
        boolean visited = inspector && (device == Device.BUS || device == Device.SUPPORT);
        return (visited ? "inspector/" : "") + device.id() + ".mas2j";
    }

    private List<String> javino(String... arguments) {
        return java(javino, Stream.concat(Stream.of("javino.cli.Main"), Stream.of(arguments)).toArray(String[]::new));
    }

    private static List<String> java(String classPath, String... mainAndArguments) {
        String java = System.getProperty("java.home") + File.separator + "bin" + File.separator + "java";
        List<String> command = new ArrayList<>(List.of(java, "-Djava.awt.headless=true", "-XX:+UseSerialGC",
                "-D" + BoardKeyAgreement.FOLDER_PROPERTY + "=" + IDENTITIES,
                "-XX:TieredStopAtLevel=1", "--enable-native-access=ALL-UNNAMED", "-Dfile.encoding=UTF-8", "-cp",
                classPath));
        command.addAll(List.of(mainAndArguments));
        return command;
    }
}
