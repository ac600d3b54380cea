package campaign;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import harness.Table;

/** How much memory hosts and emulator take, from time to time. */
final class Memory {

    private static final double MEBI = 1024 * 1024;

    private final ProcessHandle emulator;
    private final List<Sample> samples = new ArrayList<>();

    /**
     * One look, in bytes.
     *
     * @param heap     the bytes alive on this process's heap, which holds the hosts and the replay.
     * @param resident the emulator's memory.
     */
    record Sample(long heap, long resident) {

        @Override
        public String toString() {
            return Table.text("%.1f MiB of heap, emulator %.1f MiB", heap / MEBI, resident / MEBI);
        }
    }

    Memory(ProcessHandle emulator) {
        this.emulator = emulator;
    }

    /** Looks, after a collection of garbage. */
    Sample sample() throws IOException {
        // A second one collects what the first has only found to be unreachable.
        System.gc();
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        Sample sample = new Sample(runtime.totalMemory() - runtime.freeMemory(), resident(emulator));
        samples.add(sample);
        return sample;
    }

    /** The memory of a process, in bytes. */
    static long resident(ProcessHandle process) throws IOException {
        for (String line : Files.readAllLines(Path.of("/proc/" + process.pid() + "/status"))) {
            if (line.startsWith("VmRSS:")) {
                return Long.parseLong(line.replaceAll("\\D", "")) * 1024;
            }
        }
        throw new IOException(process.pid() + " has ended");
    }

    /** The sample at a share of all samples, 0…1. */
    Sample at(double share) {
        return samples.get((int) Math.round(share * (samples.size() - 1)));
    }

    /**
     * By how much the second half's least is above the first half's greatest, in bytes; growth that goes on shows here.
     */
    Sample growth() {
        List<Sample> first = samples.subList(0, (samples.size() + 1) / 2);
        List<Sample> second = samples.subList(samples.size() / 2, samples.size());
        long heap = second.stream().mapToLong(Sample::heap).min().orElseThrow()
                - first.stream().mapToLong(Sample::heap).max().orElseThrow();
        long resident = second.stream().mapToLong(Sample::resident).min().orElseThrow()
                - first.stream().mapToLong(Sample::resident).max().orElseThrow();
        return new Sample(Math.max(heap, 0), Math.max(resident, 0));
    }
}
