package diffuser.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import diffuser.gate.Gate;

import org.junit.jupiter.api.Test;

class OwnPerceptsTest {

    /** All that the page says has the source percept. */
    @Test
    void percepts_likeTheArchitecturesOwn_areLeftOut() throws Exception {
        String page = Files.readString(Path.of(System.getProperty("javino.root"), "docs/reference.md"));
        String table = page.substring(page.indexOf("| belief or event |"), page.indexOf("## Command line"))
                .replaceAll("(?m)(?<!^) \\| .*", "");
        Matcher own = Pattern.compile("`[+]?([a-z]\\w*)(\\([^)]*\\))[^`]*`").matcher(table);
        List<String> names = new ArrayList<>();
        while (own.find()) {
            names.add(own.group(1));
            String text = own.group(1) + own.group(2).replaceAll("[^(),]+", "x");
            boolean sensors = own.group(1).equals("light");
            assertEquals(sensors, isAdmitted(text), text);
        }
        assertTrue(names.containsAll(List.of("port", "openness", "peer", "light", "delivered", "movedIn")),
                names::toString);
    }

    private static boolean isAdmitted(String text) throws Exception {
        try {
            return Percepts.admitted(text) != null;
        } catch (Gate.RefusedException e) {
            return false;
        }
    }
}
