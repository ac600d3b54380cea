package systemtest;

import harness.Emulator;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import javino.link.Time;
import lockstep.Simulation;
import trace.TraceEvent;

/** Disturbs boards by commands to their emulator; each has taken effect when its method returns. */
final class Nuisance {

    static final String RESET = "reset";
    static final String POWER_CUT = "power-cut";
    private static final double POWER_CUT_SECONDS = 0.1;
    private static final Predicate<TraceEvent> COMMANDS = event -> event.name().equals("command");
    /** A packet from somebody to somebody, as long as may be. */
    private static final String NOISE = HexFormat.of()
            .formatHex(("FACECAFEIY" + "x".repeat(67)).getBytes(StandardCharsets.US_ASCII));

    private final Emulator emulator;
    private final List<Integer> place;

    /** @param place the injector's */
    Nuisance(Emulator emulator, List<Integer> place) {
        this.emulator = emulator;
        this.place = place;
    }

    /** The injector sends a packet, without listening first, behind those that it has begun. */
    void send(String payload) throws InterruptedException {
        command(Map.of("do", "send", "position", place, "payload", payload));
    }

    /** Likewise, but as if he were a relay. */
    void sendCopy(String payload) throws InterruptedException {
        command(Map.of("do", "send", "position", place, "payload", payload, "hops", 1));
    }

    /** The injector takes the air for half a second. */
    void makeNoise() throws InterruptedException {
        send(NOISE);
    }

    /** Whoever is in range of that place hears random bits. */
    void jam(double seconds, List<Integer> position) throws InterruptedException {
        command(Map.of("do", "jam", "duration", seconds, "position", position));
    }

    /** A board is reset, or loses its power. */
    void cut(String board, String what) throws InterruptedException {
        command(what.equals(RESET) ? Map.of("do", what, "board", board)
                : Map.of("do", what, "board", board, "duration", POWER_CUT_SECONDS));
    }

    /** In real time a slower run leaves a test more time to react. */
    void speed(double times) throws InterruptedException {
        if (Simulation.here() == Time.REAL) {
            command(Map.of("do", "speed", "value", times));
        }
    }

    /** Waits until so much emulated time has passed. */
    void pass(double seconds) throws InterruptedException {
        if (Simulation.here() != Time.REAL) {
            Simulation.here().pause((long) (1e9 * seconds));
            return;
        }
        double end = now() + seconds;
        while (now() < end) {
            Thread.onSpinWait();
        }
    }

    /** Emulated time, by a command that changes nothing. */
    double now() throws InterruptedException {
        return command(Map.of("do", "light", "value", 0));
    }

    private double command(Map<String, Object> command) throws InterruptedException {
        int before = (int) emulator.trace().stream().filter(COMMANDS).count();
        emulator.command(command);
        return emulator.await(command.toString(), before + 1, COMMANDS).seconds();
    }
}
