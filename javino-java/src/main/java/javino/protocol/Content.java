package javino.protocol;

import java.util.Optional;

/**
 * What one agent says to another: {@code force;term} in UTF-8, or {@code force#conversation;term} for questions and
 * answers (SPEC 3).
 *
 * @param force        what the message is meant to do.
 * @param conversation the number that joins a question and its answer; else empty.
 * @param term         an AgentSpeak term, at least one byte; the whole content has at most 494 bytes.
 */
public record Content(Force force, Optional<Conversation> conversation, String term) {

    /** The most bytes of a content: the sealed content fits a frame, and the opened one a poll reply. */
    public static final int MAX_LENGTH = 494;

    private static final char DIVIDER = ';';
    private static final char CONVERSATION_MARK = '#';

    /**
     * @throws IllegalArgumentException if the term is empty, has no UTF-8 form, or is too long; if a question or
     *         {@code sorry} has no conversation, or a content that is no question and no answer has one.
     */
    public Content {
        if (!fits(force, conversation.isPresent())) {
            throw new IllegalArgumentException("a " + force + (conversation.isEmpty() ? " needs a conversation"
                    : " belongs to no conversation"));
        }
        if (term.isEmpty()) {
            throw new IllegalArgumentException("a content needs a term after \"" + force + ";\"");
        }
        int length = Bytes.ofText(format(force, conversation, term)).length();
        if (length > MAX_LENGTH) {
            throw new IllegalArgumentException(
                    "a content has at most " + MAX_LENGTH + " bytes of UTF-8, not " + length);
        }
    }

    /** A content that is no question and no answer. */
    public Content(Force force, String term) {
        this(force, Optional.empty(), term);
    }

    /**
     * Reads a content; the first {@code ;} divides.
     *
     * @throws ProtocolException TOO_LONG, BAD_TEXT, or BAD_CONTENT if there is no known force or no term.
     */
    public static Content decode(Bytes bytes) throws ProtocolException {
        if (bytes.length() > MAX_LENGTH) {
            throw new ProtocolException(ProtocolError.TOO_LONG,
                    "a content has at most " + MAX_LENGTH + " bytes, not " + bytes.length());
        }
        String text = bytes.text();
        int divider = text.indexOf(DIVIDER);
        return (divider < 0 ? Optional.<Content>empty() : read(text.substring(0, divider), text.substring(divider + 1)))
                .orElseThrow(() -> new ProtocolException(ProtocolError.BAD_CONTENT,
                        "expected a force such as tell, with"
                                + " a conversation such as #AbC where it asks or answers, then ; and a term, found \""
                                + text
                                + "\""));
    }

    private static Optional<Content> read(String head, String term) {
        int mark = head.indexOf(CONVERSATION_MARK);
        boolean conversing = mark >= 0;
        Optional<Force> force = Force.of(conversing ? head.substring(0, mark) : head);
        Optional<Conversation> conversation = conversing ? Conversation.of(head.substring(mark + 1)) : Optional.empty();
        boolean whole = !term.isEmpty() && conversing == conversation.isPresent();
        return force.filter(known -> whole && fits(known, conversing))
                .map(known -> new Content(known, conversation, term));
    }

    /** Questions and {@code sorry} are always of a conversation, other answers may be, and nothing else is. */
    private static boolean fits(Force force, boolean conversing) {
        return conversing ? force.isQuestion() || force.canAnswer() : !force.isQuestion() && force != Force.SORRY;
    }

    /** Whether it answers a question. */
    public boolean isAnswer() {
        return conversation.isPresent() && force.canAnswer();
    }

    /**
     * Reads a content such as {@code tell;help} or {@code askOne#AbC;free(X)}; the first {@code ;} divides.
     *
     * @throws IllegalArgumentException if the text is anything else; the message says what is wrong.
     */
    public static Content parse(String text) {
        try {
            return decode(Bytes.ofText(text));
        } catch (ProtocolException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    /** The content's bytes. */
    public Bytes encode() {
        return Bytes.ofText(toString());
    }

    /** As on the line: {@code force;term} or {@code force#conversation;term}. */
    @Override
    public String toString() {
        return format(force, conversation, term);
    }

    private static String format(Force force, Optional<Conversation> conversation, String term) {
        return force + conversation.map(known -> CONVERSATION_MARK + known.toString()).orElse("") + DIVIDER + term;
    }
}
