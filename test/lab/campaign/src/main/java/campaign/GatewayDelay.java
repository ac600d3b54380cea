package campaign;

import harness.BrokerClient;
import harness.Emulator;
import harness.GatewayProcess;
import harness.Mosquitto;
import harness.Report;
import harness.TestKeys;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import trace.TraceEvent;

/**
 * The time that gateways add to a frame's way, each time in seconds.
 *
 * @param ways   from a packet's end until the board in the other cell has it.
 * @param broker from a client's publication until another client has it.
 */
record GatewayDelay(List<Double> ways, List<Double> broker) {

    private static final int LENGTH = 16;
    private static final long PATIENCE_SECONDS = 60;
    private static final int PINGS = 200;

    /** The end of each packet, until a board is given the same to relay. */
    private static final class Watch implements Consumer<TraceEvent> {
        private final Map<String, Double> ends = new HashMap<>();
        private final List<Double> ways = new ArrayList<>();

        @Override
        public synchronized void accept(TraceEvent event) {
            if (event.name().equals("rf-tx")) {
                ends.put(event.text("payload"), event.real("end"));
            } else if (event.name().equals("host-relay") && ends.containsKey(event.text("payload"))) {
                ways.add(event.seconds() - ends.get(event.text("payload")));
            }
        }

        synchronized List<Double> ways() {
            return ways.stream().sorted().toList();
        }
    }

    /** Has so many messages sent from one cell to another. */
    static GatewayDelay measure(int messages, long seed, Report report) throws Exception {
        Watch watch = new Watch();
        try (Closing closing = new Closing()) {
            Field.Cell pair = new Field.Cell("Station", 2);
            Field field = closing.add(Field.start(new Emulator.Scenario().seed(seed).listener(watch).discardEvents(),
                    List.of(pair, pair), report));
            Mosquitto broker = closing.add(Mosquitto.start(field.folder().resolve("broker"), "cell0", "cell1"));
            Field.Post from = field.cell(0).get(0);
            Field.Post to = field.cell(1).get(0);
            Ledger ledger = new Ledger(LENGTH);
            Endpoint sender = closing.add(new Endpoint(field.link(from), to.address(), new Ledger(LENGTH)));
            Endpoint receiver = closing.add(new Endpoint(field.link(to), from.address(), ledger));
            sender.as(from.address(), Map.of(to.address(), TestKeys.PAIR));
            receiver.as(to.address(), Map.of(from.address(), TestKeys.PAIR));
            for (int cell = 0; cell < 2; cell++) {
                closing.add(GatewayProcess.join(field.emulator(), field.cell(cell).get(1).name(), "cell" + cell, broker,
                        broker.port()));
            }
            for (int i = 0; i < messages; i++) {
                sender.send(to.address(), ledger).get(PATIENCE_SECONDS, TimeUnit.SECONDS);
            }
            return new GatewayDelay(watch.ways(), pings(broker));
        }
    }

    private static List<Double> pings(Mosquitto broker) throws Exception {
        BlockingQueue<Long> arrivals = new ArrayBlockingQueue<>(1);
        List<Double> times = new ArrayList<>();
        try (BrokerClient one = BrokerClient.enter(broker, Mosquitto.OWNER);
                BrokerClient other = BrokerClient.enter(broker, Mosquitto.OWNER)) {
            other.watch("javino/to/none/from/none/air", (topic, frame) -> arrivals.add(System.nanoTime()));
            for (int i = 0; i < PINGS; i++) {
                long sent = System.nanoTime();
                one.air("to/none", "none", "ping", new byte[LENGTH]);
                Long came = arrivals.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
                times.add((came - sent) / 1e9);
            }
        }
        Collections.sort(times);
        return times;
    }
}
