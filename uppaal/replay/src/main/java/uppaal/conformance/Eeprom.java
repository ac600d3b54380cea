package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import javino.protocol.Bytes;
import javino.protocol.Crc16;
import trace.TraceEvent;

/** A board's EEPROM, as far as the trace tells, and the epochs there (SPEC 5.1). */
final class Eeprom {
    /** How long the seal behind a record is. */
    static final int SEAL = 3;
    private static final int EPOCH = 3;
    private static final int BYTE = 0x100;

    private final Map<Integer, Integer> bytes = new HashMap<>();
    /** The addresses that were written since the last point. */
    private final Set<Integer> written = new HashSet<>();
    private long highest = -1;
    private long epoch;

    /** The epoch that the board has stored since its last reset; 0 for none. */
    long epoch() {
        return epoch;
    }

    void event(TraceEvent event) {
        if (event.is("eeprom")) {
            write(event.number("at"), event.number("length"), Bytes.copyOf(event.bytes("hex")));
        } else if (event.has("torn")) {
            bytes.remove(event.number("torn"));
        } else if (event.is("reset")) {
            written.clear();
            epoch = 0;
        }
    }

    /** @param told the first ones of so many */
    private void write(int begin, int length, Bytes told) {
        for (int i = 0; i < length; i++) {
            written.add(begin + i);
            if (i < told.length()) {
                bytes.put(begin + i, told.at(i));
            } else {
                bytes.remove(begin + i);
            }
        }
    }

    void point(Point point) throws RefusedException {
        if (point.is("EPOCH_STORED")) {
            storeEpoch(point);
        } else if (point.is("MEMORY")) {
            List<Long> copies = newEpochs();
            point.require(copies.size() == copies.stream().distinct().count(), "EPOCH_STORED, as there is a new one");
        }
        written.clear();
    }

    private void storeEpoch(Point point) throws RefusedException {
        long low = point.operand("low");
        List<Long> copies = newEpochs().stream().filter(copy -> copy % BYTE == low).toList();
        require(copies.size() > 1 && copies.get(0).equals(copies.get(1)),
                point.board() + " declares an epoch stored that ends in " + low,
                "two whole records of it" + (highest < 0 ? "" : String.format(", above %06x", highest)));
        highest = copies.get(0);
        epoch = highest;
    }

    private List<Long> newEpochs() {
        return begins(EPOCH + SEAL).mapToObj(at -> record(at, EPOCH)).flatMap(Optional::stream)
                .map(record -> record.number(0, EPOCH)).filter(copy -> copy > highest).toList();
    }

    /** The addresses at which a record so long may begin of which a byte was written since the last point. */
    IntStream begins(int length) {
        return written.stream().flatMapToInt(at -> IntStream.rangeClosed(at - length + 1, at)).distinct();
    }

    /** The record at a place, if all of it is there. */
    Optional<Bytes> record(int begin, int length) {
        if (!IntStream.range(begin, begin + length + SEAL).allMatch(bytes::containsKey)) {
            return Optional.empty();
        }
        Bytes data = Bytes.of(IntStream.range(begin, begin + length).map(bytes::get).toArray());
        int crc = Crc16.of(data);
        int[] seal = {crc >> 8, crc % BYTE, crc >> 8 ^ crc % BYTE};
        boolean isSealed = IntStream.range(0, SEAL)
                .allMatch(i -> bytes.get(begin + length + i) == (seal[i] == BYTE - 1 ? 0 : seal[i]));
        return isSealed ? Optional.of(data) : Optional.empty();
    }
}
