package uppaal.conformance;

import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AirtimeCheckTest {
    /** So many unicasts of 239.5 ms, one each so many seconds. */
    private static String sends(int count, double apart, double from) {
        return IntStream.range(0, count).mapToObj(i -> String.format(Locale.ROOT, "%.3f b UNICAST",
                from + i * apart)).collect(Collectors.joining("; ", "; ", ""));
    }

    /** 1 % of an hour are 36 s, so 150 of them. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "148, 1, accepted",
            "152, 1, b has sent for 36.165 s",
            "152, 24.1, accepted",
            "152, 23.5, expected 1 % of it at most"})
    void packets_ofAnHour_areWithinTheShare(String row) {
        String[] cells = row.split(", ");
        Story.check(AirtimeCheck::new, "0.5 AIRTIME_LIMIT percent=1"
                + sends(Integer.parseInt(cells[0]), Double.parseDouble(cells[1]), 1), cells[2]);
    }

    @Test
    void reset_doesNotForgetWhatWasSent() {
        Story.check(AirtimeCheck::new, "0.5 AIRTIME_LIMIT percent=1" + sends(100, 1, 1)
                + "; 200 reset why=fault; 201 AIRTIME_LIMIT percent=1" + sends(60, 1, 202), "b has sent");
    }

    @Test
    void board_withoutALimit_sendsAtWill() {
        Story.check(AirtimeCheck::new, "0.5 QUIET" + sends(400, 1, 1), "accepted");
    }
}
