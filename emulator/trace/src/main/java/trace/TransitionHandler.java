package trace;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.logging.ErrorManager;
import java.util.logging.Handler;
import java.util.logging.LogManager;
import java.util.logging.LogRecord;

/**
 * Has the emulator write into its trace in which state a host's machine is. Whoever logs that goes on when it is there:
 * so it stands behind what the board had handed over, and before what the host says because of it.
 */
public final class TransitionHandler extends Handler {

    private static final String CONTROL = TransitionHandler.class.getName() + ".control";
    private static final List<String> PARAMETERS = List.of("machine", "host", "peer", "id", "state");

    private final EmulatorControl emulator;

    /** A handler by {@link #configuration}. */
    public TransitionHandler() {
        this(EmulatorControl.at(Path.of(LogManager.getLogManager().getProperty(CONTROL))));
    }

    public TransitionHandler(EmulatorControl emulator) {
        this.emulator = emulator;
    }

    /** The lines of a configuration of loggers that make this a handler of the logger. */
    public static String configuration(String logger, Path control) {
        return String.format("%n%s.handlers = %s%n%s.level = FINE%n%s = %s%n", logger,
                TransitionHandler.class.getName(), logger, CONTROL, control);
    }

    @Override
    public void publish(LogRecord transition) {
        if (!isLoggable(transition)) {
            return;
        }
        Map<String, String> command = new LinkedHashMap<>(Map.of("do", "transition"));
        for (int i = 0; i < PARAMETERS.size(); i++) {
            command.put(PARAMETERS.get(i), transition.getParameters()[i].toString());
        }
        command.computeIfPresent("state", (state, name) -> name.toLowerCase(Locale.ROOT));
        try {
            emulator.perform(command);
        } catch (IOException failed) {
            reportError("the trace lacks a transition", failed, ErrorManager.WRITE_FAILURE);
        }
    }

    @Override
    public void flush() {}

    @Override
    public void close() {}
}
