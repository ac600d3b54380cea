package uppaal;

import java.util.Random;
import uppaal.network.Network;

/** Networks that nobody drew: three automata, a clock, all kinds of channels and locations, guards and assignments. */
public final class RandomNetworks {
    private static final String[] LOCATIONS = {"a~", "b", "c!", "d{t<=1}"};
    private static final String[] SYNCHRONISATIONS = {"", "", "one!", "one?", "all!", "all?", "all?"};
    private static final String[] GUARDS =
            {"", "", "x > 0", "y != x", "x + y < 3", "x == 2 imply y == 0", "!(x == 1)", "t >= 1", "t <= 1"};
    private static final String[] ASSIGNMENTS =
            {"", "", "x = 0", "y = x", "x = 2 - y", "x = y, y = 1", "y = 2", "t = 0"};

    private RandomNetworks() {
    }

    /** The one of a seed. */
    public static Network network(long seed) {
        Random random = new Random(seed);
        Sketch sketch = Sketch.of("chan one; broadcast chan all; int[0,2] x = 1, y; clock t;");
        for (String name : new String[] {"P", "Q", "S"}) {
            String[] edges = new String[4 + random.nextInt(5)];
            for (int i = 0; i < edges.length; i++) {
                edges[i] = (i == 0 ? "a~" : pick(LOCATIONS, random)) + " -> " + pick(LOCATIONS, random)
                        + label("guard", GUARDS, random) + label("sync", SYNCHRONISATIONS, random)
                        + label("set", ASSIGNMENTS, random);
            }
            sketch.template(name, edges);
        }
        return sketch.network();
    }

    private static String label(String kind, String[] choices, Random random) {
        String choice = pick(choices, random);
        return choice.isEmpty() ? "" : "; " + kind + " " + choice;
    }

    private static String pick(String[] choices, Random random) {
        return choices[random.nextInt(choices.length)];
    }
}
