package campaign;

import java.nio.file.Path;
import java.time.Duration;

/**
 * How campaigns are run.
 *
 * @param seed  the number from which all random numbers start.
 * @param small whether to try little, for {@code gradle verify}: the same paths in seconds.
 * @param soak  wall time that the soak takes; positive.
 * @param moves moves on emulated boards; 0 for as many as fit into ten emulated minutes.
 * @param root  the top of the repository.
 */
public record Settings(long seed, boolean small, Duration soak, int moves, Path root) {

    /** The one for campaigns or, if small, the other for {@code gradle verify}. */
    public <T> T choose(T campaign, T test) {
        return small ? test : campaign;
    }
}
