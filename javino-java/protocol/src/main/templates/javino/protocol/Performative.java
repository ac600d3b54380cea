package javino.protocol;

import java.util.Arrays;
import java.util.Optional;

/** The effect that a message is to have on its receiver: the performatives of Jason, and {@code sorry} (SPEC 3). */
public enum Performative {
    @Performatives.def: /** $3 */ $1("$2"),
    ;

    private final String text;

    Performative(String text) {
        this.text = text;
    }

    /** The performative of that AgentSpeak name, if there is one. */
    public static Optional<Performative> of(String name) {
        return Arrays.stream(values()).filter(performative -> performative.text.equals(name)).findFirst();
    }

    /** Whether it asks for an answer; then it names the conversation. */
    public boolean isQuestion() {
        return switch (this) {
            case ASK_ONE, ASK_ALL, ASK_HOW -> true;
            case TELL, UNTELL, ACHIEVE, UNACHIEVE, SIGNAL, TELL_HOW, UNTELL_HOW, SORRY -> false;
        };
    }

    /** Whether it can be an answer, which names the conversation of the question; {@link #SORRY} always is. */
    public boolean canAnswer() {
        return switch (this) {
            case TELL, UNTELL, TELL_HOW, SORRY -> true;
            case ACHIEVE, UNACHIEVE, SIGNAL, ASK_ONE, ASK_ALL, ASK_HOW, UNTELL_HOW -> false;
        };
    }

    /**
     * Whether it is accepted only by unicast or multicast: no attacker may make an agent answer, see its plans or
     * change them.
     */
    public boolean requiresSeal() {
        return switch (this) {
            case TELL, UNTELL, ACHIEVE, UNACHIEVE, SIGNAL -> false;
            case ASK_ONE, ASK_ALL, ASK_HOW, TELL_HOW, UNTELL_HOW, SORRY -> true;
        };
    }

    /** Whether an agent's program may say it; Javino says {@link #SORRY} by itself. */
    public boolean isSaid() {
        return this != SORRY;
    }

    /** The AgentSpeak name, such as {@code tell} or {@code askOne}. */
    @Override
    public String toString() {
        return text;
    }
}
