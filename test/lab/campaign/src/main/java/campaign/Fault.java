package campaign;

import harness.Emulator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import trace.TraceEvent;

/**
 * One thing that goes wrong.
 *
 * @param pair   the pair that it befalls.
 * @param side   which of the two boards, 0 or 1.
 * @param second emulated time at which it begins.
 * @param writes for a power cut: after how many bytes written to the EEPROM from then on, at least 1.
 */
record Fault(Kind kind, int pair, int side, double second, int writes) {

    private static final double UNPLUGGED_SECONDS = 0.5;
    private static final double JAMMED_SECONDS = 1;
    private static final double DARK_SECONDS = 0.2;

    /** A kind of fault. */
    enum Kind {
        UNPLUG("serial port unplugged for 0.5 s"),
        RESET("board reset"),
        KILL("host killed (SIGKILL) and restarted"),
        JAM("radio jammed for 1 s"),
        POWER_CUT("power cut during an EEPROM write");

        private final String title;

        Kind(String title) {
            this.title = title;
        }

        String title() {
            return title;
        }
    }

    /** Has the emulator do it, where it is the emulator's to do. */
    void into(Emulator.Scenario scenario, String board, List<Double> position) {
        switch (kind) {
            case UNPLUG -> scenario.fault(second, board, "unplug").fault(second + UNPLUGGED_SECONDS, board, "plug");
            case RESET -> scenario.fault(second, board, "reset");
            case JAM ->
                scenario.fault(Map.of("t", second, "do", "jam", "duration", JAMMED_SECONDS, "position", position));
            case POWER_CUT -> {
                Map<String, Object> cut = new LinkedHashMap<>(Map.of("t", second, "board", board, "do", "power-cut"));
                cut.put("duration", DARK_SECONDS);
                cut.put("eepromWrites", writes);
                scenario.fault(cut);
            }
            case KILL -> {}
        }
    }

    /** When the cause ended, if an event of the trace, the first such one after its beginning, shows that it has. */
    OptionalDouble end(TraceEvent event, String board) {
        if (event.seconds() <= second) {
            return OptionalDouble.empty();
        }
        if (kind == Kind.JAM) {
            double end = second + JAMMED_SECONDS;
            return event.seconds() > end ? OptionalDouble.of(end) : OptionalDouble.empty();
        }
        return shows(event, board) ? OptionalDouble.of(event.seconds()) : OptionalDouble.empty();
    }

    private boolean shows(TraceEvent event, String board) {
        return switch (kind) {
            case UNPLUG -> event.is("port", board) && event.text("state").equals("plugged");
            case RESET -> event.is("reset", board) && event.text("why").equals("fault");
            case KILL -> event.is("port", board) && event.text("state").equals("open");
            case POWER_CUT -> event.is("reset", board) && event.text("why").equals("power");
            case JAM -> throw new AssertionError("its end is known beforehand");
        };
    }
}
