package campaign;

import java.util.List;

/** Cells of boards, each in an emulator of its own, joined by gateways over one broker. */
final class Cells implements Campaign {

    private static final int BOARDS = 20;
    private static final int FEW_BOARDS = 4;
    private static final double SECONDS = 90;
    private static final double FEW_SECONDS = 20;
    /** Of what a gateway adds, beside the broker's own time. */
    private static final double MOST_MILLIS = 50;
    /** Frames a second of a cell whose air is full. */
    private static final double FULL = 4;
    /** Devices whose places a gateway knows (docs/mqtt.md). */
    private static final int PLACES = 4096;

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
            *Air* is the share of a cell's time in which some board sends. *Frames* are those that the gateways publish,
            *sent on* those that the broker hands to gateways: each gets all. The traces are not replayed in the model.
            """.formatted(boards, Runtime.getRuntime().availableProcessors(), CellsRun.MEAN_SECONDS,
                settings.choose(SECONDS, FEW_SECONDS)));
        Table table =
                new Table("cells", "speed", "air", "to a neighbour", "delivered", "median wait", "to the next cell",
                        "delivered", "median wait");
        Table costs = new Table("cells", "frames a second", "sent on", "broker, CPU", "memory", "a gateway, CPU",
                "memory", "an emulator, CPU", "a cell's hosts, CPU");
        Ledger.Sum all = Ledger.Sum.ZERO;
        CellsRun.Result last = null;
        for (int cells : settings.choose(List.of(1, 2, 4, 10), List.of(2))) {
            last = new CellsRun(settings.seed(), cells, boards, settings.choose(SECONDS, FEW_SECONDS)).call();
            all = all.plus(last.near().sum()).plus(last.far().sum());
            table.row(cells, Table.text("%.2f", last.speed()), Table.text("%.0f %%", 100 * last.air()),
                    last.near().sum().offered(), share(last.near()), wait(last.near()), last.far().sum().offered(),
                    share(last.far()), wait(last.far()));
            costs.row(cells, Table.text("%.1f", last.frames()), Table.text("%.1f", last.frames() * cells),
                    milli(last.broker()), mebi(last.brokerBytes()), milli(last.gateway()), mebi(last.gatewayBytes()),
                    milli(last.emulator()), milli(last.hosts()));
            report.progress("%s", last);
        }
        report.table(table);
        report.table(costs);
        report.claim(last.cells() + " cells, delivered to the next cell",
                Table.of(last.far().sum().delivered(), last.far().sum().offered()), "");
        report.claim("wait", wait(last.far()), "");
        extrapolate(last, boards, report);
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

    private static void extrapolate(CellsRun.Result run, int boards, Report report) {
        double frames = run.frames() / run.cells();
        double onward = run.flood().onward();
        double arrived = run.flood().arrived();
        report.claim("cells that would fill a core of the broker", Table.text("%.0f", Math.sqrt(1 / (frames * onward))),
                Table.text("air full: %.0f", Math.sqrt(1 / (FULL * onward))));
        report.text("""
            **A country of cells, on paper.** After the run with %d cells a client published frames as fast as the
            broker took them; each gateway got %.0f a second. For each message that it sends on, the broker takes
            %.0f µs of a core, and a gateway for each that it gets %.0f µs. A cell publishes %.2f frames a second
            here, and some %.0f where its air is full. With N cells a gateway gets N times that, and the broker sends N²
            times that on. So

            - a gateway forgets devices from %d cells on: it knows the places of %d devices, here %d a cell. What it has
            forgotten is searched in all cells, within a tenth of their air. At little load this is the first limit.
            - the broker fills a core with %.0f cells at this load, and with %.0f where all air is full: that is the
            first limit there.
            - a gateway fills a core of this computer with %.0f cells at this load, and with %.0f where all air is full;
            a small computer has fewer by as much as it is slower.
            - the air of one cell does not depend on the number of others, but for searches.

            A country of 10 000 such cells has %.0f frames a second, which one broker can take in, and cannot send on to
            all. It needs topics (`--topic`) for each region, where cells speak to each other; between regions nothing
            of ours helps yet. A gateway that published a unicast under the cell where its destination is, and listened
            to its own cell only, would make of N² messages N.
            """.formatted(run.cells(), run.flood().rate(), 1e6 * onward, 1e6 * arrived, frames, FULL,
                PLACES / (boards - 1), PLACES, boards - 1, Math.sqrt(1 / (frames * onward)),
                Math.sqrt(1 / (FULL * onward)), 1 / (frames * arrived), 1 / (FULL * arrived), 10_000 * frames));
    }

    private static void delay(Settings settings, Report report) throws Exception {
        GatewayDelay delay = GatewayDelay.measure(settings.choose(30, 3), settings.seed());
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
