package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import javino.protocol.Counter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The airtime of an hour, by readings of counters. */
class AirtimeHourTest {

    private final AirtimeHour hour = new AirtimeHour();

    private void read(long seconds, long counted) {
        hour.take(Map.of(Counter.RADIO_AIRTIME, counted), TimeUnit.SECONDS.toNanos(seconds));
    }

    private AirtimeHour.Use use(long seconds) {
        return hour.use(TimeUnit.SECONDS.toNanos(seconds)).orElseThrow();
    }

    private double share() {
        return use(0).share();
    }

    @Test
    void use_beforeTheFirstReading_isNotKnown() {
        assertEquals(Optional.empty(), hour.use(0));
    }

    @Test
    void share_isOfAWholeHour_andOfNothingBeforeTheFirstReading() {
        read(0, 500);
        assertEquals(new AirtimeHour.Use(0, 0, 0), use(0));
        read(60, 536);
        assertEquals(new AirtimeHour.Use(1, 1, 0), use(60));
    }

    @Test
    void share_forgetsWhatIsOlderThanAnHour_mostDoesNot() {
        for (int minute = 0; minute <= 60; minute++) {
            read(60 * minute, 6 * minute);
        }
        assertEquals(10, share());
        for (int minute = 61; minute <= 90; minute++) {
            read(60 * minute, 360);
        }
        assertEquals(new AirtimeHour.Use(5, 10, 0), use(90 * 60));
        for (int minute = 91; minute <= 130; minute++) {
            read(60 * minute, 360);
        }
        assertEquals(new AirtimeHour.Use(0, 10, 0), use(130 * 60));
    }

    @Test
    void share_ofReadingsFarApart_countsAsSentEvenly() {
        read(0, 0);
        read(3 * 3600, 1080);
        assertEquals(10, share());
    }

    @Test
    void share_afterABoot_addsWhatWasSentSince() {
        read(0, 100);
        read(60, 118);
        read(120, 18);
        assertEquals(1, share());
        read(180, 18);
        hour.take(Map.of(), TimeUnit.SECONDS.toNanos(240));
        read(300, 36);
        assertEquals(2, share(), "a counter of 0 may be left out");
    }

    @Test
    void use_ofACounterThatHasStopped_isNotKnown() {
        read(0, 65_500);
        read(60, 65_535);
        assertEquals(1, share());
        read(120, 65_535);
        assertEquals(Optional.empty(), hour.use(0));
        read(180, 0);
        assertEquals(1, share());
    }

    @Test
    void wait_countsDown() {
        hour.take(Map.of(Counter.AIRTIME_WAIT, 42L), 0);
        assertEquals(42, use(0).waitSeconds());
        assertEquals(42, hour.use(1).orElseThrow().waitSeconds());
        assertEquals(2, use(40).waitSeconds());
        assertEquals(0, use(60).waitSeconds());
        assertEquals("0.0 % of the last hour, at most 0.0 % of one; its limit holds messages back for 42 s",
                use(0).toString());
    }

    /** The radio sends or not for each second; readings come at any second. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void share_ofRandomSending_isThatOfTheHourBefore(int seed) {
        Random random = new Random(seed);
        int length = 4 * 3600;
        int[] sent = new int[length + 1];
        for (int i = 0; i < length; i++) {
            boolean busy = i / 900 % 2 == seed % 2;
            sent[i + 1] = sent[i] + (random.nextInt(10) < (busy ? 8 : 1) ? 1 : 0);
        }
        int boot = 0;
        double most = 0;
        for (int now = 0; now < length; now += 1 + random.nextInt(90)) {
            read(now, sent[now] - sent[boot]);
            if (random.nextInt(30) == 0) {
                boot = now;
                read(now, 0);
            }
            double exact = (sent[now] - sent[Math.max(0, now - 3600)]) / 36.0;
            most = Math.max(most, share());
            assertEquals(exact, share(), 1.3, "at second " + now);
            assertEquals(most, use(0).most());
        }
        assertTrue(most > 40);
    }
}
