package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Crc16;
import trace.TraceEvent;

/** Epochs, keys and floors that a board declares stored are in its EEPROM at that moment (SPEC 5.1). */
final class MemoryCheck implements Check {
    private static final int NO_KEY = 255;
    private static final int BYTE = 0x100;
    private static final int COUNTERS = 0x10000;
    private static final int SEAL = 3;
    private static final int EPOCH = 3;
    /** Of a floor: place of the key, origin, nonce. */
    private static final int ORIGIN_AT = 1;
    private static final int NONCE_AT = 4;
    private static final int FLOOR = 10;
    /** How far a floor is above the nonce that it is stored for. */
    private static final int ABOVE = 31;
    /** A key's record and what is told of it: address, generation, whether it is alone, check value. */
    private static final int KEY_RECORD = 43;
    private static final int CHECK_AT = 5;
    private static final int KEY_TOLD = 8;

    /**
     * A floor.
     *
     * @param boot in which it was stored
     */
    private record Floor(int at, int key, String origin, long nonce, int boot) {
        static Floor of(int at, Bytes record, int boot) {
            return new Floor(at, record.at(0), new Address((int) record.number(ORIGIN_AT, NONCE_AT)).toString(),
                    record.number(NONCE_AT, FLOOR), boot);
        }
    }

    /** A message that the inbox has taken in, and the floors of its key. */
    private record Queued(int nonce, int key, List<Floor> floors, boolean isSession) {}

    /** A board's EEPROM, as far as the trace tells. */
    private static final class Memory {
        final Map<Integer, Integer> bytes = new HashMap<>();
        /** Where bytes were written since the last point. */
        final Set<Integer> written = new HashSet<>();
        /** The beginnings of records of keys that were written since then. */
        final Deque<Bytes> keys = new ArrayDeque<>();
        final Map<Integer, Floor> floors = new HashMap<>();
        final Set<Integer> sessions = new HashSet<>();
        /** By number, since the last reset. */
        final Map<Integer, Queued> queued = new HashMap<>();
        Bytes storedKey = Bytes.EMPTY;
        double keyStoredAt = -1;
        int count;
        int boot;
        /** The first boot whose floors count. */
        int since;
        long epoch = -1;
        /** Whether the trace tells all that was ever written: not what a reset breaks off. */
        boolean isWhole;
        Point answer;
        /** Whether it looks through its EEPROM after a reset, where it mends what that has broken off. */
        boolean isBooting = true;
        /** Where the ring of floors begins; negative while that is not known. */
        int ring = -1;

        Optional<Bytes> record(int at, int length) {
            if (!IntStream.range(at, at + length + SEAL).allMatch(bytes::containsKey)) {
                return Optional.empty();
            }
            Bytes data = Bytes.of(IntStream.range(at, at + length).map(bytes::get).toArray());
            int crc = Crc16.of(data);
            int[] seal = {crc >> 8, crc % BYTE, crc >> 8 ^ crc % BYTE};
            boolean isSealed = IntStream.range(0, SEAL)
                    .allMatch(i -> bytes.get(at + length + i) == (seal[i] == BYTE - 1 ? 0 : seal[i]));
            return isSealed ? Optional.of(data) : Optional.empty();
        }

        void put(Floor floor) {
            floors.values().removeIf(other -> other.key == floor.key && other.origin.equals(floor.origin));
            floors.put(floor.at, floor);
        }

        /** Where what was written since the last point may begin a record. */
        int[] begins(int length) {
            return written.stream().flatMap(at -> IntStream.rangeClosed(at - length - SEAL, at).boxed()).distinct()
                    .mapToInt(at -> at).toArray();
        }
    }

    private final Map<String, Memory> memories = new HashMap<>();

    MemoryCheck(Header header) {}

    private Memory memory(String board) {
        return memories.computeIfAbsent(board, added -> new Memory());
    }

    @Override
    public void point(Point point) throws RefusedException {
        Memory memory = memory(point.board());
        switch (point.name()) {
            case "EPOCH_STORED" -> storeEpoch(memory, point);
            case "FLOOR_STORED" -> storeFloor(memory, point);
            case "KEY_STORED" -> storeKey(memory, point);
            case "KEY_DELETED" -> memory.floors.values().removeIf(floor -> floor.key == point.operand("key"));
            case "MEMORY" -> memory.since = point.operand("kept") == 1 ? memory.since : memory.boot;
            case "QUEUED" -> {
                int key = point.operand("key");
                memory.queued.put(memory.count++ % BYTE, new Queued(point.operand("nonce"), key,
                        memory.floors.values().stream().filter(floor -> floor.key == key
                                && floor.boot >= memory.since).toList(),
                        memory.sessions.contains(key)));
            }
            default -> memory.answer = AirCheck.SENDS.contains(point.name()) ? point : memory.answer;
        }
        if (memory.isBooting) {
            Arrays.stream(memory.begins(FLOOR)).boxed().flatMap(at -> memory.record(at, FLOOR).stream()
                    .map(record -> Floor.of(at, record, memory.boot - 1))).forEach(memory::put);
        }
        memory.isBooting &= !point.is("QUIET") && !point.is("BUSY");
        memory.written.clear();
    }

    private static void storeEpoch(Memory memory, Point point) throws RefusedException {
        Map<Long, Integer> copies = new HashMap<>();
        Arrays.stream(memory.begins(EPOCH)).mapToObj(at -> memory.record(at, EPOCH)).flatMap(Optional::stream)
                .forEach(record -> copies.merge(record.number(0, EPOCH), 1, Integer::sum));
        long low = point.operand("low");
        Optional<Long> stored = copies.keySet().stream()
                .filter(epoch -> epoch % BYTE == low && copies.get(epoch) > 1 && epoch > memory.epoch).findFirst();
        require(stored.isPresent(), point.board() + " declares an epoch stored that ends in " + low,
                "two whole records of it" + (memory.epoch < 0 ? "" : String.format(", above %06x", memory.epoch)));
        memory.isWhole |= memory.epoch < 0 && stored.get() == 1;
        memory.epoch = stored.get();
    }

    private static void storeFloor(Memory memory, Point point) throws RefusedException {
        int key = point.operand("key");
        Optional<Floor> stored = Arrays.stream(memory.begins(FLOOR)).boxed().flatMap(at -> memory.record(at, FLOOR)
                .filter(record -> record.at(0) == key && memory.record(at + FLOOR + SEAL, FLOOR).equals(
                        Optional.of(record)))
                .map(record -> Floor.of(at, record, memory.boot))
                .stream())
                .findFirst();
        require(stored.isPresent(), point.board() + " declares a floor of key " + key + " stored",
                "two whole records of it, one behind the other");
        Floor floor = stored.get();
        boolean isHigher = memory.floors.values().stream().noneMatch(
                other -> other.key == key && other.origin.equals(floor.origin) && other.nonce >= floor.nonce);
        int begin = floor.at - point.operand("place") * 2 * (FLOOR + SEAL);
        memory.ring = memory.ring < 0 ? begin : memory.ring;
        require(begin == memory.ring, point.board() + " stores a floor at " + floor.at,
                "place " + point.operand("place") + " of its ring, which begins at " + memory.ring);
        require(isHigher, String.format("%s stores the floor %012x of %s", point.board(), floor.nonce, floor.origin),
                "a higher one than before");
        memory.put(floor);
    }

    private static void storeKey(Memory memory, Point point) {
        int key = point.operand("key");
        memory.storedKey = memory.keys.isEmpty() ? Bytes.EMPTY : memory.keys.getLast();
        memory.keyStoredAt = point.seconds();
        memory.keys.clear();
        memory.floors.values().removeIf(floor -> floor.key == key);
        if (memory.storedKey.length() == 0) {
            memory.sessions.add(key);
        } else {
            memory.sessions.remove(key);
        }
    }

    @Override
    public void begins(Transmission packet) throws RefusedException {
        Memory memory = memory(packet.board());
        Point declared = memory.answer;
        memory.answer = null;
        Optional<Acknowledgement> answer = Acknowledgement.of(packet.payload());
        if (declared == null || !declared.is("ANSWER") || !memory.isWhole || answer.isEmpty()
                || !answer.get().tellsFloor()) {
            return;
        }
        long told = answer.get().floor();
        require(memory.floors.values().stream().anyMatch(floor -> floor.key == declared.operand("key")
                && floor.nonce == told), String.format("%s tells the floor %012x", packet.board(), told),
                "one that it has stored for this key");
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        Memory memory = memory(event.board());
        switch (event.name()) {
            case "eeprom" -> write(memory, event);
            case "fault" -> {
                if (event.has("torn")) {
                    memory.bytes.remove(event.number("torn"));
                    memory.isWhole = false;
                }
            }
            case "reset" -> {
                memory.boot++;
                memory.isBooting = true;
                memory.isWhole &= event.text("why").equals("power");
                memory.count = 0;
                memory.queued.clear();
                memory.written.clear();
                memory.keys.clear();
                memory.answer = null;
                memory.keyStoredAt = -1;
                memory.sessions.clear();
            }
            case "host-key" -> keep(memory, event);
            case "host-handed" -> hand(memory, event);
            default -> {}
        }
    }

    private static void write(Memory memory, TraceEvent event) {
        Bytes told = Bytes.copyOf(event.bytes("hex"));
        int at = event.number("at");
        int length = event.number("length");
        for (int i = 0; i < length; i++) {
            memory.written.add(at + i);
            if (i < told.length()) {
                memory.bytes.put(at + i, told.at(i));
            } else {
                memory.bytes.remove(at + i);
            }
        }
        if (length >= KEY_RECORD && told.length() >= KEY_TOLD) {
            memory.keys.add(told);
        }
    }

    /** A host is told that its board has a key. */
    private static void keep(Memory memory, TraceEvent event) throws RefusedException {
        boolean isStored = event.text("step").equals("set") || event.text("step").equals("renew");
        if (!isStored || memory.keyStoredAt < event.real("asked")) {
            return; // or it had that before
        }
        Bytes key = memory.storedKey;
        require(key.length() != 0 && new Address((int) key.number(0, SEAL)).toString().equals(event.text("address"))
                && key.slice(CHECK_AT, KEY_TOLD).hex().equals(event.text("check")),
                event.board() + " declares the key of " + event.text("address") + " stored",
                "a record of that address and check value " + event.text("check"));
    }

    /** A board hands a message to its host: a floor must have covered it when it was taken in. */
    private static void hand(Memory memory, TraceEvent event) throws RefusedException {
        Queued queued = memory.queued.get(event.number("number"));
        if (queued == null || queued.key == NO_KEY || queued.isSession) {
            return;
        }
        Bytes id = Bytes.ofHex(event.text("id"));
        boolean isCovered = queued.floors.stream().anyMatch(floor -> floor.origin.equals(event.text("origin"))
                && (floor.nonce >> Frame.COUNTER_BITS) % BYTE == id.at(0)
                && Math.floorMod(floor.nonce - id.number(1, SEAL), COUNTERS) <= ABOVE);
        require(isCovered && id.at(2) == queued.nonce, event.board() + " hands its host message " + event.number(
                "number") + " of " + event.text("origin") + " with the id " + id.hex(),
                "that a floor of at most " + ABOVE + " above it was stored before, and after memory was lost");
    }
}
