package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The libraries that an agent with all optional modules has: no command line, no server of pages, no broker. */
class AgentClassPathTest {

    private static final Pattern UNWANTED = Pattern.compile("picocli|javino-cli|javalin|jetty|mqtt|netty");

    @Test
    void agent_allOptionalModules_noneOfTheCommand() {
        List<String> jars = Arrays.stream(System.getProperty("javino.agent").split(File.pathSeparator))
                .map(jar -> Path.of(jar).getFileName().toString()).toList();
        System.out.println(jars);

        assertTrue(jars.stream().anyMatch(jar -> jar.startsWith("javino-protocol")), jars::toString);
        assertEquals(List.of(), jars.stream().filter(jar -> UNWANTED.matcher(jar).find()).toList());
    }
}
