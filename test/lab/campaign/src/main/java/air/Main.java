package air;

import harness.Table;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle air}: draws who was on the air when, and says why packets collided. */
@Command(name = "air", mixinStandardHelpOptions = true, description = "Draws the air of a trace of the emulator.")
public final class Main implements Callable<Integer> {

    /** A picture of more could not be read. */
    private static final double MOST_SECONDS = 10;
    private static final double MARGIN_SECONDS = 0.5;

    @Option(names = "--trace", required = true, paramLabel = "FILE", description = "the emulator's trace")
    private Path file;

    @Option(names = "--from", paramLabel = "SECONDS", description = "where picture and tables begin")
    private Double from;

    @Option(names = "--to", paramLabel = "SECONDS", description = "where they end")
    private Double to;

    @Option(names = "--picture", required = true, paramLabel = "FILE", description = "the picture")
    private Path picture;

    private Main() {}

    public static void main(String[] arguments) {
        System.exit(run(arguments));
    }

    static int run(String... arguments) {
        CommandLine command = new CommandLine(new Main());
        command.setParameterExceptionHandler((wrong, given) -> wrong(wrong.getMessage()
                + " (gradle air -Ptrace=FILE, and perhaps -Pfrom=SECONDS -Pto=SECONDS)"));
        return command.execute(arguments);
    }

    @Override
    public Integer call() throws IOException {
        AirTrace trace;
        try {
            trace = AirTrace.read(file);
        } catch (IllegalArgumentException wrong) {
            return wrong(file + ", " + wrong.getMessage());
        } catch (NoSuchFileException missing) {
            return wrong(file + ": there is no such file");
        } catch (FileSystemException useless) {
            return wrong(useless.getMessage());
        } catch (IOException unreadable) {
            return wrong(file + " cannot be read: " + unreadable);
        }
        List<Packet> packets = trace.packets();
        if (packets.isEmpty()) {
            return wrong(file + " has no packet");
        }
        double first = from == null ? packets.get(0).start : Math.max(0, from);
        double end = packets.stream().mapToDouble(packet -> packet.end).max().orElse(first);
        double last = to == null ? end : Math.min(end, to);
        if (!(first < last)) {
            return wrong("nothing lies between " + first + " s and " + last + " s");
        }
        Causes.find(packets, trace.jams());
        String figures =
                new Figures(packets.stream().filter(packet -> packet.overlaps(first, last)).toList(), first, last)
                        .text(trace);
        System.out.print(figures);
        double begin = busiest(packets, first, last);
        double stop = Math.min(last, begin + MOST_SECONDS);
        Files.createDirectories(picture.toAbsolutePath().getParent());
        Files.writeString(picture, new Picture(trace, packets, begin, stop).svg(figures));
        System.out.println("\nair: " + picture + " shows " + (begin > first || stop < last ? "only " : "")
                + Table.text("%.1f s to %.1f s", begin, stop));
        return CommandLine.ExitCode.OK;
    }

    /** The beginning of the picture: if not all fits, the part with the most that went wrong. */
    private static double busiest(List<Packet> packets, double first, double last) {
        double[] starts = packets.stream().filter(packet -> packet.cause != null && packet.overlaps(first, last))
                .mapToDouble(packet -> packet.start).toArray();
        double best = first;
        int most = 0;
        for (int i = 0, j = 0; i < starts.length; i++) {
            while (j < starts.length && starts[j] < starts[i] + MOST_SECONDS - 2 * MARGIN_SECONDS) {
                j++;
            }
            if (j - i > most) {
                most = j - i;
                best = starts[i] - MARGIN_SECONDS;
            }
        }
        return Math.max(first, Math.min(best, last - MOST_SECONDS));
    }

    private static int wrong(String what) {
        System.err.println("air: " + what);
        return CommandLine.ExitCode.USAGE;
    }
}
