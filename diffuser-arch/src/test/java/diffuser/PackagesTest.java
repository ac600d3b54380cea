package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;

class PackagesTest {

    /** Each uses only those before it. */
    private static final List<String> FLOORS = List.of("diffuser.report", "diffuser.gate", "diffuser.board",
            "diffuser.mind", "diffuser");
    private static final Pattern CLASS = Pattern.compile("\\b(diffuser(\\.[a-z]\\w*)*)\\.[A-Z]");
    private static final Path SOURCES = Path.of(System.getProperty("javino.root"), "diffuser-arch/src/main/java");

    @Test
    void files_ofEachPackage_nameNoClassOfOneAboveIt() throws IOException {
        Set<String> upwards = new TreeSet<>();
        Set<String> packages = new TreeSet<>();
        try (Stream<Path> files = Files.walk(SOURCES.resolve("diffuser"))) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String own = SOURCES.relativize(file.getParent()).toString().replace('/', '.');
                packages.add(own);
                for (String used : used(Files.readString(file))) {
                    if (FLOORS.indexOf(used) > FLOORS.indexOf(own)) {
                        upwards.add(file.getFileName() + " names a class of " + used);
                    }
                }
            }
        }
        assertEquals(Set.copyOf(FLOORS), packages);
        assertEquals(Set.of(), upwards);
    }

    private static Set<String> used(String source) {
        return CLASS.matcher(source).results().map(found -> found.group(1)).collect(Collectors.toSet());
    }
}
