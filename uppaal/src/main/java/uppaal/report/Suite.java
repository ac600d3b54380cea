package uppaal.report;

import java.nio.file.Path;
import java.util.List;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.document.Document;
import uppaal.document.DocumentReader;

/**
 * The models and the queries, and where they are.
 *
 * @param folder the folder that holds them
 */
record Suite(Path folder) {
    Path paperModel() {
        return folder.resolve("paper.xml");
    }

    Path quietModel() {
        return folder.resolve("quiet.xml");
    }

    /** The query files for the paper's network. */
    List<Path> paperFiles() {
        return List.of(folder.resolve("paper.q"), folder.resolve("stronger.q"));
    }

    /** The query files for the quiet network. */
    List<Path> quietFiles() {
        return List.of(folder.resolve("quiet.q"), folder.resolve("stronger.q"));
    }

    Document paper() {
        return DocumentReader.read(paperModel());
    }

    Document quiet() {
        return DocumentReader.read(quietModel());
    }

    List<Query> paperQueries() {
        return QueryFile.read(folder.resolve("paper.q"));
    }

    List<Query> strongerQueries() {
        return QueryFile.read(folder.resolve("stronger.q"));
    }

    List<Query> quietQueries() {
        return QueryFile.read(folder.resolve("quiet.q"));
    }
}
