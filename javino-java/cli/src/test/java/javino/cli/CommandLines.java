package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.stream.Stream;
import javino.board.BoardConfig;
import javino.fake.FakeBoard;
import javino.keyring.PrivateFile;
import javino.link.SerialLink;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * Right lines for all commands, made of picocli's model: a new command has them by itself, unless one of its places is
 * of a new kind. In them {name} stands for a file.
 */
final class CommandLines {

    /** Right values for the places of commands; one for a place of one command goes before one for all. */
    private static final Map<String, String> RIGHT = Map.ofEntries(
            Map.entry("PORT", "fake"), Map.entry("ADDRESS", "SUPO"), Map.entry("ADDRESS=FILE", "ROMA={key}"),
            Map.entry("A,B", "ROMA,SUPO"), Map.entry("GG", "SU"), Map.entry("SECONDS", "1"), Map.entry("TO", "SUPO"),
            Map.entry("CONTENT", "tell;help"), Map.entry("ACTION", "lampOn"), Map.entry("COMMAND", "info"),
            Map.entry("ARGUMENT", "1"), Map.entry("1|2", "2"), Map.entry("SOCKET", "{new}"),
            Map.entry("on|off", "on"), Map.entry("BOARD", "uno"), Map.entry("N", "0"),
            Map.entry("FOLDER", "{new}"), Map.entry("DAY", "2099-01-01"), Map.entry("FINGERPRINT", "0123456789abcdef"),
            Map.entry("NAME", "west"), Map.entry("PREFIX", "javino"), Map.entry("URL", "mqtts://127.0.0.1:1"),
            Map.entry("why FILE", "{run}"), Map.entry("import FILE", "{chon}"), Map.entry("why WHAT", "!go"),
            Map.entry("--at", "6.2"),
            Map.entry("why --from", "robot"),
            Map.entry("--out", "{new}"), Map.entry("--write", "{new}"), Map.entry("--record", "{new}"),
            Map.entry("--renew", "{keyring}"),
            Map.entry("--keyring", "{keyring}"), Map.entry("--trace", "{trace}"), Map.entry("--ca", "{authority}"),
            Map.entry("ca init --ca", "{new}"), Map.entry("gateway --ca", "{word}"),
            Map.entry("--request", "{request}"),
            Map.entry("enroll --request", "{new}"), Map.entry("--certificate", "{certificate}"),
            Map.entry("--revocation-list", "{list}"), Map.entry("--password-file", "{word}"));

    /** Options that a place needs beside it, and that its command does without elsewhere. */
    private static final Map<String, String> NEEDS = Map.ofEntries(
            Map.entry("doctor --keyring", "--id SUPO"), Map.entry("keygen --out", "--group SU"),
            Map.entry("keygen --id", "--renew {keyring}"), Map.entry("capture --write", "--trace {trace}"),
            Map.entry("why FILE", "--at 6.2"), Map.entry("why --from", "--at 6.2"),
            Map.entry("watch --control", "--trace -"), Map.entry("watch --agents", "--trace -"),
            Map.entry("watch --record", "--trace {trace}"), Map.entry("watch --http-port", "--trace {trace}"),
            Map.entry("gateway --password-file", "--user west"),
            Map.entry("enroll --request", "--folder {home}"), Map.entry("enroll --folder", "--request {new}"),
            Map.entry("enroll --certificate", "--folder {home}"),
            Map.entry("enroll --revocation-list", "--folder {home}"),
            Map.entry("enroll --authority", "--folder {home} --certificate {certificate}"));

    private static final String EVENT = "{\"t\":0.1,\"board\":\"bus\",\"event\":\"host-id\",\"id\":\"ROMA\"}\n";

    private static final String SETTINGS =
            "{\"t\":0.1,\"agent\":\"robot\",\"event\":\"agent-settings\",\"port\":\"\"}\n";

    private final Path originals;

    /** @param folder for the files. */
    CommandLines(Path folder) throws Exception {
        originals = folder;
        Files.createDirectory(originals.resolve("folder"));
        Files.createDirectory(originals.resolve("home"));
        for (Map.Entry<String, String> file : Map.of("zeros", "\0".repeat(64), "empty", "", "word", "maybe",
                "key", HexFormat.of().formatHex(new byte[16]), "trace", EVENT, "run", SETTINGS,
                "chon", "{\"agents\":[],\"firmwares\":[]}").entrySet()) {
            PrivateFile.create(originals.resolve(file.getKey()), file.getValue());
        }
        for (String line : List.of("keygen --out {keyring} --pair ROMA,SUPO --group SU", "ca init --ca {authority}",
                "enroll --id SUPO --folder {home} --request {request}",
                "ca issue --ca {authority} --request {request} --out {certificate}",
                "ca revoke --ca {authority} --out {list}")) {
            StringWriter told = new StringWriter();
            assertEquals(0, run(told, originals, List.of(line.split(" "))), told.toString());
        }
    }

    /** Copies the files for a test that may change them. */
    void copy(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(originals)) {
            for (Path file : files.skip(1).toList()) {
                Files.copy(file, folder.resolve(originals.relativize(file)), StandardCopyOption.COPY_ATTRIBUTES);
            }
        }
    }

    static String at(Path folder, String word) {
        return word.replaceAll("\\{([a-z]+)}", Matcher.quoteReplacement(folder + "/") + "$1");
    }

    static int run(StringWriter told, Path folder, List<String> line) {
        CommandLine command = commandLine(new FakeBoard(), BoardConfig.create());
        command.setOut(new PrintWriter(told, true));
        command.setErr(new PrintWriter(told, true));
        return command.execute(line.stream().map(word -> at(folder, word)).toArray(String[]::new));
    }

    static CommandLine commandLine(FakeBoard fake, BoardConfig config) {
        return Main.commandLine(PortOption.factory(
                name -> name.equals("fake") ? fake.port : SerialLink.opener(name), config,
                Path.of("/nowhere")));
    }

    static Stream<CommandSpec> commands() {
        return leaves(commandLine(new FakeBoard(), BoardConfig.create()).getCommandSpec());
    }

    private static Stream<CommandSpec> leaves(CommandSpec command) {
        return command.subcommands().isEmpty() ? Stream.of(command)
                : command.subcommands().values().stream().distinct().flatMap(sub -> leaves(sub.getCommandSpec()));
    }

    static String path(CommandSpec command) {
        return command.qualifiedName(" ").replaceFirst("^javino ", "");
    }

    static String name(ArgSpec argument) {
        return argument instanceof OptionSpec option ? option.longestName() : argument.paramLabel();
    }

    static String place(CommandSpec command, ArgSpec argument) {
        return path(command) + " " + name(argument);
    }

    static Stream<ArgSpec> arguments(CommandSpec command) {
        return command.args().stream().filter(argument -> !(argument instanceof OptionSpec option
                && (option.usageHelp() || option.versionHelp())));
    }

    static boolean takesValue(ArgSpec argument) {
        return argument.arity().max() > 0;
    }

    static String rightValue(CommandSpec command, ArgSpec argument) {
        return Stream.of(place(command, argument), name(argument), argument.paramLabel()).map(RIGHT::get)
                .filter(Objects::nonNull).findFirst()
                .orElseThrow(() -> new AssertionError(place(command, argument) + " has no right value in this test"));
    }

    /** A line whose places are right, but for one that has these words. */
    static List<String> line(CommandSpec command, ArgSpec target, List<String> words) {
        String[] needs = NEEDS.getOrDefault(target == null ? "" : place(command, target), "").split(" ");
        Stream<String> others = arguments(command).filter(each -> each != target || each.isPositional())
                .filter(each -> each == target || isNeeded(each, target, List.of(needs)))
                .flatMap(each -> each == target ? words.stream() : right(command, each).stream());
        return Stream.of(Stream.of(path(command).split(" ")), Stream.of(needs).filter(word -> !word.isEmpty()), others,
                target != null && target.isOption() ? words.stream() : Stream.<String>empty())
                .flatMap(each -> each).toList();
    }

    private static boolean isNeeded(ArgSpec argument, ArgSpec target, List<String> needs) {
        if (argument.group() == null) {
            return argument.required() && !needs.contains(name(argument));
        }
        List<ArgSpec> either = List.copyOf(argument.group().args());
        return argument.group().multiplicity().min() > 0 && either.get(0) == argument
                && (target == null || !either.contains(target))
                && either.stream().noneMatch(each -> needs.contains(name(each)));
    }

    /** The words of an argument in a line. */
    static List<String> right(CommandSpec command, ArgSpec argument) {
        return words(argument, takesValue(argument) ? rightValue(command, argument) : null);
    }

    static List<String> words(ArgSpec argument, String value) {
        return Stream.of(argument.isOption() ? name(argument) : null, value).filter(Objects::nonNull).toList();
    }

    /** The shortest line of each command, and one for each further place. */
    static Stream<List<String>> all() {
        return commands().flatMap(command -> Stream.concat(Stream.of(line(command, null, List.of())),
                arguments(command).map(each -> line(command, each, right(command, each))))).distinct();
    }
}
