package uppaal.conformance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import trace.TraceReader;

/** {@code gradle checkTrace}: says in one line whether the model allows what a trace tells. */
public final class Main {
    private Main() {
    }

    /**
     * Ends with 0 where it does, with 1 where it does not, with 2 where the file is no trace.
     *
     * @param arguments the file, and one with the run's keys if those are known
     */
    public static void main(String[] arguments) {
        if (arguments.length == 0 || arguments.length > 2 || arguments[0].isEmpty()) {
            System.err.println("usage: gradle checkTrace -Ptrace=FILE [-Pkeys=FILE] (a trace of javino-emulator)");
            System.exit(2);
        }
        System.exit(run(Path.of(arguments[0]), arguments.length == 2 ? Path.of(arguments[1]) : null));
    }

    /** @param keys of the run; null where they are not known */
    static int run(Path file, Path keys) {
        for (Path each : keys == null ? List.of(file) : List.of(file, keys)) {
            if (!Files.isReadable(each)) {
                String why = Files.exists(each) ? "you may not read it" : "there is no such file";
                System.err.println("model: " + each + ": " + why);
                return 2;
            }
        }
        Replay replay = keys == null ? new Replay() : new Replay(keys);
        try {
            TraceReader.read(file, replay::event);
            replay.finish();
        } catch (IllegalArgumentException | IOException wrong) {
            System.err.println("model: " + file + ", " + wrong.getMessage());
            return 2;
        }
        System.out.println(replay.verdict());
        Set<String> covered = replay.covered();
        Set<String> hosts = Replay.transitions();
        long ofHosts = covered.stream().filter(hosts::contains).count();
        System.out.println("model: it has taken " + (covered.size() - ofHosts) + " of the models' "
                + Replay.edges().size() + " edges"
                + (ofHosts == 0 ? "" : ", and of hosts " + ofHosts + " of " + hosts.size() + " transitions"));
        return replay.refusal().isPresent() ? 1 : 0;
    }
}
