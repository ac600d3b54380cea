package campaign;

import java.util.ArrayList;
import java.util.List;

import harness.Report;
import harness.Table;

/** Cells of boards, each in an emulator of its own, joined by gateways over one broker. */
final class Cells implements Campaign {

    private static final int BOARDS = 20;
    private static final int FEW_BOARDS = 4;
    private static final double SECONDS = 90;
    private static final double FEW_SECONDS = 20;
    /** The most that a gateway adds, beside the broker's own time. */
    private static final double MOST_MILLIS = 50;
    private static final double MANY_SECONDS = 120;
    /** The most growth of a gateway's need from the fewest cells to the most, and of the broker's for each. */
    private static final double GATEWAY_GROWTH = 1.2;
    private static final double BROKER_GROWTH = 1.1;
    private static final int COUNTRY = 10_000;
    /** The share of a cell's air for searches of all gateways (docs/mqtt.md), and a frame's time on the air. */
    private static final double SEARCH_SHARE = 0.02;
    private static final double FRAME_SECONDS = 0.28;

    @Override
    public String name() {
        return "cells";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        int boards = settings.choose(BOARDS, FEW_BOARDS);
        report.text("""
            Each cell is an emulator with %d boards (`Station`) at real time: one is the gateway's, the others have
            hosts, all of them in one Java virtual machine. The gateways are processes of their own with 16 MB of heap,
            the broker is Mosquitto with TLS and a user for each cell; all of it runs on one computer with %d cores.
            Each device sends two sealed contents of 16 bytes every %.0f s on average, at random times: one to a
            neighbour, one to a device of the next cell. Beforehand each sends one to its neighbour, so that it is
            heard; these count as delivered, not as waiting. Then %.0f emulated seconds are measured. *Speed* is
            emulated time by time on the wall: below 1 the computer has more to do than it can, and figures
            with times are too good or too bad. CPU times are of an emulated second, so they hold at any speed.
            *Air* is the share of a cell's time in which some board sends. *Frames* are those that the gateways publish.
            The traces are not replayed in the model.
            """.formatted(boards, Runtime.getRuntime().availableProcessors(), CellsRun.MEAN_SECONDS,
                settings.choose(SECONDS, FEW_SECONDS)));
        Table table =
                new Table("cells", "speed", "air", "to a neighbour", "delivered", "median wait", "to the next cell",
                        "delivered", "median wait");
        Table costs = new Table("cells", "frames a second", "broker, CPU", "memory", "a gateway, CPU",
                "memory", "an emulator, CPU", "a cell's hosts and replay, CPU");
        Ledger.Sum all = Ledger.Sum.ZERO;
        CellsRun.Result last = null;
        for (int cells : settings.choose(List.of(1, 10), List.of(2))) {
            last = new CellsRun(settings.seed(), cells, boards, settings.choose(SECONDS, FEW_SECONDS)).in(report);
            all = all.plus(last.near().sum()).plus(last.far().sum());
            table.row(cells, Table.text("%.2f", last.speed()), Table.text("%.0f %%", 100 * last.air()),
                    last.near().sum().offered(), share(last.near()), wait(last.near()), last.far().sum().offered(),
                    share(last.far()), wait(last.far()));
            costs.row(cells, Table.text("%.1f", last.frames()),
                    milli(last.broker()), mebi(last.brokerBytes()), milli(last.gateway()), mebi(last.gatewayBytes()),
                    milli(last.emulator()), milli(last.hosts()));
            report.progress("%s", last);
        }
        report.table(table);
        report.table(costs);
        report.claim(last.cells() + " cells, delivered to the next cell",
                Table.of(last.far().sum().delivered(), last.far().sum().offered()), "");
        report.claim("wait", wait(last.far()), "");
        many(settings, report);
        delay(settings, report);
        all.report(report);
        report.never("a unicast without an end", all.open());
    }

    private static String share(Traffic.Sent sent) {
        return Table.percent(sent.sum().delivered(), sent.sum().offered());
    }

    private static String wait(Traffic.Sent sent) {
        return sent.sum().offered() == 0 ? "-" : Table.text("%.2f s", sent.longestWait(0.5));
    }

    private static String milli(double seconds) {
        return Table.text("%.1f ms", 1000 * seconds);
    }

    private static String mebi(long bytes) {
        return Table.text("%.0f MiB", bytes / 1024.0 / 1024.0);
    }

    private static void many(Settings settings, Report report) throws Exception {
        double seconds = settings.choose(MANY_SECONDS, FEW_SECONDS / 4);
        report.text("""
            **Many cells.** Cells of 20 devices in memory, at the boards' pace, with a real broker and TLS: %.0f s of
            real time, after half as many. All gateways but one share a Java virtual machine; that one has its own, with
            a radio in memory, so its CPU is the router's and the client's. Each device sends a message of 16 bytes
            every %.0f s on average to its own cell, and one to a random other cell; one in ten of these is for a device
            that has moved in silence, or for nobody. Messages are those that the broker receives and sends.
            """.formatted(seconds, ManyCells.MEAN_SECONDS));
        Table table = new Table("cells", "same cell", "another cell", "moved", "nobody", "messages a second", "a cell",
                "broker, CPU", "memory", "a gateway, CPU", "heap");
        List<ManyCells.Result> results = new ArrayList<>();
        for (int cells : settings.choose(List.of(50, 100, 200, 500), List.of(2, 4))) {
            ManyCells.Result run = new ManyCells(settings.seed(), cells, seconds).call();
            results.add(run);
            table.row(cells, run.near(), run.far(), run.moved(), run.unknown(), Table.text("%.0f", run.messages()),
                    Table.text("%.2f", run.messages() / cells), milli(run.broker()), mebi(run.brokerBytes()),
                    milli(run.gateway()), mebi(run.heap()));
            report.progress("%s", run);
        }
        report.table(table);
        ManyCells.Result few = results.get(0);
        ManyCells.Result most = results.get(results.size() - 1);
        double ofBroker = most.messages() / most.cells() / (few.messages() / few.cells());
        report.claim(most.cells() + " cells by " + few.cells(), Table.text("a gateway's CPU %.2f, heap %.2f",
                most.gateway() / few.gateway(), 1.0 * most.heap() / few.heap()),
                Table.text("broker's messages a cell: %.2f", ofBroker));
        if (!settings.small()) {
            report.aim("a gateway's CPU and heap grow by at most a fifth",
                    most.gateway() <= GATEWAY_GROWTH * few.gateway() && most.heap() <= GATEWAY_GROWTH * few.heap());
            report.aim("the broker's messages grow as the cells do, within a tenth", ofBroker <= BROKER_GROWTH);
        }
        extrapolate(most, report);
    }

    private static void extrapolate(ManyCells.Result run, Report report) {
        double message = run.broker() / run.messages();
        double perCell = run.messages() / run.cells();
        double full = 1 / (message * perCell);
        double searches = SEARCH_SHARE / FRAME_SECONDS;
        report.claim("cells that would fill a core of the broker", Table.text("%.0f", full), "");
        report.text("""
            **%d cells, on paper.** They are %.0f messages a second; each takes the broker %.0f µs of a core. What
            breaks first:

            - searches: all gateways together make %.2f a second, so each one in %.0f hours. A device that no gateway
            has heard within a day is in effect not found. Devices that were heard are: questions go only where they
            were.
            - a broker fills a core with %.0f cells at this load. Mosquitto has one: so it takes %.0f regions, or a
            cluster.
            - a gateway does not notice the number of cells: it gets what is for its own.
            """.formatted(COUNTRY, COUNTRY * perCell, 1e6 * message, searches, COUNTRY / searches / 3600, full,
                Math.ceil(COUNTRY / full)));
    }

    private static void delay(Settings settings, Report report) throws Exception {
        GatewayDelay delay = GatewayDelay.measure(settings.choose(30, 3), settings.seed(), report);
        report.text("""
            **What gateways add.** Two cells in one emulator, the air else quiet: from a packet's end on the air until
            the board of the other cell's gateway has it to send, in emulated time at real time. The board's reply, two
            gateways, the broker and the request to the other board are in it. The broker's own time is that from a
            client's publication until another client has it, through the same TLS.
            """);
        double median = median(delay.ways());
        double broker = median(delay.broker());
        report.table(new Table("median of", "a packet's end to the other board", "the broker's own time")
                .row(delay.ways().size() + " packets", milli(median), milli(broker)));
        report.claim("added by gateways and broker", milli(median),
                "broker: " + milli(broker));
        report.aim(Table.text("gateways add at most %.0f ms beside the broker's own time", MOST_MILLIS),
                1000 * (median - broker) <= MOST_MILLIS);
    }

    private static double median(List<Double> sorted) {
        return sorted.get(sorted.size() / 2);
    }
}
