package javino.board;

import java.time.Duration;

/** What the host wants of the board as long as the session lasts, set by any thread. */
final class Wishes {

    private volatile boolean percepts;
    private volatile Duration perceptInterval = Duration.ZERO;
    private volatile Boolean radio;
    private final Readings readings = new Readings();

    boolean percepts() {
        return percepts;
    }

    void setPercepts(boolean wanted) {
        percepts = wanted;
    }

    /** The least time between two sets of percepts. */
    Duration perceptInterval() {
        return perceptInterval;
    }

    void setPerceptInterval(Duration least) {
        perceptInterval = least;
    }

    /** Who waits for percepts. */
    Readings readings() {
        return readings;
    }

    /** Whether the radio is to be open; null where nobody said so yet. */
    Boolean radio() {
        return radio;
    }

    void setRadio(boolean open) {
        radio = open;
    }
}
