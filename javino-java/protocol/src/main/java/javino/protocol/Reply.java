package javino.protocol;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;

/**
 * A board's answer (SPEC 4.2): a status and, if that is OK, a body whose form depends on the request.
 *
 * @param status how the request went.
 * @param body   the bytes that the methods below read.
 */
public record Reply(Status status, Bytes body) {

    private static final int CHECK_LENGTH = 3;
    private static final int NUMBER_LENGTH = 3;
    private static final int KEY_LENGTH = Address.LENGTH + 1 + CHECK_LENGTH;
    private static final int COUNTER_LENGTH = 5;
    /** Added to a role. */
    private static final int DOUBTFUL = 4;

    /**
     * A key that a board has.
     *
     * @param address  the device or group that it is shared with.
     * @param role     whether it is the current, the previous, the next or a session key.
     * @param check    its check value (SPEC 5.2), 3 bytes.
     * @param doubtful whether floors of it may be lost: what comes under it is refused, unless above a floor that is
     *                 there.
     */
    public record StoredKey(Address address, Role role, Bytes check, boolean doubtful) {

        /** A key whose floors are all there. */
        public StoredKey(Address address, Role role, Bytes check) {
            this(address, role, check, false);
        }
    }

    /** The role of a key on a board (SPEC 4.3, renew key). The ordinal is the value on the line. */
    public enum Role {
        /** It seals. */
        CURRENT,
        /** The key before a renewal that is not finished: frames sealed with it are still accepted. */
        PREVIOUS,
        /** The key that is to seal next: frames sealed with it are accepted. */
        NEXT,
        /** It seals, and lives in RAM until the board boots. */
        SESSION
    }

    /** @throws ProtocolException BAD_REPLY if the frame is not from board to host, or has no known status. */
    public static Reply decode(Frame frame) throws ProtocolException {
        expect(frame.destination().equals(Address.SERIAL) && frame.origin().equals(Address.SERIAL),
                "a reply goes from ++++ to ++++", frame.header());
        expect(frame.message().length() > 0, "a reply has a status", frame.message());
        Status status = Status.of(frame.message().at(0)).orElseThrow(
                () -> new ProtocolException(ProtocolError.BAD_REPLY, "unknown status " + frame.message().at(0)));
        return new Reply(status, frame.message().from(1));
    }

    /** The answer to hello. */
    public BoardInfo boardInfo() throws ProtocolException {
        return BoardInfo.decode(body);
    }

    /** The answer to poll. */
    public PollReply poll() throws ProtocolException {
        return PollReply.decode(body);
    }

    /** The answer to list actions: the names from the request's offset on. */
    public ActionNames actionNames() throws ProtocolException {
        return ActionNames.decode(body);
    }

    /** The answer to set key, renew key and set session key: the key's check value, 3 bytes. */
    public Bytes checkValue() throws ProtocolException {
        expect(body.length() == CHECK_LENGTH, "a check value has 3 bytes", body);
        return body;
    }

    /** The answer to list keys. */
    public List<StoredKey> storedKeys() throws ProtocolException {
        expect(body.length() % KEY_LENGTH == 0, "listed keys have 8 bytes each", body);
        List<StoredKey> keys = new ArrayList<>();
        for (int at = 0; at < body.length(); at += KEY_LENGTH) {
            keys.add(storedKey(body.slice(at, at + KEY_LENGTH)));
        }
        return List.copyOf(keys);
    }

    private static StoredKey storedKey(Bytes entry) throws ProtocolException {
        int role = entry.at(Address.LENGTH);
        expect(role < 2 * DOUBTFUL, "a key's role is 0…7", entry);
        return new StoredKey(Address.decode(entry, 0), Role.values()[role & ~DOUBTFUL], entry.from(Address.LENGTH + 1),
                (role & DOUBTFUL) != 0);
    }

    /** The answer to statistics, without counters that only later firmware has. */
    public Map<Counter, Long> statistics() throws ProtocolException {
        expect(body.length() % COUNTER_LENGTH == 0, "counters have 5 bytes each", body);
        Map<Counter, Long> values = new EnumMap<>(Counter.class);
        for (int at = 0; at < body.length(); at += COUNTER_LENGTH) {
            long value = body.number(at + 1, at + COUNTER_LENGTH);
            Counter.of(body.at(at)).ifPresent(counter -> values.put(counter, value));
        }
        return Collections.unmodifiableMap(values);
    }

    /** The answer to act: the number that the action returns, -8388608…8388607, if it returns one. */
    public OptionalInt number() throws ProtocolException {
        expect(body.length() == 0 || body.length() == NUMBER_LENGTH, "an action's number has 3 bytes", body);
        // The first byte carries the sign.
        return body.length() == 0 ? OptionalInt.empty()
                : OptionalInt.of((byte) body.at(0) << 16 | (int) body.number(1, NUMBER_LENGTH));
    }

    /** The answer to a transmission: its number, 0…255. */
    public int transmissionNumber() throws ProtocolException {
        expect(body.length() == 1, "a transmission's number has 1 byte", body);
        return body.at(0);
    }

    /** The answer to relaying: whether the board is a relay. */
    public boolean relaying() throws ProtocolException {
        expect(body.length() == 1 && body.at(0) <= 1, "relaying is 0 or 1", body);
        return body.at(0) == 1;
    }

    /** The answer to all other requests: nothing. */
    public void nothing() throws ProtocolException {
        expect(body.length() == 0, "nothing was to be answered", body);
    }

    static void expect(boolean condition, String expected, Bytes found) throws ProtocolException {
        if (!condition) {
            throw new ProtocolException(ProtocolError.BAD_REPLY, expected + ", found " + found.hex());
        }
    }
}
