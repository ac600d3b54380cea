package campaign;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** AgentSpeak as people write it, as much as is wanted: the programs of this repository. */
final class AgentTexts {

    private static final List<String> FOLDERS = List.of("examples/highway/agents",
            "test/system/src/test/resources/agents", "diffuser-arch/src/test/resources/asl",
            "javino-java/cli/src/main/resources/javino/cli/project/jason/src/agt");
    /** Programs for older boards: their actions are of other packages. */
    private static final Set<String> LEFT_OUT = Set.of("older.asl", "argo.asl", "difuser.asl");
    /** Words of the language and of its actions, and variables' like, which have the same names in all programs. */
    private static final Pattern NAME = Pattern.compile(
            "(?<![.\\w@])(?!(?:not|true|false|source|percept|cast|unicast|multicast|broadcast|error|error_msg|tell"
                    + "|achieve|ask\\w+|open|block|self|on|off|while|for|elif|else|mod|div)\\b)[a-z]\\w{2,}(?!\\w)");
    private static final List<String> WORDS = List.of("bridge", "tunnel", "cargo", "harbour", "crane", "meadow",
            "valve",
            "pump", "level", "barrier", "signal", "track", "wagon", "driver", "ticket", "market", "window", "garden",
            "lantern", "engine", "battery", "charge", "climb", "descend", "measure", "report", "collect", "deliver",
            "inspect", "repair", "weather", "humidity", "pressure", "corner", "junction", "station", "platform",
            "schedule", "arrival", "farmer", "tractor", "orchard", "silo", "ferry", "anchor", "captain", "warehouse",
            "shelf", "pallet", "scanner", "label", "parcel", "courier", "route", "detour", "warning", "alarm");

    private AgentTexts() {}

    /** Whole plans, rules and beliefs, of about so many characters. */
    static String of(Path root, int length) throws IOException {
        StringBuilder text = new StringBuilder();
        List<String> clauses = clauses(root);
        for (int round = 0; text.length() < length; round++) {
            for (String clause : clauses) {
                String next = round == 0 ? clause : renamed(clause, round);
                if (text.length() + next.length() > length) {
                    if (length - text.length() < next.length() / 2) {
                        return text.toString();
                    }
                }
                text.append(next);
                if (text.length() >= length) {
                    return text.toString();
                }
            }
        }
        return text.toString();
    }

    private static String renamed(String clause, int round) {
        // A label is of one plan only.
        return NAME.matcher(clause.replaceAll("@\\w+(\\[.*?])? ", "")).replaceAll(name -> WORDS.get(
                Math.floorMod(name.group().hashCode() + 31 * round, WORDS.size())) + (round > 1 ? round : ""));
    }

    private static List<String> clauses(Path root) throws IOException {
        List<String> clauses = new ArrayList<>();
        for (String folder : FOLDERS) {
            try (Stream<Path> files = Files.list(root.resolve(folder))) {
                for (Path file : files.filter(each -> each.toString().endsWith(".asl"))
                        .filter(each -> !LEFT_OUT.contains(each.getFileName().toString())).sorted().toList()) {
                    clauses.addAll(clauses(Files.readAllLines(file)));
                }
            }
        }
        return clauses;
    }

    /** A line that is not indented begins a clause. Clauses that would begin by themselves are left out. */
    private static List<String> clauses(List<String> lines) {
        List<String> clauses = new ArrayList<>();
        for (String line : lines) {
            String code = line.replaceAll("//.*|@\\w+@", "").stripTrailing();
            if (code.isEmpty() || line.contains("\"//")) {
                continue;
            }
            if (Character.isWhitespace(code.charAt(0)) && !clauses.isEmpty()) {
                clauses.add(clauses.remove(clauses.size() - 1) + code + "\n");
            } else {
                clauses.add(code + "\n");
            }
        }
        clauses.removeIf(clause -> clause.startsWith("!") || clause.startsWith("{") || !clause.strip().endsWith("."));
        return clauses;
    }
}
