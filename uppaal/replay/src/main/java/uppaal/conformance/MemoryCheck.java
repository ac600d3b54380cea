package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import trace.TraceEvent;

/** Epochs, keys and floors that a board declares stored are in its EEPROM at that moment (SPEC 5.1). */
final class MemoryCheck implements Check {
    private static final int NO_KEY = 255;
    private static final Bytes ALL = address("////");
    private static final int NUMBERS = 256;
    private static final int COUNTERS = 0x10000;
    /** A floor: place of the key and origin, then a nonce. */
    private static final int NONCE_AT = 4;
    private static final int FLOOR = 10;
    private static final int FLOOR_COPY = FLOOR + Eeprom.SEAL;
    /** How far a floor is above the nonce that it is stored for. */
    private static final int ABOVE = 31;
    /** A key's record and what is told of it: address, generation, whether it is alone, check value. */
    private static final int KEY_RECORD = 43;
    private static final int CHECK_AT = 5;
    private static final int KEY_TOLD = 8;
    /** From one key's record to the next. */
    private static final int KEY_PLACE = 44;

    /** A message that the inbox has taken in, and the floors that may cover it. */
    private record Queued(int nonce, int key, Map<Bytes, Bytes> floors) {}

    /** The records that a board has stored. */
    private static final class Memory {
        final Eeprom eeprom = new Eeprom();
        /** The highest nonce by key's place and origin; and the same since memory was lost, which alone may cover. */
        final Map<Bytes, Bytes> floors = new HashMap<>();
        final Map<Bytes, Bytes> covering = new HashMap<>();
        /** Whether memory was lost when it has booted. */
        boolean isLost;
        /** Whether it has told that since its last reset, and whether its power was cut then. */
        boolean isTold;
        boolean wasOff;
        /** The address at which the ring of floors begins; negative while that is not known. */
        int ring = -1;
        /** The beginning of the last key's record that was written, and of that which was stored; empty for none. */
        Bytes writtenKey = Bytes.EMPTY;
        Bytes storedKey = Bytes.EMPTY;
        double keyStoredAt = -1;
        /** The address of that record, and that of the first key's place; negative while that is not known. */
        int keyAt = -1;
        int keysAt = -1;
        /** By place, the address of each key that was stored since the trace began. */
        final Map<Integer, Bytes> keys = new HashMap<>();
        final Map<Integer, Bytes> destinations = new HashMap<>();
        final Set<Integer> sessions = new HashSet<>();
        /** By number, since the last reset, but for those without a floor. */
        final Map<Integer, Queued> queued = new HashMap<>();
        int count;
        /** Whether the trace tells all that was ever written: not what a reset breaks off. */
        boolean isWhole;

        /** By place, the floors that are there twice, and of which something was written since the last point. */
        Map<Integer, Bytes> writtenFloors() {
            Map<Integer, Bytes> written = new TreeMap<>();
            eeprom.begins(2 * FLOOR_COPY).forEach(at -> eeprom.record(at, FLOOR)
                    .filter(record -> eeprom.record(at + FLOOR_COPY, FLOOR).equals(Optional.of(record)))
                    .ifPresent(record -> written.put(at, record)));
            return written;
        }

        void put(Bytes record, boolean covers) {
            for (Map<Bytes, Bytes> into : covers ? List.of(floors, covering) : List.of(floors)) {
                into.merge(record.slice(0, NONCE_AT), record.from(NONCE_AT),
                        (one, other) -> number(one) > number(other) ? one : other);
            }
        }

        void forget(int key) {
            floors.keySet().removeIf(pair -> pair.at(0) == key);
            covering.keySet().removeIf(pair -> pair.at(0) == key);
            keys.remove(key);
        }

        void reset(boolean isOfPower) {
            isWhole &= isOfPower;
            isTold = false;
            wasOff = isOfPower;
            count = 0;
            queued.clear();
            sessions.clear();
            destinations.clear();
            writtenKey = Bytes.EMPTY;
            keyStoredAt = -1;
        }
    }

    private final Map<String, Memory> memories = new HashMap<>();

    MemoryCheck(Header header) {}

    private Memory memory(String board) {
        return memories.computeIfAbsent(board, added -> new Memory());
    }

    private static Bytes address(String text) {
        return Bytes.ofNumber(Address.parse(text).value(), NONCE_AT - 1);
    }

    private static long number(Bytes nonce) {
        return nonce.number(0, nonce.length());
    }

    @Override
    public void point(Point point) throws RefusedException {
        Memory memory = memory(point.board());
        Map<Integer, Bytes> written = memory.writtenFloors();
        point.require(memory.isTold || memory.eeprom.epoch() == 0 || point.is("MEMORY") || !point.event().has("run"),
                "MEMORY first, as it has stored an epoch");
        memory.eeprom.point(point);
        switch (point.name()) {
            case "EPOCH_STORED" -> memory.isWhole |= memory.eeprom.epoch() == 1;
            case "MEMORY" -> {
                point.require(!memory.isTold && point.operand("kept") <= (memory.wasOff ? 0 : 1),
                        "it once, and none kept where its power was cut");
                memory.isTold = true;
                memory.isLost = point.operand("kept") == 0;
                memory.covering.keySet().removeIf(pair -> memory.isLost);
            }
            case "FLOOR_STORED" -> storeFloor(memory, point, written);
            case "KEY_STORED" -> storeKey(memory, point);
            case "KEY_DELETED" -> memory.forget(point.operand("key"));
            case "TAKE_UP" -> takeUp(memory, point);
            case "QUEUED" -> queue(memory, point);
            default -> {}
        }
        written.values().forEach(record -> memory.put(record, point.is("FLOOR_STORED") || !memory.isLost));
    }

    private static void storeFloor(Memory memory, Point point, Map<Integer, Bytes> written) throws RefusedException {
        int key = point.operand("key");
        int place = point.operand("place");
        int at = written.keySet().stream().filter(each -> written.get(each).at(0) == key).findFirst()
                .orElseThrow(() -> new RefusedException(point.board() + " declares a floor of key " + key + " stored",
                        "two whole records of it, one behind the other"));
        int begin = at - place * 2 * FLOOR_COPY;
        memory.ring = memory.ring < 0 ? begin : memory.ring;
        require(begin == memory.ring, point.board() + " stores a floor at " + at,
                "place " + place + " of its ring, which begins at " + memory.ring);
        Bytes nonce = written.get(at).from(NONCE_AT);
        Bytes before = memory.floors.get(written.get(at).slice(0, NONCE_AT));
        require(before == null || number(before) < number(nonce) - ABOVE, point.board() + " stores the floor " + nonce,
                "one for a nonce above " + before);
    }

    /** A message is sealed with a key of its destination, if that is known, or is for all. */
    private static void takeUp(Memory memory, Point point) throws RefusedException {
        int key = point.operand("key");
        Bytes to = memory.destinations.get(point.number());
        if (to == null) {
            return;
        }
        point.require(to.equals(ALL) == (key == NO_KEY), "no key, if it is for all");
        boolean mayBeOfIt = memory.sessions.contains(key) || !memory.keys.containsValue(to);
        point.require(memory.keys.containsKey(key) ? memory.keys.get(key).equals(to) : mayBeOfIt,
                "the place of a key of " + to);
    }

    private static void storeKey(Memory memory, Point point) throws RefusedException {
        int key = point.operand("key");
        memory.forget(key);
        if (memory.writtenKey.length() == 0) {
            memory.sessions.add(key);
        } else {
            memory.sessions.remove(key);
            int begin = memory.keyAt - key * KEY_PLACE;
            memory.keysAt = memory.keysAt < 0 ? begin : memory.keysAt;
            point.require(begin == memory.keysAt, "place " + (memory.keyAt - memory.keysAt) / KEY_PLACE);
            memory.keys.put(key, memory.writtenKey.slice(0, NONCE_AT - 1));
        }
        memory.storedKey = memory.writtenKey;
        memory.writtenKey = Bytes.EMPTY;
        memory.keyStoredAt = point.seconds();
    }

    private static void queue(Memory memory, Point point) {
        int key = point.operand("key");
        int number = memory.count++ % NUMBERS;
        memory.queued.remove(number);
        if (key != NO_KEY && !memory.sessions.contains(key)) {
            memory.queued.put(number, new Queued(point.operand("nonce"), key, Map.copyOf(memory.covering)));
        }
    }

    @Override
    public void begins(Transmission packet) throws RefusedException {
        Memory memory = memory(packet.board());
        Optional<Acknowledgement> answer = Acknowledgement.of(packet.payload());
        if (!memory.isWhole || !packet.isDeclared("ANSWER") || answer.isEmpty()
                || !answer.get().is(Acknowledgement.STALE)) {
            return;
        }
        Bytes told = packet.payload().message().slice(0, Payload.NONCE_LENGTH);
        require(memory.floors.entrySet().stream().anyMatch(floor -> floor.getValue().equals(told)
                && floor.getKey().at(0) == packet.declared().operand("key")),
                packet.board() + " tells the floor " + told, "one that it has stored for this key");
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        Memory memory = memory(event.board());
        switch (event.name()) {
            case "eeprom" -> {
                Bytes told = Bytes.copyOf(event.bytes("hex"));
                boolean isKey = event.number("length") >= KEY_RECORD && told.length() >= KEY_TOLD;
                memory.writtenKey = isKey ? told : memory.writtenKey;
                memory.keyAt = isKey ? event.number("at") : memory.keyAt;
            }
            case "fault" -> memory.isWhole &= !event.has("torn");
            case "reset" -> memory.reset(event.text("why").equals("power"));
            case "host-key" -> keep(memory, event);
            case "host-handed" -> hand(memory, event);
            case "host-transmit" ->
                memory.destinations.put(event.number("number"), address(event.text("destination")));
            case "host-relay" -> memory.destinations.put(event.number("number"), ALL);
            default -> {}
        }
        memory.eeprom.event(event);
    }

    /** A host is told that its board has a key. */
    private static void keep(Memory memory, TraceEvent event) throws RefusedException {
        boolean isStored = event.text("step").equals("set") || event.text("step").equals("renew");
        if (!isStored || memory.keyStoredAt < event.real("asked")) {
            return; // or it had that before
        }
        Bytes key = memory.storedKey;
        require(key.length() != 0 && key.slice(0, NONCE_AT - 1).equals(address(event.text("address")))
                && key.slice(CHECK_AT, KEY_TOLD).hex().equals(event.text("check")),
                event.board() + " declares the key of " + event.text("address") + " stored",
                "a record of that address and check value " + event.text("check"));
    }

    /** A board hands its host a message: a floor must have covered it when it was taken in. */
    private static void hand(Memory memory, TraceEvent event) throws RefusedException {
        Queued queued = memory.queued.get(event.number("number"));
        if (queued == null) {
            return;
        }
        Bytes id = Bytes.ofHex(event.text("id"));
        Bytes floor = queued.floors.get(Bytes.join(Bytes.of(queued.key), address(event.text("origin"))));
        boolean isCovered = floor != null && floor.at(2) == id.at(0)
                && Math.floorMod(number(floor.from(4)) - number(id.from(1)), COUNTERS) <= ABOVE;
        require(isCovered && id.at(2) == queued.nonce, event.board() + " hands its host message "
                + event.number("number") + " of " + event.text("origin") + " with the id " + id.hex(),
                "that a floor of at most " + ABOVE + " above it was stored before, and after memory was lost");
    }
}
