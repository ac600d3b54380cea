package diffuser;

import java.io.IOException;
import java.net.JarURLConnection;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLConnection;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The internal actions that programs can call by a name with a dot before it: Jason's and this library's. */
final class InternalActions {

    private static final String PACKAGE = "jason/stdlib";
    private static final Pattern CLASS = Pattern.compile("(?:.*/)?(\\w+)\\.class");
    /** How many letters a name may be away from one that was meant. */
    private static final int MOST_LETTERS = 2;

    private InternalActions() {
    }

    /**
     * Says that there is no such action, and which was perhaps meant.
     *
     * @param called such as {@code .actt}.
     */
    static String unknown(String called) {
        return "there is no internal action " + called
                + nearest(called.substring(1)).map(name -> "; did you mean ." + name + "?").orElse("");
    }

    private static Optional<String> nearest(String called) {
        return names().stream().filter(name -> distance(called, name) <= Math.min(MOST_LETTERS, called.length() - 1))
                .min(Comparator.comparingInt(name -> distance(called, name)));
    }

    private static Set<String> names() {
        Set<String> names = new TreeSet<>();
        try {
            for (URL url : Collections.list(InternalActions.class.getClassLoader().getResources(PACKAGE))) {
                readNames(url, names::add);
            }
        } catch (IOException | URISyntaxException e) {
            // Without names there is only no proposal.
            return names;
        }
        return names;
    }

    private static void readNames(URL folder, Consumer<String> taker) throws IOException, URISyntaxException {
        URLConnection connection = folder.openConnection();
        if (connection instanceof JarURLConnection jar) {
            readNames(jar.getJarFile().stream().map(entry -> entry.getName())
                    .filter(name -> name.lastIndexOf('/') == PACKAGE.length() && name.startsWith(PACKAGE)), taker);
        } else if (folder.getProtocol().equals("file")) {
            try (Stream<Path> files = Files.list(Path.of(folder.toURI()))) {
                readNames(files.map(file -> file.getFileName().toString()), taker);
            }
        }
    }

    private static void readNames(Stream<String> files, Consumer<String> taker) {
        files.map(CLASS::matcher).filter(Matcher::matches).map(found -> found.group(1)).forEach(taker);
    }

    /** Levenshtein's: the least number of letters to be added, left out or changed. */
    static int distance(String from, String to) {
        List<Integer> row = IntStream.rangeClosed(0, to.length()).boxed().toList();
        for (int i = 1; i <= from.length(); i++) {
            Integer[] next = new Integer[to.length() + 1];
            next[0] = i;
            for (int k = 1; k <= to.length(); k++) {
                int changed = row.get(k - 1) + (from.charAt(i - 1) == to.charAt(k - 1) ? 0 : 1);
                next[k] = Math.min(changed, 1 + Math.min(row.get(k), next[k - 1]));
            }
            row = List.of(next);
        }
        return row.get(to.length());
    }
}
