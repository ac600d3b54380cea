package bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

import harness.Table;

/** The PC that the benchmarks run on, and where things are on it. */
final class Machine {

    /** The top of the repository. */
    static final Path ROOT = Path.of(System.getProperty("javino.root"));

    private Machine() {}

    /** Processor, cores and Java. */
    static String describe() throws IOException {
        Path cpuinfo = Path.of("/proc/cpuinfo");
        String model = !Files.exists(cpuinfo) ? System.getProperty("os.arch") : Files.readAllLines(cpuinfo).stream()
                .filter(line -> line.startsWith("model name")).map(line -> line.substring(line.indexOf(':') + 2))
                .findFirst()
                .orElse(System.getProperty("os.arch"));
        return Table.text("%s, %d cores, Java %s", model, Runtime.getRuntime().availableProcessors(),
                System.getProperty("java.version"));
    }

    /** The version of the compiler for the boards. */
    static String compiler() throws IOException, InterruptedException {
        return Command.run("avr-gcc", "-dumpversion").get(0);
    }

    /** The program that gradle has built of a sketch for a Mega. */
    static Path firmware(String sketch) {
        return firmware(sketch, "");
    }

    /** The same for an Uno. */
    static Path unoFirmware(String sketch) {
        return firmware(sketch, "-uno");
    }

    private static Path firmware(String sketch, String board) {
        return ROOT.resolve("javino-firmware/build/" + sketch.toLowerCase(java.util.Locale.ROOT) + board + "/" + sketch
                + ".ino.elf");
    }

    /** A program of test/lab/bench/native. */
    static Path program(String name) {
        return ROOT.resolve("test/lab/bench/build/native/" + name);
    }
}
