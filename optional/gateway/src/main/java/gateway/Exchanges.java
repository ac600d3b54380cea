package gateway;

import java.util.Optional;
import java.util.Set;
import javino.protocol.Address;
import javino.protocol.Frame;
import javino.protocol.Payload;

/**
 * Frames that belong together: fragments and their message's header, acknowledgements and the frames that they answer
 * (SPEC 7.1, 7.3).
 */
final class Exchanges {

    private static final int MOST = 1024;
    private static final int ID = 2;
    /** Cells that ask by the same 12 bits. */
    private static final int MOST_ASKERS = 4;
    /** So long an acknowledgement is on its way to its cell and through it. */
    private static final long UNDER_WAY_MILLIS = 1000;

    private final BoundedMap<String, Address> headers = new BoundedMap<>(MOST);
    private final BoundedMap<String, BoundedMap<String, Boolean>> askers = new BoundedMap<>(MOST);
    private final BoundedMap<String, Long> given = new BoundedMap<>(MOST);

    /** A frame was heard here. */
    void heard(Frame frame, long now) {
        learnHeader(frame);
        if (frame.destination().kind() == Address.Kind.ACKNOWLEDGEMENT
                && frame.message().length() == Payload.TAG_LENGTH) {
            given.renew(answer(frame), now);
        }
    }

    /** A frame has come from another cell: its acknowledgement goes there. */
    void arrived(Frame frame, String cell) {
        learnHeader(frame);
        question(whole(frame)).ifPresent(question -> {
            BoundedMap<String, Boolean> cells = askers.getOrDefault(question, new BoundedMap<>(MOST_ASKERS));
            cells.renew(cell, true);
            askers.renew(question, cells);
        });
    }

    private void learnHeader(Frame frame) {
        header(frame).ifPresent(destination -> headers.renew(message(frame), destination));
    }

    private static Payload whole(Frame frame) {
        return Payload.of(frame.encode()).whole();
    }

    /** The destination of a message, from its first fragment; nothing if this is another frame. */
    private static Optional<Address> header(Frame frame) {
        if (frame.destination().kind() != Address.Kind.FRAGMENT) {
            return Optional.empty();
        }
        Payload packet = Payload.of(frame.encode());
        Payload whole = packet.whole();
        return whole != packet && Payload.lengthIn(whole.bytes()) > 0
                ? Optional.of(Address.parse(whole.destination())) : Optional.empty();
    }

    /**
     * The destination of a frame, or of the message whose fragment it is; nothing if the first fragment is not known.
     */
    Optional<Address> destination(Frame frame) {
        return frame.destination().kind() == Address.Kind.FRAGMENT
                ? header(frame).or(() -> Optional.ofNullable(headers.get(message(frame))))
                : Optional.of(frame.destination());
    }

    /** The cells from which the frame came that an acknowledgement answers. */
    Set<String> askers(Frame acknowledgement) {
        return askers.getOrDefault(answer(acknowledgement), new BoundedMap<>(0)).keySet();
    }

    /** Whether the acknowledgement of a frame was heard here just now. */
    boolean isAnswered(Frame frame, long now) {
        return question(whole(frame)).map(given::get)
                .filter(when -> now - when < UNDER_WAY_MILLIS).isPresent();
    }

    /** The key to an acknowledgement of a frame: the device that answers, and the last 12 bits of the nonce. */
    private static Optional<String> question(Payload whole) {
        return whole.hasNonce() ? Optional.of(whole.destination() + " " + whole.lastBits()) : Optional.empty();
    }

    private static String answer(Frame acknowledgement) {
        return acknowledgement.origin() + " " + (acknowledgement.destination().value() & 0xFFF);
    }

    /** The key to the fragments of a message. */
    private static String message(Frame fragment) {
        return fragment.origin() + " " + fragment.destination().toString().charAt(ID);
    }
}
