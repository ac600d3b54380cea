package gateway;

import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.ProtocolException;

/**
 * What belongs together: fragments and their message's header, acknowledgements and what they answer (SPEC 7.1, 7.3).
 */
final class Exchanges {

    private static final int MOST = 1024;
    private static final int NONCE_LENGTH = 6;
    private static final int PROOF_LENGTH = 8;
    private static final int INDEX = 3;
    private static final int ID = 2;
    private static final char LAST_INDEX = 'H';
    private static final int FRAGMENTS = 8;
    /** So long an acknowledgement is on its way to its cell and through it. */
    private static final long UNDER_WAY_MILLIS = 1000;

    private final BoundedMap<String, Address> headers = new BoundedMap<>(MOST);
    private final BoundedMap<String, Boolean> awaited = new BoundedMap<>(MOST);
    private final BoundedMap<String, Long> given = new BoundedMap<>(MOST);

    /** A frame was heard, here or elsewhere. */
    void learn(Frame frame, boolean here, long now) {
        if (isFirstFragment(frame)) {
            whole(frame).ifPresent(to -> headers.renew(message(frame), to));
        }
        if (here) {
            question(frame).ifPresent(question -> awaited.renew(question, true));
            if (frame.destination().kind() == Address.Kind.ACKNOWLEDGEMENT
                    && frame.message().length() == PROOF_LENGTH) {
                given.renew(answer(frame), now);
            }
        }
    }

    /** Whom a fragment is for; nothing where the first fragment of its message is not known. */
    Optional<Address> destination(Frame fragment) {
        return Optional.ofNullable(headers.get(message(fragment)));
    }

    /** Whether an acknowledgement answers what was heard here. */
    boolean isAwaited(Frame acknowledgement) {
        return awaited.containsKey(answer(acknowledgement));
    }

    /** Whether the acknowledgement of a frame was heard here just now. */
    boolean isAnswered(Frame frame, long now) {
        return question(frame).map(given::get).filter(when -> now - when < UNDER_WAY_MILLIS).isPresent();
    }

    /** By what an acknowledgement of a frame is known: who answers, and the last 12 bits of the nonce. */
    private static Optional<String> question(Frame frame) {
        Bytes message = frame.message();
        Address to = frame.destination();
        if (isFirstFragment(frame)) {
            to = whole(frame).orElse(to);
            message = message.length() > Frame.HEADER_LENGTH ? message.from(Frame.HEADER_LENGTH) : Bytes.EMPTY;
        }
        if (to.kind() != Address.Kind.DEVICE && to.kind() != Address.Kind.MULTICAST
                || message.length() < NONCE_LENGTH) {
            return Optional.empty();
        }
        return Optional.of(to + " " + (message.number(NONCE_LENGTH - 2, NONCE_LENGTH) & 0xFFF));
    }

    private static String answer(Frame acknowledgement) {
        return acknowledgement.origin() + " " + (acknowledgement.destination().value() & 0xFFF);
    }

    /** By what the fragments of a message are known. */
    private static String message(Frame fragment) {
        return fragment.origin() + " " + fragment.destination().toString().charAt(ID);
    }

    private static boolean isFirstFragment(Frame frame) {
        return frame.destination().kind() == Address.Kind.FRAGMENT
                && (frame.destination().value() & 0x3F) % FRAGMENTS == 0;
    }

    /** Whom the message is for that a first fragment begins. */
    private static Optional<Address> whole(Frame first) {
        try {
            Address to = Address.parse(first.message().slice(0, Address.LENGTH).text());
            return Optional.of(to);
        } catch (ProtocolException | IllegalArgumentException | IndexOutOfBoundsException none) {
            return Optional.empty();
        }
    }
}
