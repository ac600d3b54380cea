package uppaal.document;

import java.util.List;
import uppaal.ModelException;

/**
 * An UPPAAL file as it stands: templates with their graphs, and all texts unparsed.
 *
 * @param file the file's name, for messages
 * @param declarations the global declarations
 * @param templates in the order of the file
 * @param system instantiations and the {@code system} line
 */
public record Document(String file, String declarations, List<Template> templates, String system) {
    /** Copies the list, so that a document never changes. */
    public Document {
        templates = List.copyOf(templates);
    }

    /** @throws ModelException when there is no template of this name */
    public Template template(String name) {
        return templates.stream().filter(template -> template.name().equals(name)).findFirst()
                .orElseThrow(() -> new ModelException(file, "there is no template '" + name + "'"));
    }

    /** This document with other global declarations. */
    public Document withDeclarations(String changed) {
        return new Document(file, changed, templates, system);
    }

    /** This document with other instances and another {@code system} line. */
    public Document withSystem(String changed) {
        return new Document(file, declarations, templates, changed);
    }

    /** This document with the template of the same name replaced. */
    public Document withTemplate(Template changed) {
        return new Document(file, declarations,
                templates.stream().map(old -> old.name().equals(changed.name()) ? changed : old).toList(), system);
    }
}
