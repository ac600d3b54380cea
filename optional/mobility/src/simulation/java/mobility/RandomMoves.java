package mobility;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;

import javino.protocol.Address;
import javino.protocol.Bytes;

import simulation.Attacker;
import simulation.Network;
import simulation.SimulatedHost;

/** Moves of some agents to and fro in a {@link Simulation}, with whatever goes wrong, and what came of them. */
public final class RandomMoves {

    /** So many times agents are told to move in one run. */
    public static final int MOVES = 40;
    /** So many messages an attacker sends meanwhile. */
    private static final int ACTS = 5;

    /** The first of them, or more, move in each run. */
    private static final List<String> AGENTS = List.of("inspector", "porter", "guide", "clerk");

    /**
     * The results of a run.
     *
     * @param refusing moves begun to a MAS that admitted nobody then.
     * @param lost     messages that did not arrive.
     * @param faults   kills and resets, by what the program was about to do or had just done.
     * @param wrong    messages accepted or keys set that should not have been.
     * @param both     times at which two were awake, with what was known.
     * @param changed  agents that, as those lost and doubled, are not as before when contact has been back for long.
     * @param unasked  arrivals that no plan had admitted.
     * @param unended  records of moves then that had not ended.
     */
    public record Tally(long begun, long arrived, long refusing, long messages, long lost,
            Map<String, Integer> faults, List<String> wrong, List<String> both, long lostAgents, long doubled,
            long changed,
            long unasked, int unended,
            List<String> told) {
    }

    private RandomMoves() {
    }

    /** Between hosts whose boards have keys for each other. @param folder for the records of both; empty. */
    public static Tally run(long seed, Path folder) {
        return run(seed, new Simulation(seed, folder));
    }

    /** Between hosts of any kind. @param maker makes the host that has an address. */
    public static Tally run(long seed, Path folder, BiFunction<Network<?>, Address, SimulatedHost> maker) {
        return run(seed, new Simulation(seed, folder, maker));
    }

    private static Tally run(long seed, Simulation simulation) {
        List<String> agents = AGENTS.subList(0, 1 + (int) (seed % AGENTS.size()));
        Set<List<Bytes>> known = new HashSet<>();
        simulation.lived = old -> {
            // Its state is another at each move, so that something of it travels each time.
            byte[] state = new byte[100 + simulation.random.nextInt(1500)];
            simulation.random.nextBytes(state);
            List<Bytes> now = List.of(old.get(0), Bytes.ofText(Bytes.copyOf(state).hex()));
            known.add(now);
            return now;
        };
        List<Simulation.Side> sides = List.of(simulation.side(Simulation.STATION), simulation.side(Simulation.BUS));
        for (String agent : agents) {
            List<Bytes> texts = List.of(Bytes.ofText(("+!" + agent + "(" + seed + ") <- a(X); b(X).\n").repeat(5)),
                    Bytes.ofText("x".repeat(simulation.random.nextInt(2000)) + seed));
            known.add(texts);
            sides.get(simulation.random.nextInt(2)).program.put(agent, texts);
        }
        simulation.watched.addAll(agents);
        sides.forEach(side -> side.host.start());
        Attacker attacker = simulation.attacker(List.of(Simulation.STATION, Simulation.BUS));
        long begun = 0;
        long refusing = 0;
        for (int i = 0; i < MOVES; i++) {
            disturb(simulation);
            for (int act = 0; act < ACTS; act++) {
                simulation.after(simulation.random.nextInt(60_000), attacker::act);
            }
            sides.forEach(side -> side.admits = simulation.random.nextInt(8) > 0);
            sides.stream().filter(side -> side.host.on).forEach(
                    side -> side.program.keySet().forEach(agent -> forge(simulation, side, agent)));
            for (Simulation.Side side : sides) {
                Simulation.Side other = sides.get(1 - sides.indexOf(side));
                for (String agent : agents) {
                    if (side.host.on && side.awake.containsKey(agent)) {
                        begun++;
                        refusing += other.admits ? 0 : 1;
                        side.depart(agent, simulation.random.nextBoolean() ? Protocol.MUTUALISM : Protocol.INQUILINISM,
                                other.address);
                    }
                }
            }
            simulation.runUntil(simulation.millis() + simulation.random.nextInt(20_000));
            simulation.contact = simulation.random.nextInt(4) > 0;
            simulation.runUntil(simulation.millis() + simulation.random.nextInt(100_000));
        }
        simulation.calm();
        simulation.runUntil(simulation.millis() + agents.size() * 600_000L);
        List<String> told = new ArrayList<>();
        sides.forEach(side -> told.addAll(side.told));
        return new Tally(begun, simulation.arrivals, refusing, simulation.messages, simulation.air.lost,
                simulation.faults, simulation.wrong, simulation.both,
                agents.stream().filter(agent -> simulation.awake(agent) == 0).count(),
                agents.stream().filter(agent -> simulation.awake(agent) > 1).count(),
                sides.stream().flatMap(side -> side.awake.entrySet().stream())
                        .filter(agent -> !known.contains(agent.getValue()) || !isOf(agent.getKey(), agent.getValue()))
                        .count(),
                simulation.unasked, sides.stream().mapToInt(side -> side.open().size()).sum(), told);
    }

    /** An agent that finds its name taken has digits behind it. */
    private static boolean isOf(String name, List<Bytes> texts) {
        return texts.get(0).hex().startsWith(Bytes.ofText("+!" + name.replaceAll("\\d+$", "") + "(").hex());
    }

    /** Somebody knows all of an agent that is at home there or away but its token; he knows those of earlier trips. */
    private static void forge(Simulation simulation, Simulation.Side home, String agent) {
        List<Bytes> drawn = home.drawn.getOrDefault(agent, List.of());
        byte[] token = new byte[Move.Identity.TOKEN_LENGTH];
        simulation.random.nextBytes(token);
        Bytes wrong = drawn.size() < 2 ? Bytes.copyOf(token) : drawn.get(simulation.random.nextInt(drawn.size() - 1));
        Address from =
                List.of(Simulation.STATION, Simulation.BUS, Simulation.HOSPITAL).get(simulation.random.nextInt(3));
        simulation.forge(home, from, Protocol.values()[simulation.random.nextInt(Protocol.values().length)],
                new Move.Identity(home.address, agent, wrong));
    }

    private static void disturb(Simulation simulation) {
        simulation.lost = simulation.random.nextDouble() * 0.3;
        simulation.untold = simulation.random.nextDouble() * 0.2;
        simulation.again = simulation.random.nextDouble() * 0.2;
        simulation.victim = simulation.random.nextBoolean() ? Simulation.STATION : Simulation.BUS;
        simulation.fault = Network.Fault.values()[simulation.random.nextInt(Network.Fault.values().length)];
        simulation.faultAfter = simulation.random.nextInt(30) - 5;
        simulation.air.errors = simulation.random.nextInt(3) * 5e-4;
        simulation.twice = simulation.random.nextInt(3) * 0.2;
        simulation.late = simulation.random.nextInt(3) * 0.1;
    }
}
