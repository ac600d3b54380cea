package uppaal.check;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.ModelException;

/**
 * Reads UPPAAL's {@code .q} files: a property a line, which a backslash at its end continues, and comments.
 * Before each property we want a comment of our own form: {@code /* NAME holds|fails: what it says. *}{@code /}.
 */
public final class QueryFile {
    private static final Pattern COMMENT =
            Pattern.compile("/\\*\\s*(?<name>\\w+) (?<verdict>holds|fails): (?<sentence>.+?)\\s*\\*/");

    private final String file;
    private final List<Query> queries = new ArrayList<>();
    private Matcher comment;
    private StringBuilder property = new StringBuilder();

    private QueryFile(String file) {
        this.file = file;
    }

    /** @throws ModelException when the file cannot be read, or is not of the form above */
    public static List<Query> read(Path path) {
        try {
            return parse(String.valueOf(path.getFileName()), Files.readString(path));
        } catch (IOException problem) {
            throw ModelException.unreadable(path, problem);
        }
    }

    /** @param file the name to use in messages */
    public static List<Query> parse(String file, String text) {
        QueryFile reader = new QueryFile(file);
        int number = 0;
        for (String line : text.lines().toList()) {
            reader.line(line.strip(), file + ", line " + ++number);
        }
        reader.finish();
        return List.copyOf(reader.queries);
    }

    private void line(String line, String where) {
        if (property.isEmpty() && (line.isEmpty() || line.startsWith("//"))) {
            return;
        }
        if (property.isEmpty() && line.startsWith("/*")) {
            comment = COMMENT.matcher(line);
            if (!comment.matches()) {
                throw new ModelException(where, "a comment must be one line: /* NAME holds|fails: what it says. */");
            }
            return;
        }
        boolean continued = line.endsWith("\\");
        property.append(continued ? line.substring(0, line.length() - 1).strip() + " " : line);
        if (!continued) {
            complete(where);
        }
    }

    private void complete(String where) {
        if (comment == null) {
            throw new ModelException(where, "a comment must stand before it: /* NAME holds|fails: what it says. */");
        }
        queries.add(new Query(comment.group("name"), comment.group("verdict").equals("holds"),
                comment.group("sentence"), property.toString(), where));
        comment = null;
        property = new StringBuilder();
    }

    private void finish() {
        if (!property.isEmpty()) {
            throw new ModelException(file, "its last line promises another one");
        }
        if (comment != null) {
            throw new ModelException(file, "no property follows its last comment");
        }
    }
}
