package campaign;

import harness.BrokerClient;
import harness.Emulator;
import harness.GatewayProcess;
import harness.Mosquitto;
import harness.Report;
import harness.Table;
import harness.TestKeys;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Outcome;

/**
 * Some cells, joined.
 *
 * @param boards  the number in each cell; the last one is its gateway's.
 * @param seconds emulated, how long messages are offered.
 */
record CellsRun(long seed, int cells, int boards, double seconds) implements Runs.Run<CellsRun.Result> {

    /** The mean time from one message of a device to its next one to the same partner. */
    static final double MEAN_SECONDS = 90;
    /** Wall time, far more than a run takes. */
    private static final long PATIENCE_SECONDS = 1800;

    /**
     * The outcome. CPU times are in seconds of a core by an emulated second.
     *
     * @param near    messages to a neighbour.
     * @param far     to the next cell, if there is one.
     * @param speed   emulated time by time on the wall.
     * @param air     the share of a cell's time in which some board sends.
     * @param frames  published in an emulated second.
     * @param gateway that of each gateway, as of each emulator and of the hosts and the replay of each cell.
     */
    record Result(int cells, Traffic.Sent near, Traffic.Sent far, double speed, double air, double frames,
            double broker, long brokerBytes, double gateway, long gatewayBytes, double emulator, double hosts) {}

    /** A cell with its hosts; what they send is entered where it is sent. */
    private record Cell(Metronome metronome, AirUsage air, Field field, List<Flow> flows) {}

    /** Messages from one device to another, and how long they waited. */
    private record Flow(boolean near, Endpoint from, Address to, Ledger ledger, List<Double> waits) {

        CompletableFuture<Outcome> send(Metronome metronome) {
            double offered = metronome.now();
            return from.send(to, ledger).whenComplete((outcome, failure) -> {
                if (outcome == Outcome.DELIVERED) {
                    synchronized (waits) {
                        waits.add(metronome.now() - offered);
                    }
                }
            });
        }

        Traffic.Sent sent() {
            synchronized (waits) {
                return new Traffic.Sent(ledger.sum(), List.copyOf(waits));
            }
        }
    }

    private static Address address(int cell, int device) {
        return Address.parse(Table.text("C%d%02d", cell, device));
    }

    private static String name(int cell) {
        return "cell" + cell;
    }

    @Override
    public Result in(Report report) throws Exception {
        try (Closing closing = new Closing()) {
            Map<String, Ledger> ledgers = new HashMap<>();
            List<Cell> all = new ArrayList<>();
            for (int cell = 0; cell < cells; cell++) {
                all.add(start(cell, ledgers, closing, report));
            }
            Mosquitto broker = closing.add(Mosquitto.start(all.get(0).field.folder().resolve("broker"),
                    IntStream.range(0, cells).mapToObj(CellsRun::name).toArray(String[]::new)));
            List<GatewayProcess> gateways = new ArrayList<>();
            for (int cell = 0; cell < cells; cell++) {
                Field field = all.get(cell).field;
                gateways.add(closing.add(GatewayProcess.join(field.emulator(), field.cell(0).get(boards - 1).name(),
                        name(cell), broker, broker.port())));
            }
            AtomicLong frames = new AtomicLong();
            closing.add(BrokerClient.enter(broker, Mosquitto.OWNER)).watch("javino/+/+/from/+/air",
                    (topic, frame) -> frames.incrementAndGet());
            CompletableFuture.allOf(flows(all, true).map(flow -> flow.send(all.get(0).metronome))
                    .toArray(CompletableFuture[]::new)).join();
            flows(all, true).forEach(flow -> flow.waits.clear());
            return measure(all, gateways, broker, frames);
        }
    }

    private static Stream<Flow> flows(Collection<Cell> all, boolean near) {
        return all.stream().flatMap(cell -> cell.flows.stream()).filter(flow -> flow.near == near);
    }

    /** The ledger of what one device sends to another; both of them enter there. */
    private static Ledger ledger(Map<String, Ledger> ledgers, Address from, Address to) {
        return ledgers.computeIfAbsent(from + " " + to, any -> new Ledger(TrafficRun.LENGTH));
    }

    private Cell start(int cell, Map<String, Ledger> ledgers, Closing closing, Report report) throws Exception {
        AirUsage air = new AirUsage();
        Metronome metronome = closing.add(new Metronome());
        Emulator.Scenario scenario = metronome.scenario(seed + cell, air);
        Field field = closing.add(Field.start(scenario, List.of(new Field.Cell("Station", boards)), report));
        int devices = boards - 1;
        List<Flow> flows = new ArrayList<>();
        for (int device = 0; device < devices; device++) {
            Address own = address(cell, device);
            List<Address> from = new ArrayList<>(List.of(address(cell, (device + devices - 1) % devices)));
            List<Address> to = new ArrayList<>(List.of(address(cell, (device + 1) % devices)));
            if (cells > 1) {
                from.add(address((cell + cells - 1) % cells, device));
                to.add(address((cell + 1) % cells, device));
            }
            Map<Address, Ledger> incoming = new HashMap<>();
            from.forEach(other -> incoming.put(other, ledger(ledgers, other, own)));
            Map<Address, byte[]> keys = new HashMap<>();
            Stream.concat(from.stream(), to.stream()).forEach(other -> keys.put(other, TestKeys.PAIR));
            Endpoint host = closing.add(new Endpoint(field.link(field.cell(0).get(device)), incoming,
                    ledger(ledgers, own, own)).as(own, keys));
            for (Address other : to) {
                flows.add(new Flow(other.equals(to.get(0)), host, other, ledger(ledgers, own, other),
                        new ArrayList<>()));
            }
        }
        return new Cell(metronome, air, field, flows);
    }

    private Result measure(List<Cell> all, List<GatewayProcess> gateways, Mosquitto broker, AtomicLong frames)
            throws Exception {
        List<ProcessHandle> emulators = all.stream().map(cell -> cell.field.emulator().process()).toList();
        List<ProcessHandle> joining = gateways.stream().map(GatewayProcess::process).toList();
        List<List<ProcessHandle>> kinds = List.of(List.of(broker.process()), joining, emulators,
                List.of(ProcessHandle.current()));
        double[] before = kinds.stream().mapToDouble(CellsRun::cpuSeconds).toArray();
        double[] airBefore = all.stream().mapToDouble(CellsRun::airSeconds).toArray();
        long framesBefore = frames.get();
        long begun = System.nanoTime();
        SplittableRandom seeds = new SplittableRandom(seed);
        double[] ends = new double[all.size()];
        for (int i = 0; i < all.size(); i++) {
            Metronome metronome = all.get(i).metronome;
            ends[i] = metronome.now() + seconds;
            for (Flow flow : all.get(i).flows) {
                new Offer(metronome, seeds.nextLong(), MEAN_SECONDS, ends[i], () -> flow.send(metronome));
            }
        }
        for (int i = 0; i < all.size(); i++) {
            all.get(i).metronome.await(ends[i], all.get(i).field.emulator());
        }
        double wall = (System.nanoTime() - begun) / 1e9;
        double[] cpu = new double[kinds.size()];
        for (int i = 0; i < cpu.length; i++) {
            cpu[i] = (cpuSeconds(kinds.get(i)) - before[i]) / seconds;
        }
        double published = (frames.get() - framesBefore) / seconds;
        double air = IntStream.range(0, all.size()).mapToDouble(i -> airSeconds(all.get(i)) - airBefore[i]).sum()
                / seconds / all.size();
        awaitEnds(() -> flows(all, true).noneMatch(CellsRun::isOpen) && flows(all, false)
                .noneMatch(CellsRun::isOpen));
        return new Result(cells, sent(all, true), sent(all, false), seconds / wall, air, published, cpu[0],
                Memory.resident(broker.process()), cpu[1] / cells,
                Math.round(average(joining)), cpu[2] / cells, cpu[3] / cells);
    }

    private static double average(List<ProcessHandle> processes) throws IOException {
        double sum = 0;
        for (ProcessHandle process : processes) {
            sum += Memory.resident(process);
        }
        return sum / processes.size();
    }

    private static boolean isOpen(Flow flow) {
        return flow.ledger.sum().open() > 0;
    }

    private static Traffic.Sent sent(List<Cell> all, boolean near) {
        return flows(all, near).map(Flow::sent).reduce(Traffic.Sent.NONE, Traffic.Sent::plus);
    }

    private static double airSeconds(Cell cell) {
        return cell.air.of(cell.field.cell(0)).seconds();
    }

    private static double cpuSeconds(List<ProcessHandle> processes) {
        return processes.stream()
                .mapToDouble(process -> process.info().totalCpuDuration().orElseThrow().toNanos() / 1e9)
                .sum();
    }

    /** Waits until all that was sent has ended, unless that takes far too long. */
    private static void awaitEnds(BooleanSupplier ended) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (System.nanoTime() - end < 0 && !ended.getAsBoolean()) {
            TimeUnit.MILLISECONDS.sleep(100);
        }
    }
}
