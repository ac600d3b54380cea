package readme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import javino.fake.FakeBoard;
import javino.link.LinkOpener;
import javino.protocol.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The example of the README, as it stands there but for its port, compiled and run with a fake board. */
@Timeout(60)
class ReadmeTest {

    private static final Pattern EXAMPLE = Pattern.compile("(?s)```java\n(.*?)```");
    private static final String PORT = "SerialLink.opener(\"/dev/ttyACM0\")";
    private static final int MOST_LINES = 12;

    @TempDir
    private Path folder;

    @Test
    void example_boardThere_doesWhatItSays() throws Exception {
        Matcher example = EXAMPLE.matcher(Files.readString(Path.of(System.getProperty("javino.readme"))));
        assertTrue(example.find());
        assertTrue(example.group(1).lines().count() <= MOST_LINES, example.group(1));
        assertTrue(example.group(1).contains(PORT), example.group(1));

        FakeBoard fake = new FakeBoard();
        fake.setRfId("ROMA");
        fake.perceive("light(312)");
        AtomicInteger polls = new AtomicInteger();
        fake.line.setLoses(message -> {
            // The polls before have brought the message and the percepts.
            boolean wantsPercepts = message.at(0) == 'P' && (message.at(1) & 1) != 0;
            if (wantsPercepts && polls.incrementAndGet() >= 3 && fake.requests.contains("SUPO tell;help")) {
                fake.end("SUPO tell;help", Outcome.DELIVERED);
            }
            return false;
        });
        fake.receive("ROMA", "SUPO", 1, "tell;help");
        String out = run(compile(example.group(1).replace(PORT, "port")), fake.port);

        assertEquals(List.of("radio 1", "act goForward", "SUPO tell;help"), List.copyOf(fake.requests));
        for (String line : List.of("greeted fake", "sees [light(312)]", "SUPO says tell;help", "DELIVERED")) {
            assertTrue(out.lines().toList().contains(line), out);
        }
    }

    private Path compile(String statements) throws Exception {
        Path source = Files.writeString(folder.resolve("Example.java"), """
                import java.util.*;
                import javino.board.*;
                import javino.link.*;
                import javino.protocol.*;
                public class Example {
                    public static void run(LinkOpener port) throws Exception {
                """ + statements + "}}");
        ByteArrayOutputStream errors = new ByteArrayOutputStream();
        int code = ToolProvider.getSystemJavaCompiler().run(null, null, errors, "-classpath",
                System.getProperty("java.class.path"), "-d", folder.toString(), source.toString());
        assertEquals(0, code, errors.toString(StandardCharsets.UTF_8));
        return folder;
    }

    /** The text that the example writes. */
    private static String run(Path classes, LinkOpener port) throws Exception {
        PrintStream out = System.out;
        ByteArrayOutputStream written = new ByteArrayOutputStream();
        try (URLClassLoader loader = new URLClassLoader(new URL[] {classes.toUri().toURL()})) {
            System.setOut(new PrintStream(written, true, StandardCharsets.UTF_8));
            loader.loadClass("Example").getMethod("run", LinkOpener.class).invoke(null, port);
        } finally {
            System.setOut(out);
        }
        return written.toString(StandardCharsets.UTF_8);
    }
}
