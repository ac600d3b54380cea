package mutation;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/**
 * The options of a run.
 *
 * @param wanted    how many mutants of each kind; each part has a number of its own if it is not said
 * @param survivors those that are known, with reasons
 * @param root      the top of the repository
 * @param recorded  a folder for what boards do with mutants of the firmware
 */
record Options(long seed, Optional<Integer> wanted, Survivors survivors, Path root, Path recorded) {

    /** How many mutants of a kind are tried, where this part would try so many. */
    int mutants(int usual) {
        return wanted.orElse(usual);
    }

    /** As many of all as are wanted, or all where there are no more, as the seed shuffles them. */
    <T> List<T> draw(List<T> all, int usual) {
        List<T> shuffled = new ArrayList<>(all);
        Collections.shuffle(shuffled, new Random(seed));
        return List.copyOf(shuffled.subList(0, Math.min(mutants(usual), shuffled.size())));
    }
}
