package javino.protocol;

/** What a host asks of its board (SPEC 4.3). {@code toString} describes it for error lines and never shows a key. */
public sealed interface Request {

    /** The version of the protocol that these classes speak. */
    int PROTOCOL_VERSION = 1;

    /** The frame that carries the request. */
    Frame frame();

    /** A request for which the board writes to its EEPROM before it answers; that takes up to 270 ms. */
    sealed interface EepromWrite extends Request { }

    private static Frame command(char command, Bytes body) {
        return new Frame(Address.SERIAL, Address.SERIAL, Bytes.join(Bytes.of(command), body));
    }

    private static void check(boolean condition, String complaint, Object found) {
        if (!condition) {
            throw new IllegalArgumentException(complaint + ", not " + found);
        }
    }

    /** Tells the host's protocol version and asks who the board is. */
    record Hello() implements Request {
        @Override
        public Frame frame() {
            return command('H', Bytes.of(PROTOCOL_VERSION));
        }

        @Override
        public String toString() {
            return "hello";
        }
    }

    /**
     * Asks for what is new.
     *
     * @param percepts whether percepts are wanted.
     * @param taken    the number 0…255 of the last message taken over, or {@link #NOTHING_TAKEN}.
     */
    record Poll(boolean percepts, int taken) implements Request {

        /** No message was taken over yet. */
        public static final int NOTHING_TAKEN = -1;

        /** @throws IllegalArgumentException if the number is out of range. */
        public Poll {
            check(taken >= NOTHING_TAKEN && taken <= 0xFF, "a message's number is 0…255", taken);
        }

        @Override
        public Frame frame() {
            Bytes flags = Bytes.of(percepts ? 1 : 0);
            return command('P', taken == NOTHING_TAKEN ? flags : Bytes.join(flags, Bytes.of(taken)));
        }

        @Override
        public String toString() {
            return "poll";
        }
    }

    /**
     * Has an action performed.
     *
     * @param action {@code name} or {@code name(arguments)}; 1…510 bytes of UTF-8.
     */
    record Act(String action) implements Request {

        /** @throws IllegalArgumentException if the action is empty or does not fit a frame. */
        public Act {
            int length = Bytes.ofText(action).length();
            check(length >= 1 && length < Frame.MAX_MESSAGE_LENGTH, "an action has 1…510 bytes of UTF-8", length);
        }

        @Override
        public Frame frame() {
            return command('A', Bytes.ofText(action));
        }

        @Override
        public String toString() {
            return "act " + action;
        }
    }

    /**
     * Asks for the names of the sketch's actions.
     *
     * @param offset how many bytes of them are there already, 0…65535.
     */
    record ListActions(int offset) implements Request {

        static final int MAX_OFFSET = 0xFFFF;

        /** @throws IllegalArgumentException if the offset is out of range. */
        public ListActions {
            check(offset >= 0 && offset <= MAX_OFFSET, "an offset among the names of actions is 0…65535", offset);
        }

        @Override
        public Frame frame() {
            return command('C', Bytes.ofNumber(offset, 2));
        }

        @Override
        public String toString() {
            return "list actions";
        }
    }

    /** @param id the device address that the board is to have. */
    record SetRfId(Address id) implements EepromWrite {

        /** @throws IllegalArgumentException if the address is no device's. */
        public SetRfId {
            check(id.kind() == Address.Kind.DEVICE, "an RF id begins with one of A-Z a-z 0-9", id);
        }

        @Override
        public Frame frame() {
            return command('I', id.toBytes());
        }

        @Override
        public String toString() {
            return "set RF id " + id;
        }
    }

    /** @param open whether received radio messages are wanted. */
    record Radio(boolean open) implements Request {
        @Override
        public Frame frame() {
            return command('R', Bytes.of(open ? 1 : 0));
        }

        @Override
        public String toString() {
            return open ? "open radio" : "block radio";
        }
    }

    private static void checkHolder(Address address) {
        check(address.kind() == Address.Kind.DEVICE || address.kind() == Address.Kind.MULTICAST,
                "a key is for a device such as ROMA or a group such as //SU", address);
    }

    /**
     * Raises the board's boot epoch, where it is lower.
     *
     * @param epoch 0…0xFFFFFE.
     */
    record RaiseEpoch(int epoch) implements EepromWrite {

        /** @throws IllegalArgumentException if the epoch is out of range. */
        public RaiseEpoch {
            check(epoch >= 0 && epoch <= BoardInfo.LAST_EPOCH, "an epoch is 0…16777214", epoch);
        }

        @Override
        public Frame frame() {
            return command('E', Bytes.ofNumber(epoch, 3));
        }

        @Override
        public String toString() {
            return "raise epoch to " + epoch;
        }
    }

    /**
     * Stores a key in the place of all that there is for the address.
     *
     * @param address the device or group that the key is shared with.
     * @param key     the shared key.
     */
    record SetKey(Address address, Key key) implements EepromWrite {

        /** @throws IllegalArgumentException if the address is neither a device's nor a group's. */
        public SetKey {
            checkHolder(address);
        }

        @Override
        public Frame frame() {
            return command('K', Bytes.join(address.toBytes(), key.bytes()));
        }

        @Override
        public String toString() {
            return "set key for " + address;
        }
    }

    /**
     * Stores a key as the next one: frames sealed with it are accepted, and the one so far still seals.
     *
     * @param address the device or group that the key is shared with.
     * @param key     the new shared key.
     */
    record RenewKey(Address address, Key key) implements EepromWrite {

        /** @throws IllegalArgumentException if the address is neither a device's nor a group's. */
        public RenewKey {
            checkHolder(address);
        }

        @Override
        public Frame frame() {
            return command('N', Bytes.join(address.toBytes(), key.bytes()));
        }

        @Override
        public String toString() {
            return "renew key for " + address;
        }
    }

    /** @param address the device or group whose next key is to seal, and whose key so far to be the previous one. */
    record UseKey(Address address) implements EepromWrite {
        @Override
        public Frame frame() {
            return command('U', address.toBytes());
        }

        @Override
        public String toString() {
            return "use key for " + address;
        }
    }

    /** @param address the device or group whose previous key is to be forgotten. */
    record FinishRenewal(Address address) implements EepromWrite {
        @Override
        public Frame frame() {
            return command('F', address.toBytes());
        }

        @Override
        public String toString() {
            return "finish renewal of the key for " + address;
        }
    }

    /** @param address the device or group whose keys, all of them, are to be forgotten. */
    record DeleteKey(Address address) implements EepromWrite {
        @Override
        public Frame frame() {
            return command('D', address.toBytes());
        }

        @Override
        public String toString() {
            return "delete key for " + address;
        }
    }

    /** Asks which keys are stored. */
    record ListKeys() implements Request {
        @Override
        public Frame frame() {
            return command('L', Bytes.EMPTY);
        }

        @Override
        public String toString() {
            return "list keys";
        }
    }

    /** Asks for the board's counters. */
    record Statistics() implements Request {
        @Override
        public Frame frame() {
            return command('S', Bytes.EMPTY);
        }

        @Override
        public String toString() {
            return "statistics";
        }
    }

    /**
     * Has a content transmitted.
     *
     * @param destination whom it is for; the board judges whether it can be reached.
     * @param origin      the board's RF id.
     * @param content     plain; the board seals it.
     */
    record Transmit(Address destination, Address origin, Content content) implements Request {

        /** @throws IllegalArgumentException if the destination is the serial line, which would be a command. */
        public Transmit {
            check(!destination.equals(Address.SERIAL), "a transmission goes to an RF address", destination);
        }

        @Override
        public Frame frame() {
            return new Frame(destination, origin, content.encode());
        }

        @Override
        public String toString() {
            return "transmit to " + destination + ": " + content;
        }
    }
}
