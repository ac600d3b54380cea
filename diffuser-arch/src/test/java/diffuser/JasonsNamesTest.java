package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import jason.asSemantics.Agent;
import jason.asSyntax.ASSyntax;

import diffuser.gate.Gate;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The names that Jason itself looks up, read from its classes: of the version that is used, and of the newest. */
class JasonsNamesTest {

    /** Looked at: words of the language and of messages, and what only the directory's agent and a test look up. */
    private static final Set<String> HARMLESS = Set.of("achieve", "all_unifs", "askAll", "askHow", "askOne", "atomic",
            "breakpoint", "default", "percept", "provider", "publisher", "self", "source", "subscribe", "tell",
            "tellHow", "this_ns", "unachieve", "untell", "untellHow");

    private static final Pattern MARKED = Pattern.compile("\\b([a-z]\\w*__\\w*|jag_\\w+)");

    static Stream<File> jars() throws Exception {
        File used = new File(Agent.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        return Stream.of(used, new File(System.getProperty("javino.newerJason"))).distinct();
    }

    @ParameterizedTest
    @MethodSource("jars")
    void admit_nameThatJasonLooksUp_isRefused(File jar) throws Exception {
        Set<String> marked = new TreeSet<>();
        Set<String> lookedUp = new TreeSet<>();
        try (JarFile classes = new JarFile(jar)) {
            for (JarEntry entry : classes.stream().filter(each -> each.getName().startsWith("jason/")
                    && each.getName().endsWith(".class")).toList()) {
                try (InputStream bytes = classes.getInputStream(entry)) {
                    ClassConstants constants = new ClassConstants(bytes.readAllBytes());
                    constants.strings().forEach(text -> addAll(marked, MARKED, text));
                    lookedUp.addAll(constants.predicates());
                }
            }
            addAll(marked, Pattern.compile("(?m)^[+-]!(\\w+)"), plansForMessages(classes));
        }
        assertTrue(marked.containsAll(Set.of("p__f", "f__l", "f__g", "jag_sleeping", "kqml_received")),
                marked::toString);
        marked.forEach(JasonsNamesTest::assertRefused);
        assertTrue(lookedUp.contains("provider"), lookedUp::toString);
        lookedUp.removeAll(marked);
        lookedUp.removeAll(HARMLESS);
        assertEquals(Set.of(), lookedUp, "look what these mean to Jason, and refuse them or add them here");
    }

    private static String plansForMessages(JarFile classes) throws IOException {
        try (InputStream plans = classes.getInputStream(classes.getEntry("asl/kqmlPlans.asl"))) {
            return new String(plans.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static void addAll(Set<String> names, Pattern pattern, String text) {
        for (Matcher name = pattern.matcher(text); name.find();) {
            names.add(name.group(1));
        }
    }

    private static void assertRefused(String name) {
        assertThrows(Gate.RefusedException.class,
                () -> Gate.admit(ASSyntax.createLiteral(name, ASSyntax.createNumber(1))),
                name);
    }
}
