package gateway;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Address;
import javino.protocol.Frame;
import javino.protocol.Payload;

/**
 * What belongs together: fragments and their message's header, acknowledgements and what they answer (SPEC 7.1, 7.3).
 */
final class Exchanges {

    private static final int MOST = 1024;
    private static final int ID = 2;
    /** Cells that ask by the same 12 bits. */
    private static final int MOST_ASKERS = 4;
    /** So long an acknowledgement is on its way to its cell and through it. */
    private static final long UNDER_WAY_MILLIS = 1000;

    private final BoundedMap<String, Address> headers = new BoundedMap<>(MOST);
    private final BoundedMap<String, Set<String>> askers = new BoundedMap<>(MOST);
    private final BoundedMap<String, Long> given = new BoundedMap<>(MOST);

    /** A frame was heard here, or in another cell. */
    void learn(Frame frame, Optional<String> other, long now) {
        Payload packet = Payload.of(frame.encode());
        Payload whole = packet.whole();
        if (whole != packet && Payload.lengthIn(whole.bytes()) > 0) {
            headers.renew(message(frame), Address.parse(whole.destination()));
        }
        if (other.isPresent()) {
            question(whole).ifPresent(question -> {
                Set<String> cells = askers.getOrDefault(question, new LinkedHashSet<>());
                if (cells.size() < MOST_ASKERS) {
                    cells.add(other.get());
                }
                askers.renew(question, cells);
            });
        } else if (frame.destination().kind() == Address.Kind.ACKNOWLEDGEMENT
                && frame.message().length() == Payload.TAG_LENGTH) {
                    given.renew(answer(frame), now);
                }
    }

    /** Whom a fragment is for; nothing where the first fragment of its message is not known. */
    Optional<Address> destination(Frame fragment) {
        return Optional.ofNullable(headers.get(message(fragment)));
    }

    /** The cells from which the frame came that an acknowledgement answers. */
    Set<String> askers(Frame acknowledgement) {
        return askers.getOrDefault(answer(acknowledgement), Set.of());
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
