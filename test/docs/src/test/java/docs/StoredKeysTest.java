package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * No stored key comes to a board past the guard that knows which it has lost, and no epoch is raised elsewhere (SPEC
 * 5.1): whoever gives a board a key asks {@code Board}, whose requests all pass {@code Service}.
 */
class StoredKeysTest {

    private static final String BOARD = "javino-java/board/src/main/java/javino/board/";
    private static final Set<String> OTHERS = Set.of("test", "fake", "vectors", "simulation");

    private static final Pattern SOURCE_SET = Pattern.compile("src/(\\w+)/");

    /** The sources of what users run, without the codec. */
    private static List<Path> sources() {
        return Repository.files(".", ".java").stream().filter(file -> {
            String name = Repository.ROOT.resolve(".").relativize(file).toString();
            return SOURCE_SET.matcher(name).results().noneMatch(set -> OTHERS.contains(set.group(1)))
                    && !name.startsWith("test/") && !name.startsWith("javino-java/protocol/");
        }).toList();
    }

    private static Set<String> filesWith(String pattern) {
        Pattern wanted = Pattern.compile(pattern);
        Set<String> found = new TreeSet<>();
        sources().stream().filter(file -> wanted.matcher(Repository.text(file)).find())
                .forEach(file -> found.add(file.getFileName().toString()));
        return found;
    }

    @Test
    void requests_thatStoreAKey_areMadeForTheQueueOnly() {
        assertTrue(sources().size() > 200, "all are read");
        assertEquals(Set.of("Board.java"), filesWith("Request\\s*\\.\\s*(setKey|renewKey)\\b|Request::(set|renew)Key"));
        assertEquals(Set.of(), filesWith("Command\\.(SET_KEY|RENEW_KEY)\\b"));
        assertEquals(Set.of("Service.java"), filesWith("Request\\s*\\.\\s*raiseEpoch\\b"));
    }

    @Test
    void requests_thatStoreAKey_passTheGuard() {
        String service = Repository.text(BOARD + "Service.java");
        assertEquals(1, count("pending\\.source\\(\\)\\.request\\(", service), "the queue's requests are made once");
        assertTrue(service.contains("request.command().storesKey() ? store(request, board) : ask(request)"));
        assertEquals(Set.of("LegacyService.java", "Service.java"), filesWith("source\\(\\)\\s*\\.request\\("));
        assertEquals(Set.of("Greeting.java"), filesWith("new Exchange\\("), "only a session speaks with a board");
    }

    private static long count(String pattern, String text) {
        return Pattern.compile(pattern).matcher(text).results().count();
    }
}
