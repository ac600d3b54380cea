package uppaal.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.ModelException;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.document.Document;
import uppaal.document.DocumentReader;

/**
 * Some of the automata of {@code delivery.xml} together, with a query file of the same name.
 *
 * @param name of {@code NAME.system} and {@code NAME.q}
 * @param constants that are other than in the file
 */
record Scene(String name, String title, Map<String, Integer> constants) {

    /** All of them. Where a frame's time on the air matters, it is that of the shortest message, rounded up. */
    static final List<Scene> ALL = List.of(
            new Scene("unicast", "Two unicasts, and an attacker", Map.of()),
            new Scene("multicast", "Two multicasts, another group, and an attacker", Map.of()),
            new Scene("crossing", "Two boards that send to each other at the same time (three attempts only)",
                    Map.of("MESSAGES", 1, "ATTEMPTS", 3)),
            new Scene("bound", "How long a unicast may take",
                    Map.of("MESSAGES", 1, "PATIENCE", 3, "DATA_TIME", 4, "ACK_TIME", 3)));

    /** The document. */
    Document document(Path models) {
        Document document = DocumentReader.read(models.resolve("delivery.xml"));
        Path system = models.resolve(name + ".system");
        try {
            document = document.withSystem(Files.readString(system));
        } catch (IOException problem) {
            throw ModelException.unreadable(system, problem);
        }
        for (Map.Entry<String, Integer> constant : constants.entrySet()) {
            document = with(document, constant.getKey(), constant.getValue());
        }
        return document;
    }

    /** What is asked of it. */
    List<Query> queries(Path models) {
        return QueryFile.read(models.resolve(name + ".q"));
    }

    /** A document with another number for a constant. */
    static Document with(Document document, String constant, int number) {
        return document.withDeclarations(find(document, constant).replaceFirst("$1" + number));
    }

    /** What in a document is not as in the firmware; a line each. */
    static List<String> differences(Document document, Firmware firmware) {
        List<String> lines = new ArrayList<>();
        firmware.constants(number(document, "UNIT")).forEach((constant, wanted) -> {
            int found = number(document, constant);
            if (found != wanted) {
                lines.add(document.file() + ": " + constant + " is " + found + ", by the firmware's sources it must be "
                        + wanted);
            }
        });
        return lines;
    }

    private static int number(Document document, String constant) {
        return Integer.parseInt(find(document, constant).group(2));
    }

    private static Matcher find(Document document, String constant) {
        Matcher matcher = Pattern.compile("(const int " + constant + " = )(\\d+)").matcher(document.declarations());
        if (!matcher.find()) {
            throw new ModelException(document.file() + ", declaration", "there is no constant " + constant);
        }
        return matcher;
    }
}
