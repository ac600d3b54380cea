package uppaal.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.ModelException;
import uppaal.document.Document;
import uppaal.document.Template;
import uppaal.language.Expressions;
import uppaal.language.Names;
import uppaal.language.Term;

/**
 * Compares the constants of a model with the firmware's. The comment behind a declaration tells where its number comes
 * from:
 * <ol>
 * <li>{@code // = EXPRESSION}, with the firmware's names, perhaps closed by a colon: from these;</li>
 * <li>{@code // model: …}: from the model alone;</li>
 * <li>neither: the firmware has the same name.</li>
 * </ol>
 */
public final class Constants {
    private static final Pattern DECLARATION =
            Pattern.compile(
                    "const\\s+(?:int|bool)(?:\\[[^\\]]*\\])?\\s+(?<list>[^;]+);[ \\t]*(?://[ \\t]*(?<origin>.*))?");
    private static final Pattern ONE = Pattern.compile("(?<name>\\w+)\\s*=\\s*(?<value>.+)", Pattern.DOTALL);

    private final String file;
    private final Firmware firmware;
    private final List<String> wrong = new ArrayList<>();

    private Constants(String file, Firmware firmware) {
        this.file = file;
        this.firmware = firmware;
    }

    /** The constants that are not as in the firmware, or say nothing of where they come from; a line each. */
    public static List<String> differences(Document document, Firmware firmware) {
        Constants constants = new Constants(document.file(), firmware);
        constants.compare(document.declarations());
        document.templates().stream().map(Template::declarations).forEach(constants::compare);
        return constants.wrong;
    }

    private void compare(String declarations) {
        Matcher declaration = DECLARATION.matcher(declarations);
        while (declaration.find()) {
            String origin = Optional.ofNullable(declaration.group("origin")).orElse("");
            if (!origin.startsWith("model:")) {
                for (String one : declaration.group("list").split(",")) {
                    compare(one.strip(), origin);
                }
            }
        }
    }

    private void compare(String declared, String origin) {
        Matcher one = ONE.matcher(declared);
        if (!one.matches()) {
            wrong.add(file + ": '" + declared + "' is not compared with the firmware; if it is of the model alone, say "
                    + "'// model: …' behind it");
            return;
        }
        String name = one.group("name");
        Optional<Term> wanted = origin.startsWith("=")
                ? Optional.of(Expressions.parse(origin.substring(1).split(":")[0], firmware, file + ", " + name))
                : firmware.term(name);
        if (wanted.isEmpty()) {
            wrong.add(file + ": the firmware has no " + name + "; say behind it '// = …' with the firmware's names, or "
                    + "'// model: …' if it is of the model alone");
        } else if (!wanted.equals(Optional.of(value(name, one.group("value"))))) {
            wrong.add(file + ": " + name + " is " + one.group("value") + ", by the firmware's sources it must be "
                    + wanted.get().value(new int[0]));
        }
    }

    /** Numbers only: what a model computes from its own constants is compared where these are declared. */
    private Term value(String name, String text) {
        Names nothing = other -> Optional.empty();
        try {
            return Expressions.parse(text, nothing, file);
        } catch (ModelException computed) {
            throw new ModelException(file + ", " + name, "write its number, so that it can be compared");
        }
    }
}
