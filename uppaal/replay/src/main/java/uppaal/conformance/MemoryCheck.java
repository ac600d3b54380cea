package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Address;
import javino.protocol.Bytes;
import trace.TraceEvent;

/** Epochs, keys and floors that a board declares stored are in its EEPROM at that moment (SPEC 5.1). */
final class MemoryCheck implements Check {
    private static final int NO_KEY = 255;
    private static final int NUMBERS = 256;
    private static final int COUNTERS = 0x10000;
    /** Of a floor: place of the key, origin, nonce. */
    private static final int ORIGIN_AT = 1;
    private static final int NONCE_AT = 4;
    private static final int FLOOR = 10;
    private static final int FLOOR_PLACE = 2 * (FLOOR + Eeprom.SEAL);
    /** How far a floor is above the nonce that it is stored for. */
    private static final int ABOVE = 31;
    /** A key's record and what is told of it: address, generation, whether it is alone, check value. */
    private static final int KEY_RECORD = 43;
    private static final int CHECK_AT = 5;
    private static final int KEY_TOLD = 8;

    /** A floor that is there twice. */
    private record Floor(int at, int key, String origin, Bytes nonce) {
        Floor(int at, Bytes record) {
            this(at, record.at(0), address(record.slice(ORIGIN_AT, NONCE_AT)), record.from(NONCE_AT));
        }

        boolean isOfSame(Floor other) {
            return key == other.key && origin.equals(other.origin);
        }

        long number() {
            return nonce.number(0, nonce.length());
        }

        /** Whether it was stored for a message with this id, or one shortly before. */
        boolean covers(Bytes id) {
            long last = nonce.number(nonce.length() - 2, nonce.length());
            return nonce.at(2) == id.at(0) && Math.floorMod(last - id.number(1, id.length()), COUNTERS) <= ABOVE;
        }
    }

    /** A message that the inbox has taken in, and the floors of its key. */
    private record Queued(int nonce, List<Floor> floors) {}

    /** What a board has stored. */
    private static final class Memory {
        final Eeprom eeprom = new Eeprom();
        /** By where they begin. */
        final Map<Integer, Floor> floors = new HashMap<>();
        /** Those that were there when memory was lost, so that they cover nothing more. */
        Set<Floor> past = Set.of();
        boolean isLost;
        /** Where the ring of floors begins; negative while that is not known. */
        int ring = -1;
        /** The beginning of the last key's record that was written, and of that which was stored; empty for none. */
        Bytes writtenKey = Bytes.EMPTY;
        Bytes storedKey = Bytes.EMPTY;
        double keyStoredAt = -1;
        final Set<Integer> sessions = new HashSet<>();
        /** By number, since the last reset, but for those without a floor. */
        final Map<Integer, Queued> queued = new HashMap<>();
        int count;
        /** Whether the trace tells all that was ever written: not what a reset breaks off. */
        boolean isWhole;
        /** What its radio has taken last; null before that. */
        Point declared;

        /** The floors of which something was written since the last point: higher ones take the place of others. */
        List<Floor> update() {
            List<Floor> updated = eeprom.begins(FLOOR_PLACE).boxed().flatMap(at -> eeprom.record(at, FLOOR)
                    .filter(record -> eeprom.record(at + FLOOR + Eeprom.SEAL, FLOOR).equals(Optional.of(record)))
                    .map(record -> new Floor(at, record)).stream()).toList();
            for (Floor floor : updated) {
                List<Floor> same = floors.values().stream().filter(floor::isOfSame).toList();
                if (same.stream().allMatch(other -> other.number() < floor.number())) {
                    floors.values().removeAll(same);
                    floors.put(floor.at, floor);
                }
            }
            return updated;
        }

        void forget(int key) {
            floors.values().removeIf(floor -> floor.key == key);
        }

        void reset(boolean isOfPower) {
            update();
            isWhole &= isOfPower;
            count = 0;
            queued.clear();
            sessions.clear();
            writtenKey = Bytes.EMPTY;
            keyStoredAt = -1;
        }
    }

    private final Map<String, Memory> memories = new HashMap<>();

    MemoryCheck(Header header) {}

    private Memory memory(String board) {
        return memories.computeIfAbsent(board, added -> new Memory());
    }

    private static String address(Bytes bytes) {
        return new Address((int) bytes.number(0, bytes.length())).toString();
    }

    @Override
    public void point(Point point) throws RefusedException {
        Memory memory = memory(point.board());
        List<Floor> updated = memory.update();
        memory.eeprom.point(point);
        switch (point.name()) {
            case "EPOCH_STORED" -> memory.isWhole |= memory.eeprom.epoch() == 1;
            case "FLOOR_STORED" -> storeFloor(memory, point, updated);
            case "KEY_STORED" -> storeKey(memory, point);
            case "KEY_DELETED" -> memory.forget(point.operand("key"));
            case "MEMORY" -> memory.isLost = point.operand("kept") == 0;
            case "QUEUED" -> queue(memory, point);
            case "QUIET", "BUSY" -> {
                memory.past = memory.isLost ? Set.copyOf(memory.floors.values()) : memory.past;
                memory.isLost = false;
            }
            default -> memory.declared = AirCheck.SENDS.contains(point.name()) ? point : memory.declared;
        }
    }

    private static void storeFloor(Memory memory, Point point, List<Floor> updated) throws RefusedException {
        int key = point.operand("key");
        int place = point.operand("place");
        Optional<Floor> stored = updated.stream().filter(floor -> floor.key == key).findFirst();
        require(stored.isPresent(), point.board() + " declares a floor of key " + key + " stored",
                "two whole records of it, one behind the other");
        Floor floor = stored.get();
        int begin = floor.at - place * FLOOR_PLACE;
        memory.ring = memory.ring < 0 ? begin : memory.ring;
        require(begin == memory.ring, point.board() + " stores a floor at " + floor.at,
                "place " + place + " of its ring, which begins at " + memory.ring);
        require(floor.equals(memory.floors.get(floor.at)),
                point.board() + " stores the floor " + floor.nonce + " of " + floor.origin, "a higher one than before");
    }

    private static void storeKey(Memory memory, Point point) {
        int key = point.operand("key");
        memory.storedKey = memory.writtenKey;
        memory.writtenKey = Bytes.EMPTY;
        memory.keyStoredAt = point.seconds();
        memory.forget(key);
        memory.sessions.remove(key);
        if (memory.storedKey.length() == 0) {
            memory.sessions.add(key);
        }
    }

    private static void queue(Memory memory, Point point) {
        int key = point.operand("key");
        int number = memory.count++ % NUMBERS;
        memory.queued.remove(number);
        if (key != NO_KEY && !memory.sessions.contains(key)) {
            memory.queued.put(number, new Queued(point.operand("nonce"), memory.floors.values().stream()
                    .filter(floor -> floor.key == key && !memory.past.contains(floor)).toList()));
        }
    }

    @Override
    public void begins(Transmission packet) throws RefusedException {
        Memory memory = memory(packet.board());
        Optional<Acknowledgement> answer = Acknowledgement.of(packet.payload());
        if (!memory.isWhole || memory.declared == null || !memory.declared.is("ANSWER") || answer.isEmpty()
                || !answer.get().is(Acknowledgement.STALE)) {
            return;
        }
        long told = answer.get().floor();
        require(memory.floors.values().stream().anyMatch(floor -> floor.number() == told
                && floor.key == memory.declared.operand("key")),
                String.format("%s tells the floor %012x", packet.board(), told),
                "one that it has stored for this key");
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        Memory memory = memory(event.board());
        switch (event.name()) {
            case "eeprom" -> {
                Bytes told = Bytes.copyOf(event.bytes("hex"));
                boolean isKey = event.number("length") >= KEY_RECORD && told.length() >= KEY_TOLD;
                memory.writtenKey = isKey ? told : memory.writtenKey;
            }
            case "fault" -> memory.isWhole &= !event.has("torn");
            case "reset" -> memory.reset(event.text("why").equals("power"));
            case "host-key" -> keep(memory, event);
            case "host-handed" -> hand(memory, event);
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
        require(key.length() != 0 && address(key.slice(0, Address.LENGTH - 1)).equals(event.text("address"))
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
        boolean isCovered = queued.floors.stream()
                .anyMatch(floor -> floor.origin.equals(event.text("origin")) && floor.covers(id));
        require(isCovered && id.at(2) == queued.nonce, event.board() + " hands its host message "
                + event.number("number") + " of " + event.text("origin") + " with the id " + id.hex(),
                "that a floor of at most " + ABOVE + " above it was stored before, and after memory was lost");
    }
}
