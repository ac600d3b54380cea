package bench;

import harness.Emulator;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicReference;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.SessionCounter;
import javino.link.SerialLink;

/** How many readings a second a serial line carries. */
final class Readings implements Subject {

    private static final int PERCEPTS = 40;
    private static final int READINGS = 200;
    private static final int FAST = 1_000_000;
    private static final int BITS_A_BYTE = 10;
    /** Sequence, header, status, flags, CRC, COBS for up to 508 bytes, zero (SPEC 4). */
    private static final int REPLY_BYTES = 1 + 10 + 1 + 1 + 2 + 2 + 1;
    private static final int RECORD_HEADER = 3;

    @Override
    public String name() {
        return "readings";
    }

    @Override
    public String method() {
        return """
            an emulated Mega with a sketch of 40 percepts that all change at each reading (`bench/sketches/Meter`) at
            real time, and a host over its pty: 200 sets of percepts as the listener is told of them, some 450 bytes
            each. The reference is what the line would carry if the board sent such replies one behind the other,
            without a poll and without the time in which it reads the sensors and writes the percepts.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        List<Row> rows = new ArrayList<>();
        rows.add(measure(SerialLink.DEFAULT_BAUD).goal("≥ 0.90"));
        rows.add(measure(FAST));
        return rows;
    }

    private static Row measure(int baud) throws Exception {
        Map<String, Object> wiring = Map.of("sensors",
                List.of(Map.of("type", "digital", "pin", 40, "level", List.of(List.of(0, baud == FAST ? 1 : 0)))));
        Semaphore told = new Semaphore(0);
        AtomicReference<List<String>> last = new AtomicReference<>();
        try (Emulator emulator =
                new Emulator.Scenario().board("board", "Meter", wiring)
                        .start(Files.createTempDirectory("javino-bench"));
                Board board = Board.open(SerialLink.opener(emulator.port("board"), baud), BoardConfig.create(),
                        new BoardListener() {
                            @Override
                            public void percepts(List<String> literals) {
                                last.set(literals);
                                told.release();
                            }
                        })) {
            board.percepts(true);
            told.acquire(READINGS / 10);
            long begun = System.nanoTime();
            told.acquire(READINGS);
            double rate = READINGS / ((System.nanoTime() - begun) / 1e9);
            int bytes = REPLY_BYTES + last.get().stream().mapToInt(literal -> RECORD_HEADER + literal.length()).sum();
            long repeats = board.counters().get(SessionCounter.REPEATS);
            return Row.against(
                    "%d percepts that change at each reading, %d baud (%d repeats)".formatted(PERCEPTS, baud, repeats),
                    "%.1f readings/s", rate, (double) baud / BITS_A_BYTE / bytes, "the line");
        }
    }
}
