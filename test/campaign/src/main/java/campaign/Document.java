package campaign;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** docs/reliability.md: a section for each campaign, written by its own run; the others stay as they are. */
public final class Document {

    private static final String HEAD = """
        # Reliability

        Written by `gradle campaign`, which runs all of this anew; each section by the run that it names. Do not edit.

        Boards are emulated Arduino Megas with the sketches that users flash, hosts are `javino-java` over real serial
        ports (ptys). The seed decides where errors and faults fall; hosts run in wall time, so figures differ a little
        from run to run.
        """;
    private static final String SECTION = "\n## ";

    private final Path file;
    private final Map<String, String> sections = new LinkedHashMap<>();

    /** The document as it is, or an empty one. */
    public Document(Path file, List<String> order) throws IOException {
        this.file = file;
        order.forEach(name -> sections.put(name, null));
        if (!Files.exists(file)) {
            return;
        }
        String[] parts = Files.readString(file).split(SECTION);
        for (int i = 1; i < parts.length; i++) {
            int end = parts[i].indexOf('\n');
            sections.put(parts[i].substring(0, end), parts[i].substring(end).strip());
        }
    }

    /** Replaces a campaign's section. */
    public void put(String name, String command, Report report) {
        sections.put(name, "`" + command + "`\n\n" + report.markdown());
    }

    /** Writes the document; campaigns that never ran have no section. */
    public void write() throws IOException {
        StringBuilder text = new StringBuilder(HEAD);
        sections.forEach((name, section) -> {
            if (section != null) {
                text.append(SECTION).append(name).append("\n\n").append(section).append('\n');
            }
        });
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }
}
