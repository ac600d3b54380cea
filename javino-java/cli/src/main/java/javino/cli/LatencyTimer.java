package javino.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.OptionalInt;

/**
 * The timer of an FTDI chip in a port: bytes from the board wait in the chip until it ends. Linux shows it as a file,
 * in ms (1…255, 16 at first), which root may write. Other ports and other systems have no such file.
 */
final class LatencyTimer {

    private static final int SHORTEST_MILLIS = 1;

    private final String port;
    private final Path sysfs;

    /**
     * @param port  a path, whose symbolic links are followed, or the system's name of a port.
     * @param sysfs the folder in which the system shows its devices, {@code /sys}.
     */
    LatencyTimer(String port, Path sysfs) {
        this.port = port;
        this.sysfs = sysfs;
    }

    /**
     * Sets a slow timer to 1 ms where this user may, and says what it found; nothing where the port has no such timer.
     * To be called after the port was opened: that asks the driver for 1 ms too, and what is left is what an agent
     * meets.
     */
    void examine(Findings findings) {
        OptionalInt found = millis();
        if (found.isEmpty()) {
            return;
        }
        int millis = found.getAsInt();
        if (millis <= SHORTEST_MILLIS) {
            findings.ok("latency", millis + " ms");
        } else if (isShortened()) {
            findings.ok("latency", "set from " + millis + " to 1 ms until the board is plugged in again; for good by a "
                    + "udev rule (docs/errors.md)");
        } else {
            findings.trouble("latency", "the port's FTDI chip holds bytes back for " + millis + " ms; sudo setserial "
                    + port + " low_latency, or for good a udev rule (docs/errors.md)");
        }
    }

    private boolean isShortened() {
        try {
            Files.writeString(file(), Integer.toString(SHORTEST_MILLIS), StandardOpenOption.WRITE,
                    StandardOpenOption.TRUNCATE_EXISTING);
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    private OptionalInt millis() {
        try {
            return OptionalInt.of(Integer.parseInt(Files.readString(file()).strip()));
        } catch (IOException e) {
            return OptionalInt.empty();
        }
    }

    private Path file() throws IOException {
        Path path = Path.of(port);
        Path device = Files.exists(path) ? path.toRealPath() : path;
        return sysfs.resolve("bus/usb-serial/devices").resolve(device.getFileName()).resolve("latency_timer");
    }
}
