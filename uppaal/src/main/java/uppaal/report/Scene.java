package uppaal.report;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import uppaal.ModelException;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.document.Document;
import uppaal.document.DocumentReader;

/**
 * A model as it is checked: a file, perhaps with the instances of {@code NAME.system} and with other constants. The
 * whole is written as one file, so that every tool gets the same.
 *
 * @param model the file that it is made of
 * @param constants those that are other than in the file
 * @param fewer likewise, for as few states as mutants of it need
 * @param queries the files of its queries, in the order in which they are asked
 */
public record Scene(String name, String title, String model, Map<String, String> constants,
        Map<String, String> fewer, List<String> queries) {

    public static final Scene PAPER =
            new Scene("paper", "The network of the paper", "paper.xml", Map.of(), Map.of(),
                    List.of("paper.q", "stronger.q"));
    public static final Scene QUIET = new Scene("quiet",
            "The same, with a connection that stays online and senders that do not dawdle", "quiet.xml",
            Map.of(), Map.of(), List.of("quiet.q", "stronger.q"));
    public static final Scene RENEWAL =
            new Scene("renewal", "The renewal and the deletion of a key that three boards share", "renewal.xml",
                    Map.of(), Map.of(), List.of("renewal.q"));

    /** A scene in which the boards come to an end: each takes up one message, of one attempt. */
    public static final Scene ROLLOVER = new Scene("rollover", "The same, where nobody sends for ever", "renewal.xml",
            Map.of("MESSAGES", "1", "ATTEMPTS", "1"), Map.of(), List.of("rollover.q"));

    /** Numbers with which the scenes of relays have few states, and the same verdicts. */
    private static final Map<String, String> FASTER = Map.of("ROUNDS_WITH_RELAY", "4", "LATE", "4", "LATE_ROUNDS", "1",
            "LATE_ATTEMPT", "1", "WITHIN", "1");

    public static final Scene FRAGMENTS =
            new Scene("fragments", "A message in two fragments, of which one is forged", "fragments.xml",
                    Map.of(), Map.of(), List.of("fragments.q"));
    public static final Scene BROADCAST = new Scene("broadcast", "How a broadcast's repeat is known", "broadcast.xml",
            Map.of(), Map.of(), List.of("broadcast.q"));
    /** Its bound is tight. */
    public static final Scene LATE = new Scene("late", "The same, where the air is busy for longer", "broadcast.xml",
            Map.of("BUSY", "12"), Map.of(), List.of("late.q"));
    public static final Scene HIDDEN = new Scene("hidden", "Two boards out of each other's range", "hidden.xml",
            Map.of(), Map.of("MAX_ATTEMPTS", "5", "PATIENCE", "4", "LATE_PATIENCE", "16", "FIRST_SLOTS", "2",
                    "LEAST_WINDOW", "4", "LAST_WINDOW", "32", "MOST_PUT_OFF_SLOTS", "4", "DATA_TIME", "7", "ACK_TIME",
                    "3"),
            List.of("hidden.q"));
    public static final Scene HOST = new Scene("host", "Messages for a host that dies", "host.xml", Map.of(), Map.of(),
            List.of("host.q"));

    public static final Scene HANDSHAKE = new Scene("handshake", "Two hosts that never met come to a key",
            "handshake.xml", Map.of(), Map.of(), List.of("handshake.q"));

    /** Scenes with few attempts, as all clocks of two relays run beside each other. */
    public static final List<Scene> OF_RELAYS = List.of(
            ofRelays("relay", "One relay, and an attacker (two attempts only)", Map.of("MAX_ATTEMPTS", "2")),
            ofRelays("attempts", "One relay in doubt, with all attempts", Map.of("SHOTS", "0")),
            ofRelays("relays", "Two relays (one attempt only)", Map.of("MAX_ATTEMPTS", "1")),
            ofRelays("reserve", "One relay in doubt, and one in reserve (two attempts only)",
                    Map.of("MAX_ATTEMPTS", "2")),
            ofRelays("away", "One relay that is away (four attempts only)", Map.of("MAX_ATTEMPTS", "4")),
            new Scene("storm", "Relays: Two relays in air that is busy for long (small numbers)", "relay.xml",
                    with(FASTER,
                            Map.of("MAX_ATTEMPTS", "1", "ROUNDS_WITH_RELAY", "1", "LATE", "2", "WITHIN", "3", "CREDIT",
                                    "3")),
                    Map.of(), List.of("storm.q")));

    /** The scenes of moves. If contact returns, messages are lost and processes killed a few times at most. */
    public static final List<Scene> OF_MOVES = List.of(
            ofMoves("handover", "An agent moves, and again if that has failed", Map.of(), "move.q"),
            ofMoves("return", "An agent moves, and comes back", Map.of(), "move.q"),
            ofMoves("forgery", "An agent moves, and comes back; others forge its return", Map.of("MOVES", "3")),
            ofMoves("theft", "An agent moves; somebody with its token forges its return", Map.of("STOLEN", "true")),
            ofMoves("cloning", "An agent is cloned", Map.of(), "move.q"),
            ofMoves("contact", "An agent moves, and contact returns", Map.of("FAIR", "true")),
            ofMoves("round", "An agent moves and comes back, and contact returns",
                    Map.of("FAIR", "true", "LOSSES", "1", "COPIES", "0", "TRIES", "3")),
            ofMoves("silence", "An agent is offered, and its first part never comes",
                    Map.of("FAIR", "true", "LOSSES", "0")));

    private static final Map<String, String> FEW = Map.of("MAX_ATTEMPTS", "2", "FIRST_SLOTS", "2", "LEAST_WINDOW", "1",
            "LAST_WINDOW", "2", "LATE_ATTEMPT", "1", "MOST_PUT_OFF_SLOTS", "3");
    /** Numbers with which the scenes of delivery have few states, and the same verdicts. */
    private static final Map<String, String> SMALL = with(FEW, Map.of("PATIENCE", "3", "LATE_PATIENCE", "4",
            "RELAY_PATIENCE", "5", "LOSSES", "1", "DEADLINE", "112"));
    /** Numbers for one end of a message, as a trace is replayed in it: others do what they like, one at a time. */
    private static final Map<String, String> END = with(FEW, Map.of("PATIENCE", "2", "LATE_PATIENCE", "3",
            "RELAY_PATIENCE", "4", "CARRIERS", "1", "FAIR", "true", "LOSSES", "0"));

    /**
     * The scenes of delivery. With all attempts and an attacker there are 11.5 million states, and more of two boards
     * that send to each other: so these have fewer. If a packet's time on the air matters, it is that of the shortest
     * message, rounded up, and so is the patience.
     */
    public static final List<Scene> OF_DELIVERY = List.of(
            ofDelivery("unicast", "Two unicasts, and an attacker (two attempts only)", Map.of("MAX_ATTEMPTS", "2"),
                    SMALL, "unicast.q", "attacker.q"),
            ofDelivery("repeats", "Two unicasts, with all attempts", Map.of(), SMALL, "unicast.q", "repeats.q"),
            ofDelivery("multicast", "Two multicasts, another group, and an attacker", Map.of(), SMALL, "multicast.q"),
            ofDelivery("crossing", "Two boards that send to each other at the same time (two attempts only)",
                    Map.of("MAX_ATTEMPTS", "2"), SMALL, "crossing.q"),
            ofDelivery("turns", "Two unicasts to two boards, under way at once (two attempts only)",
                    Map.of("MAX_ATTEMPTS", "2"), SMALL, "turns.q"),
            ofDelivery("cuts", "One unicast, and a reset or a loss of power", Map.of(), SMALL, "cuts.q"),
            ofDelivery("fair", "Two unicasts over a channel that is fair in the end", Map.of("FAIR", "true"), SMALL,
                    "fair.q"),
            ofDelivery("sender", "The sender of a unicast in fragments, and all that others may do (small numbers)",
                    END,
                    Map.of(), "sender.q"),
            ofDelivery("group", "The sender of a multicast in fragments, likewise", END, Map.of(), "group.q"),
            ofDelivery("receiver", "A receiver, likewise", with(END, Map.of("MORE", "false")), Map.of(), "receiver.q"),
            ofDelivery("bound", "How long a unicast may take", Map.of("TWICE", "false", "PATIENCE", "19", "DATA_TIME",
                    "28", "ACK_TIME", "19", "DEADLINE", "1760"), SMALL, "bound.q"));

    /** The scenes of boards, of relays and of moves. */
    public static final List<Scene> OURS =
            Stream.of(List.of(RENEWAL, ROLLOVER, FRAGMENTS, BROADCAST, LATE, HIDDEN, HOST, HANDSHAKE),
                    OF_RELAYS, OF_MOVES, OF_DELIVERY).flatMap(List::stream).toList();
    /** All of them. */
    public static final List<Scene> ALL = Stream.concat(Stream.of(PAPER, QUIET), OURS.stream()).toList();

    private static final Pattern SYSTEM = Pattern.compile("<system>.*</system>", Pattern.DOTALL);

    private static Scene ofDelivery(String name, String title, Map<String, String> constants,
            Map<String, String> fewer, String... queries) {
        return new Scene(name, "Delivery: " + title, "delivery.xml", constants, fewer,
                Stream.concat(Stream.of(queries), Stream.of("air.q")).toList());
    }

    private static Scene ofRelays(String name, String title, Map<String, String> constants) {
        return new Scene(name, "Relays: " + title, "relay.xml", constants, FASTER, List.of(name + ".q", "copies.q"));
    }

    private static Scene ofMoves(String name, String title, Map<String, String> constants, String... more) {
        return new Scene(name, "Moves: " + title, "handover.xml", constants, Map.of(),
                Stream.concat(Stream.of(name + ".q"), Stream.of(more)).toList());
    }

    /** This scene with so few states that many mutants of it can be checked. */
    public Scene inSmall() {
        return new Scene(name, title, model, with(constants, fewer), Map.of(), queries);
    }

    private static Map<String, String> with(Map<String, String> numbers, Map<String, String> others) {
        return Stream.concat(numbers.entrySet().stream(), others.entrySet().stream())
                .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue, (before, after) -> after));
    }

    /** The whole file. */
    String text(Path models) {
        return text(Firmware.read(models.resolve(model)), models);
    }

    /** The whole file, if this is the text of the model. */
    public String text(String of, Path models) {
        String text = of;
        Path system = models.resolve(name + ".system");
        if (Files.exists(system)) {
            String instances = Firmware.read(system).replace("&", "&amp;").replace("<", "&lt;");
            text = SYSTEM.matcher(text).replaceFirst(Matcher.quoteReplacement("<system>" + instances + "</system>"));
        }
        for (Map.Entry<String, String> constant : constants.entrySet()) {
            Matcher declared = Pattern.compile("(const (?:int|bool) " + constant.getKey() + " = )\\w+").matcher(text);
            if (!declared.find()) {
                throw new ModelException(model, "there is no constant " + constant.getKey());
            }
            text = declared.replaceFirst("$1" + constant.getValue());
        }
        return text;
    }

    /** The document. */
    Document document(Path models) {
        try {
            return DocumentReader.read(name + ".xml",
                    new ByteArrayInputStream(text(models).getBytes(StandardCharsets.UTF_8)));
        } catch (IOException impossible) {
            throw new IllegalStateException("an array of bytes cannot be read", impossible);
        }
    }

    /** The queries about it. */
    public List<Query> queries(Path models) {
        return queries.stream().flatMap(file -> QueryFile.read(models.resolve(file)).stream()).toList();
    }

    /**
     * Writes {@code NAME.xml} and {@code NAME.q}, for other tools.
     *
     * @return the folder's {@code NAME.xml}
     */
    Path write(Path models, Path folder) throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve(name + ".q"),
                queries.stream().map(file -> Firmware.read(models.resolve(file))).collect(Collectors.joining("\n")));
        return Files.writeString(folder.resolve(name + ".xml"), text(models));
    }
}
