package diffuser.mind;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import diffuser.gate.Cast;

import javino.protocol.Conversation;

/**
 * Another device's question, as the id of Jason's message carries it through the plans that answer: so the answer finds
 * back without a memory of questions.
 *
 * @param conversation the asker's name for it.
 * @param ofGroup      whether a whole group was asked.
 */
public record IncomingQuestion(Conversation conversation, boolean ofGroup) {

    private static final String ALONE = "rf";
    private static final String GROUP = "rfgroup";
    private static final Pattern MESSAGE_ID = Pattern.compile("(" + ALONE + "|" + GROUP + ")(\\d{1,6})");

    /** Another device's question, by how it came. */
    IncomingQuestion(Conversation conversation, Cast cast) {
        this(conversation, cast == Cast.MULTICAST);
    }

    /** The enquiry that an answer names, if it answers one; null where it names nothing. */
    public static Optional<IncomingQuestion> of(String inReplyTo) {
        Matcher id = MESSAGE_ID.matcher(inReplyTo == null ? "" : inReplyTo);
        if (!id.matches() || Integer.parseInt(id.group(2)) >= Conversation.COUNT) {
            return Optional.empty();
        }
        Conversation conversation = new Conversation(Integer.parseInt(id.group(2)));
        return Optional.of(new IncomingQuestion(conversation, id.group(1).equals(GROUP)));
    }

    /** An atom, as Jason's plans want it. */
    String messageId() {
        return (ofGroup ? GROUP : ALONE) + conversation.id();
    }
}
