package systemtest;

import harness.Emulator;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
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

    private void command(Map<String, Object> command) throws InterruptedException {
        int before = (int) emulator.trace().stream().filter(COMMANDS).count();
        emulator.command(command);
        emulator.await(command.toString(), before + 1, COMMANDS);
    }
}
