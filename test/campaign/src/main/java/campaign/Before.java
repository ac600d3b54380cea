package campaign;

import java.nio.file.Path;

/** The firmware that today's is compared with, which gradle builds from the repository's history. */
final class Before {

    /** The last one that bears a single wrong symbol of a packet. As in test/campaign/build.gradle. */
    static final String COMMIT = "74cea8e";

    private Before() {}

    /** What a scenario says of a board that runs it: its program for a Mega. */
    static Path station() {
        return Path.of(System.getProperty("javino.root"), "test/campaign/build/before", COMMIT, "Station.ino.elf");
    }
}
