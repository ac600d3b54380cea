package campaign;

import harness.CrossedPackets;
import harness.Emulator;
import harness.Host;
import harness.Report;
import harness.Table;
import harness.TestKeys;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import javino.protocol.Counter;
import trace.TraceEvent;

/** Two boards that send to each other without a pause, for hours of their time. */
final class Soak implements Campaign {

    private static final String SPEED = "8";
    private static final int SHORT = 16;
    private static final int LONG = 100;
    private static final int WINDOW = 2;
    private static final int SAMPLES = 20;
    private static final long PATIENCE_SECONDS = 60;
    private static final double AIM_HOURS = 24;
    private static final double STANDSTILL_SECONDS = 60;
    private static final long GROWTH_BYTES = 1024 * 1024;

    private final AirUsage air = new AirUsage();
    private final CrossedPackets crossings = new CrossedPackets();
    private final Ledger shorts = new Ledger(SHORT);
    private final Ledger longs = new Ledger(LONG);
    private final Pace shortPace = new Pace();
    private final Pace longPace = new Pace();

    @Override
    public String name() {
        return "soak";
    }

    private void traced(TraceEvent event) {
        air.accept(event);
        crossings.see(event);
        shortPace.see(event.seconds(), shorts.delivered());
        longPace.see(event.seconds(), longs.delivered());
    }

    private long stuck() {
        return java.util.stream.Stream.of(shortPace, longPace).filter(pace -> pace.longest() > STANDSTILL_SECONDS)
                .count();
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        try (Closing closing = new Closing()) {
            Emulator.Scenario scenario = new Emulator.Scenario().speed(SPEED).seed(settings.seed())
                    .listener(this::traced).discardEvents();
            Field field = closing.add(Field.start(scenario, List.of(new Field.Cell("Station", 2)), report));
            Field.Post one = field.cell(0).get(0);
            Field.Post two = field.cell(0).get(1);
            Endpoint first = closing.add(new Endpoint(field.link(one), two.address(), longs));
            Endpoint second = closing.add(new Endpoint(field.link(two), one.address(), shorts));
            first.as(one.address(), Map.of(two.address(), TestKeys.PAIR));
            second.as(two.address(), Map.of(one.address(), TestKeys.PAIR));

            long end = System.nanoTime() + settings.soak().toNanos();
            Stream toTwo = new Stream(first, two.address(), shorts, WINDOW, () -> System.nanoTime() - end < 0);
            Stream toOne = new Stream(second, one.address(), longs, WINDOW, () -> System.nanoTime() - end < 0);
            Memory memory = new Memory(field.emulator().process());
            boolean ended = watch(settings, end, memory, List.of(toOne, toTwo), report);
            describe(memory, report);
            side(report, "board 0 to 1, 16 bytes", shorts.sum(), one, Host.get(first.board().statistics()),
                    Host.get(second.board().statistics()));
            side(report, "board 1 to 0, 100 bytes", longs.sum(), two, Host.get(second.board().statistics()),
                    Host.get(first.board().statistics()));
            Ledger.Sum all = shorts.sum().plus(longs.sum());
            report.claim("unicasts delivered", Table.of(all.delivered(), all.offered()), "");
            all.report(report);
            report.never("a unicast without an end", ended ? 0 : shorts.sum().open() + longs.sum().open());
            report.never("a direction without a delivery for a minute of the boards' time", stuck());
            report.never("a nonce with two messages", air.nonces().repeated());
        }
    }

    /** Looks at memory and progress from time to time, and waits until the streams have ended; false if one did not. */
    private boolean watch(Settings settings, long end, Memory memory, List<Stream> streams, Report report)
            throws Exception {
        for (int i = 1; i <= SAMPLES; i++) {
            TimeUnit.NANOSECONDS.sleep(end - (SAMPLES - i) * settings.soak().toNanos() / SAMPLES - System.nanoTime());
            report.progress("%.2f hours emulated, %d and %d unicasts delivered, %s", air.now() / 3600,
                    shorts.delivered(),
                    longs.delivered(), memory.sample());
        }
        boolean ended = true;
        for (Stream stream : streams) {
            ended &= stream.await(PATIENCE_SECONDS);
        }
        return ended;
    }

    private void describe(Memory memory, Report report) {
        report.text("""
            Two boards (`Station`) at %s times real time, each sending to the other without a pause: contents of 16
            bytes one way, of 100, in fragments, the other way. The air is clean, so each packet that was not received
            has a known reason: the board was itself sending when the packet began (*crossed*), or began to send while
            it came, or two packets were on the air.
            """.formatted(SPEED));
        report.table(new Table("memory", "heap of hosts and replay, emulator")
                .row("at a quarter of the time", memory.at(0.25)).row("at the end", memory.at(1)));
        report.table(new Table("longest time without a delivery, emulated", "one way", "the other").row("",
                Table.text("%.1f s", shortPace.longest()), Table.text("%.1f s", longPace.longest())));
        double hours = air.now() / 3600;
        report.claim("longest time without a delivery",
                Table.text("%.1f s", Math.max(shortPace.longest(), longPace.longest())), "");
        report.aim(Table.text("24 emulated hours (%.1f in this run)", hours), hours >= AIM_HOURS);
        Memory.Sample growth = memory.growth();
        report.never("growth of memory between the halves above 1 MiB",
                (growth.heap() > GROWTH_BYTES ? 1 : 0) + (growth.resident() > GROWTH_BYTES ? 1 : 0));
    }

    /** Compares what the sender's board, the receiver's board, the hosts and the air have counted of one direction. */
    private void side(Report report, String title, Ledger.Sum sum, Field.Post post, Map<Counter, Long> from,
            Map<Counter, Long> at) {
        long sent = from.get(Counter.RADIO_SENT);
        long known = at.get(Counter.RADIO_RECEIVED) + at.get(Counter.RADIO_DAMAGED) + at.get(Counter.RADIO_MISSED);
        long crossed = crossings.of(post.name());
        report.table(new Table(title, "packets sent", "received", "damaged", "missed", "crossed", "unicasts",
                "delivered", "undelivered", "received")
                .row("", sent, at.get(Counter.RADIO_RECEIVED), at.get(Counter.RADIO_DAMAGED),
                        at.get(Counter.RADIO_MISSED), crossed, sum.offered(),
                        sum.delivered(), sum.undelivered(), sum.received()));
        report.never(title + ": packets that nobody can account for",
                Math.max(0, known - sent) + Math.max(0, sent - known - crossed));
        report.never(title + ": packets counted by the board and not on the air, or the reverse",
                Math.abs(sent - air.of(List.of(post)).packets()));
        report.never(title + ": outcomes that board and host count differently",
                Math.abs(from.get(Counter.RADIO_ACKNOWLEDGED) - sum.delivered())
                        + Math.abs(from.get(Counter.RADIO_UNDELIVERED) - sum.undelivered()));
    }
}
