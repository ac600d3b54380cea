package live;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** The user's browser. */
final class Browser {

    private Browser() {
    }

    private static boolean isLinux() {
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        return !system.contains("mac") && !system.contains("windows");
    }

    /** Whether this computer can show a browser. */
    static boolean hasScreen() {
        return !isLinux() || System.getenv("DISPLAY") != null || System.getenv("WAYLAND_DISPLAY") != null;
    }

    /** This computer's name for others, as far as it knows. */
    static String host() {
        try {
            return InetAddress.getLocalHost().getHostName();
        } catch (UnknownHostException e) {
            return "HOST";
        }
    }

    /** Opens an address; where there is no browser, the address that was printed has to do. */
    static void open(String address) {
        if (!hasScreen()) {
            return;
        }
        boolean mac = System.getProperty("os.name").toLowerCase(Locale.ROOT).contains("mac");
        try {
            // The others on this computer can read a command, but not this file: it has the token.
            Path page = Files.createTempFile("javino", ".html");
            page.toFile().deleteOnExit();
            Files.writeString(page, "<meta http-equiv=\"refresh\" content=\"0;url=" + address + "\">\n");
            String url = page.toUri().toString();
            new ProcessBuilder(isLinux() ? List.of("xdg-open", url)
                    : mac ? List.of("open", url)
                            : List.of("rundll32", "url.dll,FileProtocolHandler", url))
                    .redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
        } catch (IOException e) {
            // There is none.
            return;
        }
    }
}
