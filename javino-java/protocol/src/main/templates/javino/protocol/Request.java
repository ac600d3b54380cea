package javino.protocol;

import java.time.Duration;

/**
 * A request of a host to its board (SPEC 4.3). {@code toString} describes it for error lines and never shows a key.
 *
 * @param command     which request it is.
 * @param frame       the frame that carries it.
 * @param description for error lines.
 */
public record Request(Command command, Frame frame, String description) {

    /** The version of the protocol that these classes speak. */
    public static final int PROTOCOL_VERSION = 1;
    /** A value in place of a message's number: no message was taken yet. */
    public static final int NOTHING_TAKEN = -1;
    /** The longest hold that a poll can allow, in ms. */
    public static final int MAX_HOLD_MILLIS = 0xFFFF;
    /** The longest least time between two readings that a poll can ask for, in ms: more than 4 hours. */
    public static final int MAX_LEAST_MILLIS = 0xFFFFFF;

    static final int MAX_OFFSET = 0xFFFF;
    /** The place of the hold in the message of a poll, behind command and flags. */
    private static final int HOLD_AT = 2;

    /** All requests, with their letters on the line. */
    public enum Command {
        @Commands.def: /** $6 */ $1($2, Boards.$4, $5),
        /** Transmits a content: the frame is for another device, and has no letter. */
        TRANSMIT('\0', Boards.RADIO, false);

        private enum Boards {
            ANY, RADIO, WHOLE_RADIO
        }

        private final char letter;
        private final Boards boards;
        private final boolean writesEeprom;

        Command(char letter, Boards boards, boolean writesEeprom) {
            this.letter = letter;
            this.boards = boards;
            this.writesEeprom = writesEeprom;
        }

        /** The letter on the line. */
        public char letter() {
            return letter;
        }

        /** Whether the board writes to its EEPROM before it answers; that takes up to 270 ms. */
        public boolean writesEeprom() {
            return writesEeprom;
        }

        /** Whether it puts a key into EEPROM. */
        public boolean storesKey() {
            return this == SET_KEY || this == RENEW_KEY;
        }

        /** Whether only a board with a radio performs it. */
        public boolean needsRadio() {
            return boards != Boards.ANY;
        }

        /** Whether no board with sealed unicasts only performs it, to whatever address. */
        public boolean needsWholeRadio() {
            return boards == Boards.WHOLE_RADIO;
        }

        private Request with(Bytes body, String description) {
            Bytes message = Bytes.join(Bytes.of(letter), body);
            return new Request(this, new Frame(Address.SERIAL, Address.SERIAL, message), description);
        }
    }

    private static void check(boolean condition, String complaint, Object found) {
        if (!condition) {
            throw new IllegalArgumentException(complaint + ", not " + found);
        }
    }

    /** {@link Command#HELLO}. */
    public static Request hello() {
        return Command.HELLO.with(Bytes.of(PROTOCOL_VERSION), "hello");
    }

    /** The percepts that a poll asks for. */
    public enum Percepts {
        /** None. */
        NONE(0),
        /** A reading as soon as it differs from the last one that the board told. */
        CHANGED(1),
        /** A reading at once, even if it is the same. */
        NOW(3);

        private final int flags;

        Percepts(int flags) {
            this.flags = flags;
        }
    }

    /** The state of the replies to a host's polls before, as far as the host knows it. */
    public enum LastReply {
        /** All are here: what they told may be forgotten. */
        HERE(0),
        /** One is lost: what it told is to be told again. */
        LOST(4),
        /** One may still come: neither. */
        COMING(8);

        private final int flag;

        LastReply(int flag) {
            this.flag = flag;
        }
    }

    /**
     * {@link Command#POLL}.
     *
     * @param percepts  the percepts that are wanted.
     * @param holdMillis how long the board may hold its reply while it has nothing to tell, 0…65 535 ms.
     * @param leastMillis the least time from one reading told to the next, 0…16 777 215 ms.
     * @param taken     the number of the last message that the host has taken, 0…255, or {@link #NOTHING_TAKEN}.
     * @param lastReply the state of the replies to the polls before.
     * @throws IllegalArgumentException if a number is out of its range.
     */
    public static Request poll(Percepts percepts, int holdMillis, int leastMillis, int taken, LastReply lastReply) {
        check(taken >= NOTHING_TAKEN && taken <= 0xFF, "a message's number is 0…255", taken);
        check(holdMillis >= 0 && holdMillis <= MAX_HOLD_MILLIS, "a reply is held for 0…65 535 ms", holdMillis);
        check(leastMillis >= 0 && leastMillis <= MAX_LEAST_MILLIS,
                "the least time between readings is 0…16 777 215 ms", leastMillis);
        Bytes body = Bytes.join(Bytes.of(percepts.flags | lastReply.flag), Bytes.ofNumber(holdMillis, 2),
                Bytes.ofNumber(leastMillis, 3));
        return Command.POLL.with(taken == NOTHING_TAKEN ? body : Bytes.join(body, Bytes.of(taken)), "poll");
    }

    /** How long the board may wait before it replies: zero, but for a poll. */
    public Duration hold() {
        return command() == Command.POLL
                ? Duration.ofMillis(frame.message().number(HOLD_AT, HOLD_AT + 2)) : Duration.ZERO;
    }

    /**
     * {@link Command#ACT}.
     *
     * @param action {@code name} or {@code name(arguments)}; 1…510 bytes of UTF-8.
     * @throws IllegalArgumentException if the action is empty or does not fit a frame.
     */
    public static Request act(String action) {
        Bytes text = Bytes.ofText(action);
        check(text.length() >= 1 && text.length() < Frame.MAX_MESSAGE_LENGTH, "an action has 1…510 bytes of UTF-8",
                text.length());
        return Command.ACT.with(text, "act " + action);
    }

    /**
     * {@link Command#LIST_ACTIONS}.
     *
     * @param offset the number of bytes of the names that are known already, 0…65535.
     * @throws IllegalArgumentException if the offset is out of range.
     */
    public static Request listActions(int offset) {
        check(offset >= 0 && offset <= MAX_OFFSET, "an offset among the names of actions is 0…65535", offset);
        return Command.LIST_ACTIONS.with(Bytes.ofNumber(offset, 2), "list actions");
    }

    /**
     * {@link Command#SET_RF_ID}.
     *
     * @throws IllegalArgumentException if the address is no device's.
     */
    public static Request setRfId(Address id) {
        check(id.kind() == Address.Kind.DEVICE, "an RF id begins with one of A-Z a-z 0-9", id);
        return Command.SET_RF_ID.with(id.toBytes(), "set RF id " + id);
    }

    /** {@link Command#RADIO}. */
    public static Request radio(boolean open) {
        return Command.RADIO.with(Bytes.of(open ? 1 : 0), open ? "open radio" : "block radio");
    }

    /** {@link Command#OVERHEAR}. */
    public static Request overhear(boolean on) {
        return Command.OVERHEAR.with(Bytes.of(on ? 1 : 0), on ? "overhear" : "overhear no more");
    }

    /**
     * {@link Command#RELAY}.
     *
     * @param frame another device's, as it was on the air: of 10…77 bytes if the radio is the usual one.
     * @throws IllegalArgumentException if the frame is too long for any packet of a radio.
     */
    public static Request relay(Frame frame) {
        check(frame.length() < Frame.MAX_MESSAGE_LENGTH, "a frame that is relayed has at most 510 bytes",
                frame.length());
        return Command.RELAY.with(frame.encode(), "relay from " + frame.origin() + " to " + frame.destination());
    }

    /**
     * {@link Command#RELAYING}, on.
     *
     * @param number 0…0xFFFF, a random one: two relays with the same number may send at the same time, again and again.
     * @throws IllegalArgumentException if the number is out of range.
     */
    public static Request relaying(int number) {
        check(number >= 0 && number <= 0xFFFF, "a relay's number is 0…65535", number);
        return Command.RELAYING.with(Bytes.join(Bytes.of(1), Bytes.ofNumber(number, 2)), "relaying on");
    }

    /** {@link Command#RELAYING}, off. */
    public static Request notRelaying() {
        return Command.RELAYING.with(Bytes.of(0), "relaying off");
    }

    /** {@link Command#RELAYING}, without a change. */
    public static Request isRelaying() {
        return Command.RELAYING.with(Bytes.EMPTY, "is it relaying");
    }

    /**
     * {@link Command#RAISE_EPOCH}.
     *
     * @param epoch 0…0xFFFFFE.
     * @throws IllegalArgumentException if the epoch is out of range.
     */
    public static Request raiseEpoch(int epoch) {
        check(epoch >= 0 && epoch <= BoardInfo.LAST_EPOCH, "an epoch is 0…16777214", epoch);
        return Command.RAISE_EPOCH.with(Bytes.ofNumber(epoch, 3), "raise epoch to " + epoch);
    }

    /**
     * {@link Command#SET_KEY}.
     *
     * @param address the device or group that the key is shared with.
     * @throws IllegalArgumentException if the address is neither a device's nor a group's.
     */
    public static Request setKey(Address address, Key key) {
        return Command.SET_KEY.with(keyFor(address, key), "set key for " + address);
    }

    /**
     * {@link Command#RENEW_KEY}.
     *
     * @param address the device or group that the key is shared with.
     * @throws IllegalArgumentException if the address is neither a device's nor a group's.
     */
    public static Request renewKey(Address address, Key key) {
        return Command.RENEW_KEY.with(keyFor(address, key), "renew key for " + address);
    }

    /**
     * {@link Command#SET_SESSION_KEY}.
     *
     * @param device the device that the key is shared with.
     * @param key    fresh: agreed on with the device just now, and never set before.
     * @throws IllegalArgumentException if the address is no device's.
     */
    public static Request setSessionKey(Address device, Key key) {
        check(device.kind() == Address.Kind.DEVICE, "a session key is for a device such as ROMA", device);
        return Command.SET_SESSION_KEY.with(keyFor(device, key), "set session key for " + device);
    }

    private static Bytes keyFor(Address address, Key key) {
        check(address.kind() == Address.Kind.DEVICE || address.kind() == Address.Kind.MULTICAST,
                "a key is for a device such as ROMA or a group such as //SU", address);
        return Bytes.join(address.toBytes(), key.bytes());
    }

    /** Whether the board seals it. */
    public boolean isSealed() {
        return command == Command.TRANSMIT && !frame.destination().equals(Address.BROADCAST);
    }

    /**
     * Whether a board that has sealed unicasts only refuses it.
     *
     * @throws ProtocolException if its key is for no address.
     */
    public boolean needsWholeRadio() throws ProtocolException {
        return command.needsWholeRadio()
                || command == Command.TRANSMIT && frame.destination().kind() != Address.Kind.DEVICE
                || command == Command.SET_KEY
                        && Address.decode(frame.message(), 1).kind() != Address.Kind.DEVICE;
    }

    /** {@link Command#USE_KEY}. */
    public static Request useKey(Address address) {
        return Command.USE_KEY.with(address.toBytes(), "use key for " + address);
    }

    /** {@link Command#FINISH_RENEWAL}. */
    public static Request finishRenewal(Address address) {
        return Command.FINISH_RENEWAL.with(address.toBytes(), "finish renewal of the key for " + address);
    }

    /** {@link Command#DELETE_KEY}. */
    public static Request deleteKey(Address address) {
        return Command.DELETE_KEY.with(address.toBytes(), "delete key for " + address);
    }

    /** {@link Command#LIST_KEYS}. */
    public static Request listKeys() {
        return Command.LIST_KEYS.with(Bytes.EMPTY, "list keys");
    }

    /** {@link Command#STATISTICS}. */
    public static Request statistics() {
        return Command.STATISTICS.with(Bytes.EMPTY, "statistics");
    }

    /**
     * {@link Command#TRANSMIT}.
     *
     * @param destination the receiver; the board checks whether anything can be sent to it.
     * @param origin      the board's RF id.
     * @param message     plain; the board seals it.
     * @throws IllegalArgumentException if the destination is the serial line, which would be a command.
     */
    public static Request transmit(Address destination, Address origin, Message message) {
        check(!destination.equals(Address.SERIAL), "a transmission goes to an RF address", destination);
        return new Request(Command.TRANSMIT, new Frame(destination, origin, message.encode()),
                "transmit to " + destination + ": " + message);
    }

    @Override
    public String toString() {
        return description;
    }
}
