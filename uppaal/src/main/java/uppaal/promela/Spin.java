package uppaal.promela;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.check.Property;
import uppaal.network.Network;
import uppaal.tool.Tool;

/**
 * Has SPIN check a network: once without any claim, which gives the number of states and its own search for
 * deadlocks, and once for each property. SPIN's optimisations and its partial order reduction are off,
 * since the number of states is to be that of the network. Its analysers end with 0 also when they find errors.
 */
public final class Spin {
    private static final Pattern STATES = Pattern.compile("([0-9.e+]+) states, stored");
    private static final Pattern ERRORS = Pattern.compile("errors: ([0-9]+)");
    private static final String RANGE_LEFT = "assertion violated";
    private static final String INVALID_END = "invalid end state (at depth";
    private static final String TOO_DEEP = "max search depth too small";

    private final Path folder;

    private Spin(Path folder) {
        this.folder = folder;
    }

    /**
     * What SPIN found.
     *
     * @param states how many states can be reached
     * @param deadlock whether one of them has no next state
     * @param holds for each property whether it holds
     */
    public record Result(long states, boolean deadlock, List<Boolean> holds) {
    }

    /** Whether {@code spin} and {@code gcc} are on the path. */
    public static boolean available() {
        return Tool.onPath("spin") && Tool.onPath("gcc");
    }

    /**
     * Checks a network.
     *
     * @param folder for the files that SPIN and the compiler make
     * @throws IOException when SPIN or the compiler fails, or the search was not complete
     */
    public static Result check(Network network, List<Property> properties, Path folder) throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("network.pml"), PromelaWriter.write(network, properties));
        Spin spin = new Spin(folder);
        Tool.run(folder, "spin", "-o1", "-o2", "-o3", "-a", "network.pml");
        String output = spin.searchStates();
        List<Boolean> holds = properties.isEmpty() ? List.of() : spin.verdicts(properties);
        return new Result((long) Double.parseDouble(find(STATES, output)), output.contains(INVALID_END), holds);
    }

    private String searchStates() throws IOException {
        Tool.run(folder, "gcc", "-w", "-O0", "-DSAFETY", "-DNOREDUCE", "-DNOCLAIM", "-o", "states", "pan.c");
        String output = Tool.run(folder, "./states", "-c0", "-n", "-b", "-m100000", "-w18");
        if (output.contains(RANGE_LEFT)) {
            throw new IOException("SPIN: a variable leaves its range");
        }
        return complete(output);
    }

    private List<Boolean> verdicts(List<Property> properties) throws IOException {
        Tool.run(folder, "gcc", "-w", "-O0", "-DSAFETY", "-DNOREDUCE", "-o", "claims", "pan.c");
        List<Boolean> verdicts = new ArrayList<>();
        for (int i = 0; i < properties.size(); i++) {
            String output = complete(
                    Tool.run(folder, "./claims", "-N", PromelaWriter.claim(i), "-n", "-b", "-m100000", "-w18"));
            boolean settled = !find(ERRORS, output).equals("0");
            verdicts.add(settled == (properties.get(i).quantifier() == Property.Quantifier.POSSIBLY));
        }
        return List.copyOf(verdicts);
    }

    private static String complete(String output) throws IOException {
        if (output.contains(TOO_DEEP)) {
            throw new IOException("SPIN's search is deeper than its limit: raise -m");
        }
        return output;
    }

    private static String find(Pattern pattern, String output) throws IOException {
        Matcher matcher = pattern.matcher(output);
        if (!matcher.find()) {
            throw new IOException("SPIN's output is not understood: " + output.strip());
        }
        return matcher.group(1);
    }
}
