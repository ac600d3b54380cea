package javino.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A message of one host to another, which no agent sees (SPEC 3.1). Its first byte is 0x80…0xBF, with which no UTF-8
 * text begins: so no content is a host message.
 *
 * @param kind     its kind.
 * @param to       the receiver of a broadcast; of a unicast nothing.
 * @param fragment which fragment it is, from 0; of a kind that has no fragments, 0.
 * @param body     the rest. The whole has at most 494 bytes.
 */
public record HostMessage(Kind kind, Optional<Address> to, int fragment, Bytes body) implements Message {

    /** The most bytes of a fragment: with all before, one packet of a broadcast. */
    public static final int FRAGMENT_LENGTH = 62;

    private static final int FIRST_MASK = 0xC0;
    private static final int FIRST = 0x80;
    private static final int TO_LENGTH = 3;

    /** The purpose of a host message, by which it is decided who may send it. */
    public enum Use {
        /** To come to a key, in a broadcast. */
        HANDSHAKE,
        /** To use a key that hosts have agreed on, which protects it. */
        KEY_AGREEMENT,
        /** To move an agent. */
        MOVE
    }

    /** The kinds, in the order of their numbers on the air. */
    public enum Kind {
        @HostMessages.def: /** $4 */ $1(Use.$2, $3),
        ;

        private static final int ANY = -1;

        private final Use use;
        private final int length;

        Kind(Use use, int length) {
            this.use = use;
            this.length = length;
        }

        /** The purpose of the message. */
        public Use use() {
            return use;
        }

        /** The bytes of the whole; negative for any. */
        public int length() {
            return length;
        }

        /** How many fragments a message has. */
        public int fragments() {
            // A message of 63 bytes fits a packet as a whole.
            return length <= FRAGMENT_LENGTH + 1 ? 1 : 2;
        }

        /** The first byte on the air. */
        public int first() {
            return FIRST | ordinal();
        }

        private boolean isPlain() {
            return use == Use.HANDSHAKE;
        }

        private boolean fits(int fragment, int bodyLength) {
            return fragment < fragments() && (length == ANY || bodyLength == (fragments() == 1 ? length
                    : Math.min(FRAGMENT_LENGTH, length - fragment * FRAGMENT_LENGTH)));
        }
    }

    /** @throws IllegalArgumentException if a broadcast's kind has nobody to be for, a unicast's has, or the length is
     *                                  not that of the kind. */
    public HostMessage {
        if (kind.isPlain() != to.isPresent() || !kind.fits(fragment, body.length())
                || 1 + body.length() > Content.MAX_LENGTH) {
            throw new IllegalArgumentException(kind + " is no host message with fragment " + fragment + " of "
                    + body.length() + " bytes" + to.map(address -> " to " + address).orElse(""));
        }
    }

    /** A message in a unicast. */
    public HostMessage(Kind kind, Bytes body) {
        this(kind, Optional.empty(), 0, body);
    }

    /** A message in a broadcast, of a kind that has one fragment. */
    public HostMessage(Kind kind, Address to, Bytes body) {
        this(kind, Optional.of(to), 0, body);
    }

    /** All fragments of a message, for broadcasts. */
    public static List<HostMessage> fragments(Kind kind, Address to, Bytes message) {
        if (kind.fragments() == 1) {
            return List.of(new HostMessage(kind, to, message));
        }
        List<HostMessage> fragments = new ArrayList<>();
        for (int at = 0; at < message.length(); at += FRAGMENT_LENGTH) {
            fragments.add(new HostMessage(kind, Optional.of(to), fragments.size(),
                    message.slice(at, Math.min(message.length(), at + FRAGMENT_LENGTH))));
        }
        return fragments;
    }

    /** Whether a message on the air is one, of a known kind or not. */
    public static boolean isHostMessage(Bytes message) {
        return message.length() > 0 && message.length() <= Content.MAX_LENGTH
                && (message.at(0) & FIRST_MASK) == FIRST;
    }

    /** @throws ProtocolException BAD_HOST_MESSAGE, if it is of no known kind, or of another length than its kind. */
    public static HostMessage decode(Bytes message) throws ProtocolException {
        int number = isHostMessage(message) ? message.at(0) - FIRST : Kind.values().length;
        if (number >= Kind.values().length) {
            throw new ProtocolException(ProtocolError.BAD_HOST_MESSAGE, "it is of no known kind of host message"
                    + (message.length() == 0 ? "" : String.format(", 0x%02X", message.at(0))));
        }
        Kind kind = Kind.values()[number];
        int head = 1 + (kind.isPlain() ? TO_LENGTH : 0);
        int begin = head + (kind.fragments() == 1 ? 0 : 1);
        if (message.length() < begin) {
            throw wrong(kind, message);
        }
        int fragment = begin == head ? 0 : message.at(head);
        if (!kind.fits(fragment, message.length() - begin)) {
            throw wrong(kind, message);
        }
        return new HostMessage(kind,
                kind.isPlain() ? Optional.of(new Address((int) message.number(1, head))) : Optional.empty(), fragment,
                message.from(begin));
    }

    private static ProtocolException wrong(Kind kind, Bytes message) {
        return new ProtocolException(ProtocolError.BAD_HOST_MESSAGE, "a host message " + kind
                + " has another length, not " + message.length());
    }

    @Override
    public Bytes encode() {
        return Bytes.join(Bytes.of(kind.first()),
                to.map(address -> Bytes.ofNumber(address.value(), TO_LENGTH)).orElse(Bytes.EMPTY),
                kind.fragments() == 1 ? Bytes.EMPTY : Bytes.of(fragment), body);
    }

    /** Its kind. */
    @Override
    public String toString() {
        return "host message " + kind;
    }
}
