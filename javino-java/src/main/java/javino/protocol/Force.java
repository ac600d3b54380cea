package javino.protocol;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** What a message is meant to do to its receiver (SPEC 3). */
public enum Force {
    /** The receiver comes to believe the term. */
    TELL,
    /** The receiver ceases to believe it. */
    UNTELL,
    /** The receiver comes to have it as a goal. */
    ACHIEVE,
    /** The receiver drops the goal. */
    UNACHIEVE;

    private final String text = name().toLowerCase(Locale.ROOT);

    /** The force of that AgentSpeak name, if there is one. */
    public static Optional<Force> of(String name) {
        return Arrays.stream(values()).filter(force -> force.text.equals(name)).findFirst();
    }

    /** The AgentSpeak name: {@code tell}, {@code untell}, {@code achieve} or {@code unachieve}. */
    @Override
    public String toString() {
        return text;
    }
}
