import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import org.eclipse.jdt.core.JavaCore;
import org.eclipse.jdt.core.ToolFactory;
import org.eclipse.jdt.core.formatter.CodeFormatter;
import org.eclipse.jdt.core.formatter.DefaultCodeFormatterConstants;
import org.eclipse.jface.text.Document;

/** Formats Java files by Eclipse's formatter, or with --check only names those that it would change. */
class JavaFormat {
    private static final String PREFIX = "org.eclipse.jdt.core.formatter.";

    public static void main(String[] arguments) throws Exception {
        boolean check = arguments[0].equals("--check");
        CodeFormatter formatter = ToolFactory.createCodeFormatter(settings(Path.of(arguments[check ? 1 : 0])));
        boolean differs = false;
        for (int i = check ? 2 : 1; i < arguments.length; i++) {
            Path file = Path.of(arguments[i]);
            String source = Files.readString(file);
            Document formatted = new Document(source);
            int kind = CodeFormatter.K_COMPILATION_UNIT | CodeFormatter.F_INCLUDE_COMMENTS;
            formatter.format(kind, source, 0, source.length(), 0, "\n").apply(formatted);
            if (formatted.get().equals(source)) {
                continue;
            }
            differs = true;
            if (check) {
                System.err.println(file + " is not formatted; run gradle format");
            } else {
                Files.writeString(file, formatted.get());
            }
        }
        System.exit(check && differs ? 1 : 0);
    }

    @SuppressWarnings("unchecked")
    private static Map<String, String> settings(Path file) throws Exception {
        Map<String, String> settings = DefaultCodeFormatterConstants.getEclipseDefaultSettings();
        JavaCore.setComplianceOptions(JavaCore.VERSION_17, settings);
        Properties ours = new Properties();
        try (var in = Files.newBufferedReader(file)) {
            ours.load(in);
        }
        ours.forEach((name, value) -> settings.put(PREFIX + name, value.toString()));
        return settings;
    }
}
