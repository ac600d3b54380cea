package javino.cli;

import java.util.concurrent.Callable;

/**
 * A command of {@code javino} that is in another library, with picocli's annotations.
 * {@link java.util.ServiceLoader} finds it where that library is on the class path.
 */
public interface CommandPlugin extends Callable<Integer> {
}
