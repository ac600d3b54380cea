package uppaal;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** A model or a query that cannot be read or run: one line that says where, and what is wrong. */
public final class ModelException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /**
     * @param where file and element, e.g. {@code paper.xml, template Channel, edge Released -> Not_Released, guard}
     * @param what the fault there
     */
    public ModelException(String where, String what) {
        super(where + ": " + what);
    }

    /** An exception for something that UPPAAL knows and this checker does not. */
    public static ModelException outside(String where, String construct) {
        return new ModelException(where, construct + " is outside the subset that this checker reads");
    }

    /** An exception for a file that cannot be read. */
    public static ModelException unreadable(Path file, IOException problem) {
        return new ModelException(file.toString(),
                problem instanceof NoSuchFileException ? "there is no such file"
                        : "it cannot be read: " + problem.getMessage());
    }
}
