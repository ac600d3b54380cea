package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import trace.TraceEvent;
import trace.TraceReader;

/** Programs of the sources in test/system/timers, and runs of them without hosts. */
final class SketchBuild {

    static final Path ROOT = Path.of(System.getProperty("javino.root"));
    static final Path SOURCES = ROOT.resolve("test/system/timers");
    private static final Path AVR = Path.of("/usr/share/arduino/hardware/arduino/avr");

    private SketchBuild() {
    }

    /**
     * Compiles as the Arduino IDE does, with core and library as gradle has built them for that board.
     *
     * @param board uno, leonardo or mega.
     * @return what the compiler says; without a program if it refuses the sources.
     */
    static String compile(String board, List<String> options, List<String> sources, Path program) throws Exception {
        Files.deleteIfExists(program);
        List<String> chip = switch (board) {
            case "uno" -> List.of("atmega328p", "standard");
            case "leonardo" -> List.of("atmega32u4", "leonardo");
            default -> List.of("atmega2560", "mega");
        };
        List<String> command = new ArrayList<>(List.of("avr-g++", "-w", "-Os", "-std=gnu++11", "-fno-exceptions",
                "-ffunction-sections", "-fdata-sections", "-fno-threadsafe-statics", "-flto", "-fuse-linker-plugin",
                "-Wl,--gc-sections", "-mmcu=" + chip.get(0), "-DF_CPU=16000000L", "-DARDUINO=10819",
                "-DARDUINO_ARCH_AVR", "-DDECIMAL_DIG=__DECIMAL_DIG__", "-DUSB_VID=1", "-DUSB_PID=1",
                "-I" + AVR.resolve("cores/arduino"), "-I" + AVR.resolve("variants/" + chip.get(1)),
                "-I" + AVR.resolve("libraries/EEPROM/src"), "-I" + ROOT.resolve("javino-firmware/src")));
        command.addAll(options);
        sources.forEach(source -> command.add(SOURCES.resolve(source).toString()));
        command.addAll(List.of("-o", program.toString(),
                newest(board.equals("mega") ? "blink" : "blink-" + board, "JavinoBDI.a"),
                newest("core/" + board, "core.*\\.a"), "-lm"));
        Process compiler = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(compiler.getInputStream().readAllBytes());
        compiler.waitFor();
        return said;
    }

    /** The newest archive in one of the folders of javino-firmware/build: tools name them in different ways. */
    private static String newest(String folder, String archive) throws IOException {
        try (Stream<Path> files = Files.walk(ROOT.resolve("javino-firmware/build").resolve(folder))) {
            return files.map(Path::toFile).filter(file -> file.getName().matches(archive))
                    .max(Comparator.comparing(File::lastModified)).orElseThrow().getPath();
        }
    }

    /** The trace of a run as fast as it can. */
    static List<TraceEvent> emulate(Path folder, int seconds, String scenario) throws Exception {
        Path file = Files.writeString(folder.resolve("scenario.json"), scenario);
        Path trace = folder.resolve("trace.jsonl");
        Process emulator = new ProcessBuilder(ROOT.resolve("emulator/build/javino-emulator").toString(),
                file.toString(), "--directory", folder.toString(), "--trace", trace.toString(), "--speed", "max",
                "--seed", "1", "--duration", "" + seconds).redirectErrorStream(true).start();
        String said = new String(emulator.getInputStream().readAllBytes());
        assertEquals(0, emulator.waitFor(), said);
        List<TraceEvent> events = new ArrayList<>();
        TraceReader.read(trace, events::add);
        return events;
    }
}
