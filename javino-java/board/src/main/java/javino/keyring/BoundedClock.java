package javino.keyring;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.LocalDate;
import java.time.ZoneId;
import javino.JavinoException;
import javino.link.Time;
import javino.protocol.BoardInfo;

/**
 * This computer's clock, as far as it is believed: one that is years ahead by mistake must not use up what cannot be
 * given back, such as a board's epochs (SPEC 5.1) or the days of an authority.
 *
 * @param source  the clock that tells the time.
 * @param isRight whether a person has said that it is right, whatever it says.
 */
public record BoundedClock(InstantSource source, boolean isRight) {

    /** The system's. */
    public static final BoundedClock SYSTEM = new BoundedClock(Time.REAL, false);

    /** When this release was made; {@code NumbersTest} holds the pages to it. */
    public static final LocalDate RELEASED = LocalDate.of(2026, 11, 29);

    /** A later day is not believed. */
    public static final LocalDate LATEST = RELEASED.plusYears(20);

    private static final Instant FIRST_EPOCH = Instant.parse("2026-01-01T00:00:00Z");

    /** However right a clock is, it leaves a board epochs for as many boots as its EEPROM lasts, and more. */
    private static final int LEFT = 0x100000;

    /** How far ahead of the clock an epoch may be that a board claims: 5 years, in minutes. */
    private static final int AHEAD = 5 * 366 * 24 * 60;

    /** A clock at a fixed time. */
    public static BoundedClock at(Instant time) {
        return new BoundedClock(InstantSource.fixed(time), false);
    }

    /** The same, of which a person has said that it is right. */
    public BoundedClock right() {
        return new BoundedClock(source, true);
    }

    /** Its day here. */
    public LocalDate day() {
        return source.instant().atZone(ZoneId.systemDefault()).toLocalDate();
    }

    /** Whether a day can be right. */
    public boolean believes(LocalDate day) {
        return isRight || !day.isAfter(LATEST);
    }

    /** Whether what it says can be right. */
    public boolean isBelieved() {
        return believes(day());
    }

    /** Checks it before a step that cannot be undone. @throws JavinoException if it is not believed, and what to do. */
    public void check() throws JavinoException {
        if (!isBelieved()) {
            throw new JavinoException(notBelieved() + "; set it, or say --clock-is-right");
        }
    }

    /** The text that this clock cannot be right. */
    public String notBelieved() {
        return notBelieved("this computer's clock", day());
    }

    /** The text that a day cannot be right. */
    public static String notBelieved(Object whose, LocalDate day) {
        return whose + " says " + day + ", more than 20 years after this release of Javino";
    }

    /**
     * The epoch of now: minutes since 2026, so that they last for 29 years and more. 0 before 2026, as a computer
     * without a clock has it, and where the clock is not believed.
     */
    public int epoch() {
        long minutes = isBelieved() ? Duration.between(FIRST_EPOCH, source.instant()).toMinutes() : 0;
        return (int) Math.min(BoardInfo.LAST_EPOCH - LEFT, Math.max(0, minutes));
    }

    /** The highest epoch that a board may claim; any, where the clock does not help. */
    public int most() {
        return epoch() == 0 ? BoardInfo.LAST_EPOCH : Math.min(BoardInfo.LAST_EPOCH, epoch() + AHEAD);
    }
}
