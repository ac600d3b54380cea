package campaign;

import java.nio.file.Path;
import java.util.Map;

/** The firmware that today's is compared with, which gradle builds from the repository's history. */
final class Before {

    /** The last one that bears a single wrong symbol of a packet. As in test/campaign/build.gradle. */
    static final String COMMIT = "74cea8e";

    /** What a scenario says of a board that runs it: its program for a Mega. */
    static final Map<String, Object> BOARD = Map.of("firmware",
            Path.of(System.getProperty("javino.root"), "test/campaign/build/before", COMMIT, "Station.ino.elf")
                    .toString());

    private Before() {}
}
