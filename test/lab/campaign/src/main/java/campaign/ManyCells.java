package campaign;

import harness.BrokerClient;
import harness.Mosquitto;
import harness.Table;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Many cells in memory, each with a gateway, joined by a real broker.
 *
 * @param seconds real time that is measured, and half as much before.
 */
record ManyCells(long seed, int cells, double seconds) implements Callable<ManyCells.Result> {

    /** The mean time between messages of a device to its own cell, and to other cells: what two cores can play. */
    static final double MEAN_SECONDS = 360;
    private static final int NUMBERS = 8;

    /**
     * The outcome.
     *
     * @param near     to a device of the same cell, as {@code far} to another one, {@code moved} to one that has moved
     *                 in silence, {@code unknown} to nobody.
     * @param messages those of the broker in a second: received and sent.
     * @param broker   seconds of a core in a second.
     * @param gateway  the same, of the one that is measured.
     * @param heap     the same one's, in bytes, alive.
     */
    record Result(int cells, Share near, Share far, Share moved, Share unknown, double messages, double broker,
            long brokerBytes, double gateway, long heap) {
    }

    /** Messages. */
    record Share(long offered, long delivered) {

        @Override
        public String toString() {
            return Table.percent(delivered, offered) + " of " + offered;
        }
    }

    /** The messages that a broker has received and sent, as it tells each second; without these. */
    private static final class BrokerMessages implements BiConsumer<String, byte[]> {

        private static final String TOPIC = "$SYS/broker/publish/messages/+";
        private final Map<String, Long> told = new HashMap<>();
        private long own;

        @Override
        public synchronized void accept(String topic, byte[] payload) {
            own++;
            told.put(topic, Long.parseLong(new String(payload, StandardCharsets.US_ASCII)));
        }

        synchronized long count() {
            return told.entrySet().stream().filter(entry -> entry.getKey().matches(".*/(sent|received)"))
                    .mapToLong(Map.Entry::getValue).sum() - own;
        }
    }

    /** Some of the cells, in a process of their own. */
    private record Group(Process process, BufferedReader output, PrintStream input) implements AutoCloseable {

        static Group start(List<String> options) throws IOException {
            List<String> command = Stream.concat(Stream.of(ProcessHandle.current().info().command().orElse("java"),
                    "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"),
                    "gateway.PlayedCells"), options.stream()).toList();
            Process process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
            Runtime.getRuntime().addShutdownHook(new Thread(process::destroyForcibly));
            return new Group(process, process.inputReader(), new PrintStream(process.getOutputStream(), true));
        }

        long[] ask(String what) throws IOException {
            input.println(what);
            return Arrays.stream(next().split(" ")).mapToLong(Long::parseLong).toArray();
        }

        String next() throws IOException {
            String line = output.readLine();
            if (line == null) {
                throw new IOException("the cells have ended");
            }
            return line;
        }

        double cpuSeconds() {
            return seconds(process.toHandle());
        }

        @Override
        public void close() {
            process.destroyForcibly();
        }
    }

    private static double seconds(ProcessHandle process) {
        return process.info().totalCpuDuration().orElseThrow().toNanos() / 1e9;
    }

    @Override
    public Result call() throws Exception {
        Path folder = Files.createTempDirectory("javino-cells");
        try (Closing closing = new Closing()) {
            Mosquitto broker = closing.add(Mosquitto.start(folder,
                    IntStream.range(0, cells).mapToObj(i -> "c" + i).toArray(String[]::new)));
            BrokerMessages messages = new BrokerMessages();
            closing.add(BrokerClient.enter(broker, Mosquitto.OWNER)).watch(BrokerMessages.TOPIC, messages);
            Group measured = closing.add(Group.start(options(broker, 0, 1)));
            measured.next();
            Group others = closing.add(Group.start(options(broker, 1, cells)));
            others.next();
            measured.input.println("go");
            others.input.println("go");
            sleep(seconds / 2);
            long[] before = counts(measured, others);
            long messagesBefore = messages.count();
            double gatewayBefore = measured.cpuSeconds();
            double brokerBefore = seconds(broker.process());
            sleep(seconds);
            double gateway = measured.cpuSeconds() - gatewayBefore;
            double ofBroker = seconds(broker.process()) - brokerBefore;
            double all = messages.count() - messagesBefore;
            long[] after = counts(measured, others);
            Share[] shares = IntStream.range(0, NUMBERS / 2).mapToObj(i -> new Share(after[2 * i] - before[2 * i],
                    after[2 * i + 1] - before[2 * i + 1])).toArray(Share[]::new);
            return new Result(cells, shares[0], shares[1], shares[2], shares[3], all / seconds, ofBroker / seconds,
                    Memory.resident(broker.process()), gateway / seconds, measured.ask("heap")[0]);
        }
    }

    private List<String> options(Mosquitto broker, int first, int end) {
        return List.of("mqtts://localhost:" + broker.port(), broker.ca().toString(), Mosquitto.PASSWORD, "" + first,
                "" + end, "" + cells, "" + Math.round(1000 * MEAN_SECONDS), "" + seed);
    }

    private static long[] counts(Group measured, Group others) throws IOException {
        long[] one = measured.ask("count");
        long[] more = others.ask("count");
        return IntStream.range(0, NUMBERS).mapToLong(i -> one[i] + more[i]).toArray();
    }

    private static void sleep(double seconds) throws InterruptedException {
        TimeUnit.MILLISECONDS.sleep(Math.round(1000 * seconds));
    }
}
