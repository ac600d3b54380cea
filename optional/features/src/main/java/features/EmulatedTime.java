package features;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import lockstep.AgentProgram;
import lockstep.Simulation;

/** Emulated time: boards, agents and the test are one simulation, which is the same again with the same seed. */
final class EmulatedTime implements Engine {

    private final Account account;
    private final Simulation simulation;
    private AgentProgram program;

    /**
     * Starts the boards.
     *
     * @param command the emulator with its scenario and options.
     * @param ports   the ports of the scenario's boards, in their order.
     * @param account is told of all.
     */
    EmulatedTime(List<String> command, List<String> ports, long seed, Path trace, Account account) throws IOException {
        this.account = account;
        simulation = Simulation.start(command, ports, seed, Simulation.JITTER, trace,
                line -> account.traced(line, nanos -> nanos));
    }

    @Override
    public long nanos() {
        return simulation.nanos();
    }

    @Override
    public boolean runUntil(BooleanSupplier wanted, long end) {
        return simulation.runUntil(wanted, end);
    }

    @Override
    public void at(long nanos, Runnable action) {
        simulation.at(nanos, action);
    }

    @Override
    public void command(Map<String, Object> command) throws IOException {
        simulation.perform(command);
    }

    @Override
    public AgentProgram.Agents start(Path file) throws IOException {
        program = AgentProgram.observe(simulation, file, account);
        return program.agents();
    }

    @Override
    public void close() {
        try {
            if (program != null) {
                program.close();
            }
        } finally {
            simulation.close();
        }
    }
}
