package mobility;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.ProtocolError;
import javino.protocol.ProtocolException;

/**
 * A message between the two hosts of a move (SPEC 9.1).
 *
 * @param move the number of the move, 32 bits, as its sender has chosen it.
 * @param said the content.
 */
record MoveMessage(int move, Said said) {

    private static final int HEAD = 4;
    private static final int NUMBER = 3;
    /** The most bytes of a part in one message. */
    static final int MOST_DATA = 480;
    /** The most parts of an agent. */
    static final int MOST_PARTS = 8;
    /** The most letters of a name. */
    static final int MOST_NAME = 64;
    /** In bytes of UTF-8. */
    private static final int MOST_REASON = 400;

    /** One kind of message. */
    sealed interface Said extends Event permits Offer, Want, Data, Ready, Go, Awake, Cancelled, Refused {

        /** Each kind is called as its class. */
        default HostMessage.Kind kind() {
            return HostMessage.Kind.valueOf("MOVE_" + getClass().getSimpleName().toUpperCase(Locale.ROOT));
        }
    }

    /** An agent wants to come. */
    record Offer(Protocol protocol, List<Part> parts, Move.Identity identity) implements Said {

        /** The bytes of all its texts. */
        long length() {
            return parts.stream().mapToLong(Part::length).sum();
        }
    }

    /** It may; these bytes of its parts are here. */
    record Want(List<Integer> offsets) implements Said {
    }

    /** Some bytes of a part. */
    record Data(int part, int offset, Bytes bytes) implements Said {
    }

    /** The agent is here, as a whole, and sleeps. */
    record Ready() implements Said {
    }

    /** It has gone from where it was: wake it. */
    record Go() implements Said {
    }

    /** It is awake here, by that name. */
    record Awake(String agent) implements Said {
    }

    /** It stays where it was: forget it. */
    record Cancelled() implements Said {
    }

    /** It may not come. */
    record Refused(String error, String reason) implements Said {
    }

    HostMessage encode() {
        return new HostMessage(said.kind(), Bytes.join(Bytes.ofNumber(move, HEAD), body()));
    }

    private Bytes body() {
        if (said instanceof Offer offer) {
            List<Bytes> parts = new ArrayList<>(List.of(Bytes.of(offer.protocol.letter(), offer.parts.size())));
            offer.parts.forEach(part -> parts.add(Bytes.join(part.hash(), Bytes.ofNumber(part.packed(), NUMBER),
                    Bytes.ofNumber(part.length(), NUMBER))));
            parts.add(offer.identity.token());
            parts.add(Bytes.ofText(offer.identity.home().toString() + offer.identity.name()));
            return Bytes.join(parts.toArray(Bytes[]::new));
        }
        if (said instanceof Want want) {
            return Bytes.join(want.offsets.stream().map(offset -> Bytes.ofNumber(offset, NUMBER))
                    .toArray(Bytes[]::new));
        }
        if (said instanceof Data data) {
            return Bytes.join(Bytes.of(data.part), Bytes.ofNumber(data.offset, NUMBER), data.bytes);
        }
        if (said instanceof Awake awake) {
            return Bytes.ofText(awake.agent);
        }
        return said instanceof Refused refused ? Bytes.ofText(refused.error + " " + shortened(refused.reason))
                : Bytes.EMPTY;
    }

    private static String shortened(String reason) {
        String text = reason;
        for (int end = reason.length(); Bytes.ofText(text).length() > MOST_REASON;) {
            end = reason.offsetByCodePoints(end, -1);
            text = reason.substring(0, end) + "…";
        }
        return text;
    }

    /** @throws ProtocolException if it is no message of a move. */
    static MoveMessage decode(HostMessage message) throws ProtocolException {
        expect(message.body().length() >= HEAD, message.body());
        Bytes body = message.body().from(HEAD);
        return new MoveMessage((int) message.body().number(0, HEAD), switch (message.kind()) {
            case MOVE_OFFER -> offer(body);
            case MOVE_WANT -> want(body);
            case MOVE_DATA -> data(body);
            case MOVE_READY -> new Ready();
            case MOVE_GO -> new Go();
            case MOVE_AWAKE -> new Awake(name(body));
            case MOVE_CANCELLED -> new Cancelled();
            case MOVE_REFUSED -> refused(body);
            default -> throw wrong(body);
        });
    }

    private static Said offer(Bytes body) throws ProtocolException {
        expect(body.length() > 2, body);
        Protocol protocol = Protocol.of(body.at(0)).orElseThrow(() -> wrong(body));
        int count = body.at(1);
        int each = Part.HASH_LENGTH + 2 * NUMBER;
        expect(count > 0 && count <= MOST_PARTS && body.length() > 2 + count * each, body);
        List<Part> parts = body.slice(2, 2 + count * each).split(each)
                .map(part -> new Part(part.slice(0, Part.HASH_LENGTH),
                        (int) part.number(Part.HASH_LENGTH, each - NUMBER), (int) part.number(each - NUMBER, each)))
                .toList();
        int home = 2 + count * each + Move.Identity.TOKEN_LENGTH;
        int name = home + Address.LENGTH;
        Address device = Address.decode(body, home);
        expect(device.kind() == Address.Kind.DEVICE && body.length() > name, body);
        return new Offer(protocol, parts, new Move.Identity(device, name(body.from(name)),
                body.slice(home - Move.Identity.TOKEN_LENGTH, home)));
    }

    private static Said want(Bytes body) throws ProtocolException {
        expect(body.length() > 0 && body.length() % NUMBER == 0 && body.length() <= MOST_PARTS * NUMBER, body);
        return new Want(body.split(NUMBER).map(offset -> (int) offset.number(0, NUMBER)).toList());
    }

    private static Said data(Bytes body) throws ProtocolException {
        expect(body.length() > 1 + NUMBER, body);
        return new Data(body.at(0), (int) body.number(1, 1 + NUMBER), body.from(1 + NUMBER));
    }

    private static Said refused(Bytes body) throws ProtocolException {
        String text = body.text();
        int divider = text.indexOf(' ');
        expect(divider > 0 && text.substring(0, divider).matches("[a-z]\\w{0,31}"), body);
        return new Refused(text.substring(0, divider), text.substring(divider + 1));
    }

    private static String name(Bytes body) throws ProtocolException {
        expect(body.length() <= MOST_NAME, body);
        return body.text();
    }

    private static void expect(boolean met, Bytes bytes) throws ProtocolException {
        if (!met) {
            throw wrong(bytes);
        }
    }

    private static ProtocolException wrong(Bytes bytes) {
        return new ProtocolException(ProtocolError.BAD_HOST_MESSAGE, "no message of a move: " + bytes);
    }
}
