package live;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.regex.Pattern;

/** The files of the page and of its libraries, from the class path. */
final class PageFiles {

    /** No folder, no way upwards, and nothing that a class path could have beside. */
    private static final Pattern PATH = Pattern.compile("([A-Za-z0-9_-][A-Za-z0-9._-]*/)*[A-Za-z0-9_-][A-Za-z0-9._-]*");
    private static final Map<String, String> TYPES = Map.of("html", "text/html;charset=utf-8", "js",
            "text/javascript;charset=utf-8", "css", "text/css;charset=utf-8", "svg", "image/svg+xml", "png",
            "image/png", "map", "application/json");

    private PageFiles() {
    }

    /**
     * A file to be sent.
     *
     * @param type for {@code Content-Type}.
     */
    record PageFile(String type, byte[] content) {
    }

    /** A file of the page. */
    static Optional<PageFile> app(String path) throws IOException {
        return read("live/app/", path);
    }

    /** A file of a WebJar, {@code name/path}, whatever its version. */
    static Optional<PageFile> library(String path) throws IOException {
        int slash = path.indexOf('/');
        if (slash < 0 || !PATH.matcher(path).matches()) {
            return Optional.empty();
        }
        String name = path.substring(0, slash);
        Properties about = new Properties();
        try (InputStream in = open("META-INF/maven/org.webjars.npm/" + name + "/pom.properties")) {
            if (in == null) {
                return Optional.empty();
            }
            about.load(in);
        }
        return read("META-INF/resources/webjars/" + name + "/" + about.getProperty("version") + "/",
                path.substring(slash + 1));
    }

    private static Optional<PageFile> read(String folder, String path) throws IOException {
        String type = TYPES.get(path.substring(path.lastIndexOf('.') + 1));
        if (type == null || !PATH.matcher(path).matches()) {
            return Optional.empty();
        }
        try (InputStream in = open(folder + path)) {
            return in == null ? Optional.empty() : Optional.of(new PageFile(type, in.readAllBytes()));
        }
    }

    private static InputStream open(String resource) {
        return PageFiles.class.getClassLoader().getResourceAsStream(resource);
    }
}
