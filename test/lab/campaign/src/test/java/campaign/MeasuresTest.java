package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.CrossedPackets;
import harness.Table;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import trace.TraceEvent;

/** The small instruments. */
class MeasuresTest {

    @Test
    void percent_nearTheAim_hasThePlacesToTellIt() {
        assertEquals("99.925 %", Table.percent(3997, 4000));
        assertEquals("100 %", Table.percent(5, 5));
        assertEquals("0 %", Table.percent(0, 5));
        assertEquals("50.0 %", Table.percent(1, 2));
        assertEquals("-", Table.percent(0, 0));
    }

    @Test
    void spread_figuresThatReadAlike_areOne() {
        assertEquals("1.0…12.5", Table.spread("%.1f", DoubleStream.of(3, 12.49, 1)));
        assertEquals("1.0", Table.spread("%.1f", DoubleStream.of(1.01, 0.99)));
    }

    @Test
    void table_rowOfAnotherWidth_isRefused() {
        assertThrows(IllegalArgumentException.class, () -> new Table("a", "b").row(1));
    }

    @Test
    void pace_countThatStands_isTimedUntilItRises() {
        Pace pace = new Pace();
        pace.see(1, 0);
        pace.see(3, 1);
        pace.see(8, 1);
        pace.see(9, 2);
        assertEquals(5, pace.longest());
    }

    @Test
    void offer_seedsInARow_beginAtTimesOfTheirOwn() throws InterruptedException {
        CountDownLatch first = new CountDownLatch(550);
        AtomicInteger begun = new AtomicInteger();
        try (Metronome metronome = new Metronome()) {
            for (int seed = 0; seed < 1000; seed++) {
                new Offer(metronome, seed, 1, 1, () -> {
                    begun.incrementAndGet();
                    first.countDown();
                });
            }
            metronome.see(TraceEvent.parse(1, "{\"t\": 1, \"event\": \"pin\"}"));
            assertTrue(first.await(2, TimeUnit.MINUTES),
                    () -> "of 1000, whose first times are a second away on average, " + begun + " came within it");
        }
        assertTrue(begun.get() < 720, () -> "632 were to be expected, not " + begun);
    }

    @Test
    void longestWait_shareOfMessages_isTheLongestOfThem() {
        Traffic.Sent sent = new Traffic.Sent(Ledger.Sum.ZERO, List.of(3.0, 1.0)).plus(
                new Traffic.Sent(Ledger.Sum.ZERO, List.of(4.0, 2.0)));
        assertEquals(2, sent.longestWait(0.5));
        assertEquals(3, sent.longestWait(0.51));
        assertEquals(4, sent.longestWait(1.0));
        assertEquals(0, Traffic.Sent.NONE.longestWait(0.5));
    }

    @Test
    void groups_plansOfManySizes_fillFewEmulatorsAndNoneTooMuch() {
        List<TrafficRun.Plan> plans =
                java.util.stream.Stream.of(2, 20, 5, 40, 20, 5).map(MeasuresTest::plan).toList();
        List<List<TrafficRun.Plan>> groups = TrafficRun.groups(plans);
        assertEquals(List.of(List.of(40, 5, 2), List.of(20, 20, 5)),
                groups.stream().map(group -> group.stream().map(TrafficRun.Plan::boards).toList()).toList());
        assertEquals(Field.MOST_BOARDS, groups.get(0).stream().mapToInt(TrafficRun.Plan::boards).sum());
    }

    private static TrafficRun.Plan plan(int boards) {
        return new TrafficRun.Plan(new Field.Cell("Station", boards), List.of());
    }

    @Test
    void crossings_packetsAtTheSameTime_areCountedOnceEach() {
        CrossedPackets crossings = new CrossedPackets();
        send(crossings, "a", 1, 2);
        send(crossings, "b", 2.5, 4);
        send(crossings, "a", 3, 5);
        send(crossings, "b", 4.5, 6);
        send(crossings, "a", 7, 8);
        assertEquals(1, crossings.of("a"));
        assertEquals(2, crossings.of("b"));
    }

    private static void send(CrossedPackets crossings, String board, double start, double end) {
        crossings.see(TraceEvent.parse(1, Table.text(
                "{\"t\":%f,\"board\":\"%s\",\"event\":\"rf-tx\",\"start\":%f,\"end\":%f}", end, board, start, end)));
    }

    @Test
    void faultPlan_hasAsManyOfEachKindForEachPairAtItsTime() {
        List<Fault> faults = FaultPlan.of(1, 4, 20, 10);
        Map<Fault.Kind, Integer> counts = new EnumMap<>(Fault.Kind.class);
        faults.forEach(fault -> counts.merge(fault.kind(), 1, Integer::sum));
        assertEquals(List.of(20, 20, 20, 20, 20), List.copyOf(counts.values()));
        for (int i = 4; i < faults.size(); i++) {
            assertEquals(faults.get(i - 4).pair(), faults.get(i).pair());
            assertEquals(FaultPlan.BETWEEN_SECONDS, faults.get(i).second() - faults.get(i - 4).second(), 1);
        }
        assertEquals(faults, FaultPlan.of(1, 4, 20, 10));
    }
}
