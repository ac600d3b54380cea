package lockstep.agents;

import java.util.Collections;
import java.util.List;
import java.util.Random;

/** Chance by the seed, for those of Jason's classes that ask {@link Random} or {@link Collections} for it. */
public final class Dice extends Random {

    private static final long serialVersionUID = 1;

    public Dice() {
        super(Clock.simulation().random().nextLong());
    }

    public static void shuffle(List<?> list) {
        Collections.shuffle(list, new Dice());
    }
}
