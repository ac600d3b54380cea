package lockstep;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Stream;
import trace.EmulatorControl;

/** An emulator that goes on by itself. */
final class RealTimeEmulator extends EmulatorProcess implements RunningEmulator {

    private final EmulatorControl control;
    private final Thread reader;

    RealTimeEmulator(List<String> command, Path folder, Consumer<String> lines) throws IOException {
        super(new ProcessBuilder(Stream.concat(command.stream(), Stream.of("--trace", "-", "--control", CONTROL))
                .toList()).directory(folder.toFile()));
        control = EmulatorControl.at(folder.resolve(CONTROL));
        reader = read(process.inputReader(StandardCharsets.UTF_8), lines);
        traceTransitions(control);
    }

    @Override
    public void perform(Map<String, ?> command) throws IOException {
        control.perform(command);
    }

    @Override
    public void readTrace() {
        if (!process.isAlive()) {
            join(reader);
        }
    }

    @Override
    public ProcessHandle process() {
        return process.toHandle();
    }

    @Override
    public void close() {
        forgetTransitions();
        process.toHandle().destroy();
        int status = awaitEnd();
        join(reader);
        check(status);
    }
}
