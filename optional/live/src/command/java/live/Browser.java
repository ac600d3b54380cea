package live;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** The user's browser. */
final class Browser {

    private Browser() {
    }

    /** Opens an address; where there is no browser, the address that was printed has to do. */
    static void open(String address) {
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        boolean linux = !system.contains("mac") && !system.contains("windows");
        if (linux && System.getenv("DISPLAY") == null && System.getenv("WAYLAND_DISPLAY") == null) {
            return;
        }
        try {
            // The others on this computer can read a command, but not this file: it has the token.
            Path page = Files.createTempFile("javino", ".html");
            page.toFile().deleteOnExit();
            Files.writeString(page, "<meta http-equiv=\"refresh\" content=\"0;url=" + address + "\">\n");
            String url = page.toUri().toString();
            new ProcessBuilder(linux ? List.of("xdg-open", url)
                    : system.contains("mac") ? List.of("open", url)
                            : List.of("rundll32", "url.dll,FileProtocolHandler", url))
                    .redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
        } catch (IOException e) {
            // There is none.
            return;
        }
    }
}
