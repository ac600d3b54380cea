package systemtest;

import harness.SketchBoard;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A Cortex-M3, which QEMU emulates. `Serial` is a pty; a second line leads to the test (core/Arduino.h). */
final class ArmBoard implements SketchBoard {

    private static final Path PROGRAMS = Path.of(System.getProperty("javino.root"), "test/arm/build");
    private static final Pattern PTY = Pattern.compile("char device redirected to (\\S+) .*");
    private static final String LIT = "pin 13 1";
    private static final long PATIENCE_SECONDS = 240;

    private final Process process;
    private final PrintWriter input;
    private final String port;
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor();
    private List<Map<String, Object>> sensors = List.of();
    private int lit;

    private ArmBoard(Process process) throws IOException {
        this.process = process;
        input = new PrintWriter(process.outputWriter(), true);
        BufferedReader output = process.inputReader();
        String first = String.valueOf(output.readLine());
        Matcher pty = PTY.matcher(first);
        if (!pty.matches()) {
            throw new IOException("QEMU says: " + first);
        }
        port = pty.group(1);
        Thread reader = new Thread(() -> output.lines().filter(LIT::equals).forEach(line -> light()), "QEMU output");
        reader.setDaemon(true);
        reader.start();
    }

    /**
     * Starts a sketch.
     *
     * @param sensors as the emulator has them. Of an {@code ldr} the first value counts; a {@code digital} is pressed
     *                for one reading when its level rises; others are not there.
     */
    static ArmBoard start(String sketch, List<Map<String, Object>> sensors) throws IOException {
        Process process = new ProcessBuilder("qemu-system-arm", "-M", "mps2-an385", "-display", "none", "-monitor",
                "none", "-serial", "pty", "-serial", "stdio", "-kernel", PROGRAMS.resolve(sketch + ".elf").toString())
                .redirectErrorStream(true).start();
        Runtime.getRuntime().addShutdownHook(new Thread(process::destroyForcibly));
        try {
            ArmBoard board = new ArmBoard(process);
            board.connect(sensors);
            return board;
        } catch (IOException failed) {
            process.destroyForcibly();
            throw failed;
        }
    }

    private synchronized void connect(List<Map<String, Object>> connected) {
        sensors = connected;
        sensors.stream().filter(sensor -> sensor.get("type").equals("ldr"))
                .forEach(sensor -> analog((String) sensor.get("pin"), (int) points(sensor, "light").get(0).get(1)));
    }

    @SuppressWarnings("unchecked")
    private static List<List<Number>> points(Map<String, Object> sensor, String name) {
        return (List<List<Number>>) sensor.get(name);
    }

    /** With the lamp, time begins for what is pressed. */
    private synchronized void light() {
        if (lit++ == 0) {
            sensors.stream().filter(sensor -> sensor.get("type").equals("digital"))
                    .forEach(sensor -> points(sensor, "level").stream().filter(point -> point.get(1).intValue() == 1)
                            .forEach(point -> clock.schedule(() -> input.println("pulse " + sensor.get("pin")),
                                    (long) (1000 * point.get(0).doubleValue()), TimeUnit.MILLISECONDS)));
        }
        notifyAll();
    }

    @Override
    public String port() {
        return port;
    }

    @Override
    public void analog(String pin, int value) {
        input.println("analog " + pin.substring(1) + " " + value);
    }

    @Override
    public synchronized void awaitLit(int times) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (lit < times) {
            long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            if (left <= 0) {
                throw new AssertionError("the lamp was lit " + lit + " of " + times + " times");
            }
            wait(left);
        }
    }

    @Override
    public boolean isInEmulatedTime() {
        return false;
    }

    @Override
    public void reset() {
        input.println("reset");
    }

    @Override
    public void close() {
        clock.shutdownNow();
        process.destroyForcibly();
        try {
            process.waitFor();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
