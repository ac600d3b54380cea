package bench;

import com.google.gson.Gson;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javino.protocol.Airtime;
import trace.TraceEvent;

/** A run, as fast as it goes, of boards that send or receive all the time at one bit rate; counts their cycles. */
final class Probe {

    /** The length of what a board of {@code Modem} or {@code SampledModem} sends: the longest packet. */
    static final int PACKET_BITS = Airtime.bits(77);

    private static final double CYCLES_PER_SECOND = 16e6;
    private static final int SENDER_PIN = 40;
    private static final int EEPROM_LENGTH = 4096;

    private final double seconds;
    private final List<TraceEvent> trace;

    private Probe(double seconds, List<TraceEvent> trace) {
        this.seconds = seconds;
        this.trace = trace;
    }

    /**
     * Runs one sender, {@code tx}, and some receivers, {@code rx0}…
     *
     * @param sketch  {@code Modem} or {@code SampledModem}.
     * @param bitRate in bit/s.
     * @param seconds emulated time.
     */
    static Probe run(String sketch, int bitRate, int senders, int receivers, double seconds)
            throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("javino-bench");
        List<Map<String, Object>> boards = new ArrayList<>();
        for (int i = 0; i < senders; i++) {
            boards.add(board("tx" + i, sketch, folder, bitRate,
                    Map.of("type", "digital", "pin", SENDER_PIN, "level", List.of(List.of(0, 1)))));
        }
        for (int i = 0; i < receivers; i++) {
            boards.add(board("rx" + i, sketch, folder, bitRate, Map.of()));
        }
        Path scenario = Files.writeString(folder.resolve("scenario.json"),
                new Gson().toJson(Map.of("radio", Map.of("bitRate", bitRate), "boards", boards)));
        List<String> lines = Command.run(Machine.program("probe"), scenario, folder, seconds);
        return new Probe(seconds, lines.stream().map(line -> TraceEvent.parse(1, line)).toList());
    }

    private static Map<String, Object> board(String name, String sketch, Path folder, int bitRate,
            Map<String, Object> sensor)
            throws IOException {
        byte[] eeprom = new byte[EEPROM_LENGTH];
        Arrays.fill(eeprom, (byte) 0xFF);
        eeprom[EEPROM_LENGTH - 2] = (byte) bitRate;
        eeprom[EEPROM_LENGTH - 1] = (byte) (bitRate >> 8);
        Files.write(folder.resolve(name), eeprom);
        Map<String, Object> board = new LinkedHashMap<>(
                Map.of("name", name, "firmware", Machine.firmware(sketch).toString(), "eeprom", name));
        if (!sensor.isEmpty()) {
            board.put("sensors", List.of(sensor));
        }
        return board;
    }

    /** The share of a board's cycles that some interrupts took, in percent. */
    double load(String board, List<Integer> vectors) {
        double cycles = trace.stream()
                .filter(event -> event.is("interrupts", board) && vectors.contains(event.number("vector")))
                .mapToDouble(event -> event.number("cycles")).sum();
        if (cycles == 0) {
            throw new IllegalStateException("of the interrupts " + vectors + " none has run on " + board);
        }
        return 100 * cycles / (seconds * CYCLES_PER_SECOND);
    }

    /** Emulated seconds for each second of this machine's CPU. */
    double timesRealTime() {
        double microseconds = trace.stream().filter(event -> event.name().equals("cpu")).findFirst().orElseThrow()
                .number("microseconds");
        return seconds / (microseconds / 1e6);
    }

    /** Packets that were on the air early enough to be printed by receivers. */
    long sent() {
        return trace.stream().filter(event -> event.is("rf-tx", "tx0") && event.seconds() < seconds - 0.05).count();
    }

    /** Packets that the first receiver has printed. */
    long received() {
        return trace.stream().filter(event -> event.is("uart", "rx0")).count();
    }
}
