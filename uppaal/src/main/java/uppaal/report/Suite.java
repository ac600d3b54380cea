package uppaal.report;

import java.nio.file.Path;
import java.util.List;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.document.Document;

/**
 * The paper's network and its queries.
 *
 * @param folder the folder that holds them
 */
record Suite(Path folder) {
    Document paper() {
        return Scene.PAPER.document(folder);
    }

    Document quiet() {
        return Scene.QUIET.document(folder);
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
