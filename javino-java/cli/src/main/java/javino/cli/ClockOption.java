package javino.cli;

import java.security.SecureRandom;
import java.time.LocalDate;
import javino.JavinoException;
import javino.keyring.BoundedClock;
import javino.link.Time;
import picocli.CommandLine.Option;

/** The option of a command that takes steps by this computer's clock which cannot be undone. */
public final class ClockOption {

    private final BoundedClock clock;
    private final Time time;

    @Option(names = "--clock-is-right",
            description = "Believe a day that is more than 20 years after this release.")
    private boolean isRight;

    /** An option by the system's clock. */
    public ClockOption() {
        this(Time.REAL);
    }

    /** An option by another time. */
    public ClockOption(Time time) {
        this(new BoundedClock(time, false), time);
    }

    ClockOption(BoundedClock clock, Time time) {
        this.clock = clock;
        this.time = time;
    }

    /** Random numbers for keys, by the same time. */
    public SecureRandom secureRandom() {
        return time.secureRandom();
    }

    /** The clock. @throws JavinoException if it is not believed. */
    public BoundedClock checked() throws JavinoException {
        BoundedClock checked = clock();
        checked.check();
        return checked;
    }

    /** Its day. @throws JavinoException if it is not believed. */
    public LocalDate day() throws JavinoException {
        return checked().day();
    }

    /**
     * For a day that came in a file.
     *
     * @throws JavinoException if it is not believed.
     */
    public void check(Object whose, LocalDate day) throws JavinoException {
        if (!clock().believes(day)) {
            throw new JavinoException(BoundedClock.notBelieved(whose, day)
                    + "; if that is right, say --clock-is-right");
        }
    }

    private BoundedClock clock() {
        return isRight ? clock.right() : clock;
    }
}
