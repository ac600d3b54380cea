package javino.protocol;

import java.util.Optional;

/**
 * A message of one agent to another: {@code performative;term} in UTF-8, or {@code performative#conversation;term} for
 * questions and answers (SPEC 3).
 *
 * @param performative the purpose of the message.
 * @param conversation the number that joins a question and its answer; else empty.
 * @param term         an AgentSpeak term; the whole content has at most 494 bytes.
 */
public record Content(Performative performative, Optional<Conversation> conversation, String term) implements Message {

    /** The most bytes of a content: the sealed content fits a frame, and the opened one a poll reply. */
    public static final int MAX_LENGTH = 494;

    private static final char DIVIDER = ';';
    private static final char CONVERSATION_MARK = '#';

    /**
     * @throws IllegalArgumentException if the term is empty, has a lone surrogate, or is too long; if a question or
     *         {@code sorry} has no conversation, or a content that is no question and no answer has one.
     */
    public Content {
        if (!fits(performative, conversation.isPresent())) {
            throw new IllegalArgumentException("a " + performative + (conversation.isEmpty() ? " needs a conversation"
                    : " belongs to no conversation"));
        }
        if (term.isEmpty()) {
            throw new IllegalArgumentException("a content needs a term after \"" + performative + ";\"");
        }
        int length = Bytes.ofText(head(performative, conversation) + term).length();
        if (length > MAX_LENGTH) {
            throw new IllegalArgumentException(
                    "a content has at most " + MAX_LENGTH + " bytes of UTF-8, not " + length);
        }
    }

    /** A content that is no question and no answer. */
    public Content(Performative performative, String term) {
        this(performative, Optional.empty(), term);
    }

    /**
     * Reads a content; the first {@code ;} divides.
     *
     * @throws ProtocolException TOO_LONG, BAD_TEXT, or BAD_CONTENT if there is no known performative or no term.
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
                        "expected a performative such as tell, with"
                                + " a conversation such as #AbC where it asks or answers, then ; and a term, found \""
                                + text
                                + "\""));
    }

    private static Optional<Content> read(String head, String term) {
        int mark = head.indexOf(CONVERSATION_MARK);
        boolean conversing = mark >= 0;
        Optional<Performative> performative = Performative.of(conversing ? head.substring(0, mark) : head);
        Optional<Conversation> conversation = conversing ? Conversation.of(head.substring(mark + 1)) : Optional.empty();
        boolean whole = !term.isEmpty() && conversing == conversation.isPresent();
        return performative.filter(known -> whole && fits(known, conversing))
                .map(known -> new Content(known, conversation, term));
    }

    /** Questions and {@code sorry} are always of a conversation, other answers may be, and nothing else is. */
    private static boolean fits(Performative performative, boolean conversing) {
        return conversing ? performative.isQuestion() || performative.canAnswer()
                : !performative.isQuestion() && performative != Performative.SORRY;
    }

    /** Whether it answers a question. */
    public boolean isAnswer() {
        return conversation.isPresent() && performative.canAnswer();
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

    @Override
    public Bytes encode() {
        return Bytes.ofText(toString());
    }

    /** The content as on the line, {@code performative;term} or {@code performative#conversation;term}. */
    @Override
    public String toString() {
        return head(performative, conversation) + term;
    }

    private static String head(Performative performative, Optional<Conversation> conversation) {
        return performative + conversation.map(known -> CONVERSATION_MARK + known.toString()).orElse("") + DIVIDER;
    }
}
