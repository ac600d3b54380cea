package gateway;

import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Frame;
import javino.protocol.Payload;

/**
 * What belongs together: fragments and their message's header, acknowledgements and what they answer (SPEC 7.1, 7.3).
 */
final class Exchanges {

    private static final int MOST = 1024;
    private static final int ID = 2;
    /** So long an acknowledgement is on its way to its cell and through it. */
    private static final long UNDER_WAY_MILLIS = 1000;

    private final BoundedMap<String, Address> headers = new BoundedMap<>(MOST);
    private final BoundedMap<String, Boolean> awaited = new BoundedMap<>(MOST);
    private final BoundedMap<String, Long> given = new BoundedMap<>(MOST);

    /** A frame was heard, here or elsewhere. */
    void learn(Frame frame, boolean here, long now) {
        Payload packet = Payload.of(frame.encode());
        Payload whole = packet.whole();
        if (whole != packet && Payload.lengthIn(whole.bytes()) > 0) {
            headers.renew(message(frame), Address.parse(whole.destination()));
        }
        if (here) {
            question(whole).ifPresent(question -> awaited.renew(question, true));
            if (frame.destination().kind() == Address.Kind.ACKNOWLEDGEMENT
                    && frame.message().length() == Payload.TAG_LENGTH) {
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
        return question(Payload.of(frame.encode()).whole()).map(given::get)
                .filter(when -> now - when < UNDER_WAY_MILLIS).isPresent();
    }

    /** By what an acknowledgement of a frame is known: who answers, and the last 12 bits of the nonce. */
    private static Optional<String> question(Payload whole) {
        return whole.hasNonce() ? Optional.of(whole.destination() + " " + whole.lastBits()) : Optional.empty();
    }

    private static String answer(Frame acknowledgement) {
        return acknowledgement.origin() + " " + (acknowledgement.destination().value() & 0xFFF);
    }

    /** By what the fragments of a message are known. */
    private static String message(Frame fragment) {
        return fragment.origin() + " " + fragment.destination().toString().charAt(ID);
    }
}
