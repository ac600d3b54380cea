package keyagreement;

import java.time.LocalDate;
import javino.protocol.Bytes;

/** Days as two bytes: since 1970-01-01. */
final class Days {

    /** The number of bytes. */
    static final int LENGTH = 2;
    /** The last that two bytes hold. */
    static final LocalDate LAST = LocalDate.ofEpochDay(0xFFFF);

    private Days() {
    }

    static boolean fits(LocalDate day) {
        return day.toEpochDay() >= 0 && !day.isAfter(LAST);
    }

    static Bytes encode(LocalDate day) {
        return Bytes.ofNumber(day.toEpochDay(), LENGTH);
    }

    static LocalDate decode(Bytes bytes, int at) {
        return LocalDate.ofEpochDay(bytes.number(at, at + LENGTH));
    }
}
