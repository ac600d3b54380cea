package gateway;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import javino.protocol.Address;

/**
 * Some of many cells in memory, each with a gateway at a real broker. Takes lines: {@code go}, then {@code heap} and
 * {@code count}, which it answers with a line.
 */
public final class PlayedCells {

    private static final int TENTH = 10;
    private static final int NOBODY = 40;
    private static final int THREADS = 2;

    private PlayedCells() {
    }

    /**
     * Runs until the input ends.
     *
     * @param arguments broker's URL, file of its CA, password, first cell, one behind the last, all cells, mean time in
     *                  ms from one message of a device to the next to the same cell, seed.
     */
    public static void main(String[] arguments) throws Exception {
        int first = Integer.parseInt(arguments[3]);
        int end = Integer.parseInt(arguments[4]);
        int cells = Integer.parseInt(arguments[5]);
        long meanMillis = Long.parseLong(arguments[6]);
        long seed = Long.parseLong(arguments[7]);
        BrokerConfig broker = BrokerConfig.parse(arguments[0]).trusting(Path.of(arguments[1]));
        ScheduledExecutorService threads = Executors.newScheduledThreadPool(THREADS, task -> {
            Thread thread = new Thread(task, "cells");
            thread.setDaemon(true);
            return thread;
        });
        PlayedCell.Clock clock = new PlayedCell.Clock() {
            @Override
            public long now() {
                return TimeUnit.NANOSECONDS.toMillis(System.nanoTime());
            }

            @Override
            public void schedule(Runnable what, long millis) {
                threads.schedule(what, millis, TimeUnit.MILLISECONDS);
            }
        };
        List<PlayedCell> played = new ArrayList<>();
        for (int i = first; i < end; i++) {
            int own = i;
            Random random = new Random(seed * cells + i);
            PlayedCell cell = new PlayedCell(i, cells, clock, seed, () -> destination(own, cells, random));
            played.add(cell);
            Gateway.Config config = new Gateway.Config(broker.as("c" + i, Optional.of(arguments[2])), "c" + i,
                    "javino", false, Set.of());
            Gateway.start(cell::open, config, line -> {
                if (!line.contains("connected to")) {
                    System.err.println("c" + own + ": " + line);
                }
            });
        }
        System.out.println("joined");
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            switch (line) {
                case "go" -> played.forEach(cell -> cell.begin(meanMillis));
                case "heap" -> System.out.println(heap());
                default -> System.out.println(count(played));
            }
        }
        System.exit(0);
    }

    /** Mostly a device of any other cell; one in ten has moved, or is nobody. */
    private static Address destination(int own, int cells, Random random) {
        int other = (own + 1 + random.nextInt(cells - 1)) % cells;
        int number = random.nextInt(TENTH) > 0 ? random.nextInt(PlayedCell.MOVED)
                : random.nextBoolean() ? PlayedCell.MOVED : NOBODY + random.nextInt(PlayedCell.DEVICES);
        return PlayedCell.device(other, number);
    }

    /** Memory of live objects, in bytes. */
    private static long heap() {
        System.gc();
        System.gc();
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }

    private static PlayedCount count(List<PlayedCell> played) {
        PlayedCount all = new PlayedCount();
        played.forEach(cell -> all.add(cell.count()));
        return all;
    }
}
