package javino.cli;

import java.util.concurrent.Callable;

/**
 * A command of {@code javino} that is in another library, with picocli's annotations: where that library is on the class
 * path, {@link java.util.ServiceLoader} finds it.
 */
public interface FurtherCommand extends Callable<Integer> {
}
