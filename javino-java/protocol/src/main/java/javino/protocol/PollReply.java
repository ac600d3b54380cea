package javino.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;

/**
 * The answer to a poll (SPEC 4.3).
 *
 * @param more    whether more is waiting, so that the host should poll again at once.
 * @param leftOut whether some percepts did not fit.
 * @param reading whether the percepts of this reply are all that the board perceives now; otherwise there are none, and
 *                the last ones told still hold.
 * @param damaged whether the board's memory of nonces did not hold since it booted (SPEC 5.1).
 * @param takenTimer the number of the radio's timer if another part of the sketch uses it too.
 * @param records in the order of the reply: transmissions, messages, frames without a key and packets that were
 *                overheard, or percepts.
 */
public record PollReply(boolean more, boolean leftOut, boolean reading, boolean damaged, OptionalInt takenTimer,
        List<Item> records) {

    /** The end of a poll reply's flags in its packet. */
    public static final int FLAGS_END = 1 + Frame.HEADER_LENGTH + 2;
    private static final int MORE = 1;
    private static final int LEFT_OUT = 2;
    private static final int READING = 4;
    private static final int DAMAGED = 8;
    private static final int TIMER_SHIFT = 4;
    private static final int TIMER_MASK = 7;
    private static final int TIME_LENGTH = 4;
    private static final int RECORD_HEADER_LENGTH = 3;
    private static final int ID_OFFSET = 1 + 2 * Address.LENGTH;
    private static final int MESSAGE_HEADER_LENGTH = ID_OFFSET + 3;

    /** The records are copied. */
    public PollReply {
        records = List.copyOf(records);
    }

    /** One record of a poll reply. */
    public sealed interface Item {
    }

    /** @param literal an AgentSpeak literal, by the board's word; UTF-8. */
    public record Percept(Bytes literal) implements Item {
    }

    /**
     * A message from the radio, opened if it was sealed.
     *
     * @param number      0…255 and around; the host names it as taken.
     * @param destination the device, its group, or all.
     * @param origin      the device that sent it.
     * @param id          0…0xFFFFFF; the same if the board, reset meanwhile, gives the message again. 0 for a
     *                    broadcast.
     * @param content     its bytes; according to the sender a {@link Content}.
     */
    public record Message(int number, Address destination, Address origin, int id, Bytes content) implements Item {
    }

    /**
     * The end of a transmission.
     *
     * @param number  0…255, from the reply to its request.
     * @param outcome how it ended.
     */
    public record Transmission(int number, Outcome outcome) implements Item {
    }

    /**
     * A sealed frame came for which the board has no key, so that it could neither open nor check it: anybody may have
     * sent it, in anybody's name.
     *
     * @param destination the board's device or group.
     * @param origin      the device that says that it sent it.
     */
    public record NoKey(Address destination, Address origin) implements Item {
    }

    /** How a packet came that was overheard, in the order of their numbers on the line. */
    public enum Reception {
        /** As it was sent. */
        INTACT,
        /** Damaged, and it could be mended. */
        MENDED,
        /** Damaged beyond mending: what is told of it may be wrong anywhere, and longer or shorter. */
        DAMAGED
    }

    /**
     * A packet that the board heard on the air, whoever it is for.
     *
     * @param millis  when it was here, in ms since the board booted, 0…4 294 967 295.
     * @param how     it came.
     * @param payload 0…77 bytes: a {@link Frame} as it was sent, as a rule.
     */
    public record Overheard(long millis, Reception how, Bytes payload) implements Item {
    }

    /** Whether a packet that begins so seems to be a reply of this sequence byte that carries a reading. */
    public static boolean isReading(int sequence, Bytes begun) {
        return begun.length() >= FLAGS_END && begun.at(0) == sequence
                && begun.at(FLAGS_END - 2) == Status.OK.ordinal() && (begun.at(FLAGS_END - 1) & READING) != 0;
    }

    static PollReply decode(Bytes body) throws ProtocolException {
        Reply.expect(body.length() >= 1, "a poll is answered with flags", body);
        List<Item> records = new ArrayList<>();
        int at = 1;
        while (at < body.length()) {
            Reply.expect(at + RECORD_HEADER_LENGTH <= body.length(), "a record begins with type and length", body);
            int start = at + RECORD_HEADER_LENGTH;
            int end = start + (int) body.number(at + 1, start);
            Reply.expect(end <= body.length(), "a record of " + (end - start) + " bytes at byte " + at, body);
            records.add(decodeItem(body.at(at), body.slice(start, end)));
            at = end;
        }
        int flags = body.at(0);
        int timer = flags >> TIMER_SHIFT & TIMER_MASK;
        return new PollReply((flags & MORE) != 0, (flags & LEFT_OUT) != 0, (flags & READING) != 0,
                (flags & DAMAGED) != 0, timer == 0 ? OptionalInt.empty() : OptionalInt.of(timer - 1), records);
    }

    private static Item decodeItem(int type, Bytes value) throws ProtocolException {
        return switch (type) {
            case 'P' -> new Percept(value);
            case 'M' -> decodeMessage(value);
            case 'T' -> decodeTransmission(value);
            case 'N' -> decodeNoKey(value);
            case 'O' -> decodeOverheard(value);
            default -> throw new ProtocolException(ProtocolError.BAD_REPLY, "unknown type of record " + type);
        };
    }

    private static Message decodeMessage(Bytes value) throws ProtocolException {
        Reply.expect(value.length() >= MESSAGE_HEADER_LENGTH, "a message has number, destination, origin, id", value);
        return new Message(value.at(0), Address.decode(value, 1), Address.decode(value, 1 + Address.LENGTH),
                (int) value.number(ID_OFFSET, MESSAGE_HEADER_LENGTH), value.from(MESSAGE_HEADER_LENGTH));
    }

    private static Transmission decodeTransmission(Bytes value) throws ProtocolException {
        Reply.expect(value.length() == 2, "a transmission has number and outcome", value);
        return new Transmission(value.at(0), Outcome.of(value.at(1))
                .orElseThrow(() -> new ProtocolException(ProtocolError.BAD_REPLY, "unknown outcome " + value.at(1))));
    }

    private static NoKey decodeNoKey(Bytes value) throws ProtocolException {
        Reply.expect(value.length() == 2 * Address.LENGTH, "a frame without a key has destination and origin", value);
        return new NoKey(Address.decode(value, 0), Address.decode(value, Address.LENGTH));
    }

    private static Overheard decodeOverheard(Bytes value) throws ProtocolException {
        Reply.expect(value.length() > TIME_LENGTH, "a packet that was overheard has a time", value);
        int how = value.at(TIME_LENGTH);
        Reply.expect(how < Reception.values().length, "how a packet came is 0…2", value);
        return new Overheard(value.number(0, TIME_LENGTH), Reception.values()[how], value.from(TIME_LENGTH + 1));
    }
}
