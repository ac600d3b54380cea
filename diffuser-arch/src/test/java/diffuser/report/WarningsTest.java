package diffuser.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.logging.Filter;
import java.util.logging.Logger;

import org.junit.jupiter.api.Test;

class WarningsTest {

    private final List<String> logged = new ArrayList<>();
    private final Logger logger = Logger.getAnonymousLogger();
    private final Warnings warnings = new Warnings(() -> logger);

    WarningsTest() {
        Filter recordOnly = line -> {
            logged.add(line.getMessage());
            return false;
        };
        logger.setFilter(recordOnly);
    }

    @Test
    void once_sameText_isLoggedOnce() {
        warnings.once("a");
        warnings.once("b");
        warnings.once("a");
        assertEquals(List.of("a", "b"), logged);
    }

    @Test
    void once_tooManyTexts_saysThatItFallsSilent() {
        for (int i = 0; i < Warnings.MOST_TEXTS + 100; i++) {
            warnings.once("text " + i);
            warnings.once("text 0");
        }
        assertEquals(Warnings.MOST_TEXTS + 1, logged.size());
        assertTrue(logged.get(Warnings.MOST_TEXTS).startsWith("no further kinds of warnings"), logged::toString);
        warnings.always("text 7");
        assertEquals("text 7", logged.get(logged.size() - 1));
    }
}
