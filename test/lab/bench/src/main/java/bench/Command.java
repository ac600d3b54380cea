package bench;

import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;

/** A program that runs to its end. */
final class Command {

    private Command() {}

    /** The lines that it prints; throws with what it complained of if it fails. */
    static List<String> run(Object... words) throws IOException, InterruptedException {
        List<String> command = Stream.of(words).map(String::valueOf).toList();
        Process process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
        List<String> lines = process.inputReader().lines().toList();
        if (process.waitFor() != 0) {
            throw new IOException(String.join(" ", command) + " ended with " + process.exitValue());
        }
        return lines;
    }
}
