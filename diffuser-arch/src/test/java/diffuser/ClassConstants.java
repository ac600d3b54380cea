package diffuser;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;

/** The constants of a compiled class (Java Virtual Machine Specification 4.4), of whatever version of Java. */
final class ClassConstants {

    private static final String PREDICATE = "jason/asSyntax/PredicateIndicator.<init>(Ljava/lang/String;I)V";
    private static final int LDC = 0x12;
    private static final int BIPUSH = 0x10;
    private static final int INVOKESPECIAL = 0xB7;

    private final byte[] bytes;
    private final Map<Integer, String> texts = new TreeMap<>();
    /** The indices that each other constant has, as one number where it has one only. */
    private final Map<Integer, int[]> strings = new TreeMap<>();
    private final Map<Integer, int[]> pairs = new TreeMap<>();

    ClassConstants(byte[] bytes) throws IOException {
        this.bytes = bytes;
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        in.skipBytes(8);
        int count = in.readUnsignedShort();
        for (int i = 1; i < count; i++) {
            int tag = in.readUnsignedByte();
            switch (tag) {
                case 1 -> texts.put(i, in.readUTF());
                case 7, 8, 16, 19, 20 -> strings.put(i, new int[] {in.readUnsignedShort(), tag});
                case 9, 10, 11, 12, 17, 18 -> pairs.put(i, new int[] {in.readUnsignedShort(), in.readUnsignedShort()});
                case 15 -> in.skipBytes(3);
                case 3, 4 -> in.skipBytes(4);
                case 5, 6 -> {
                    in.skipBytes(8);
                    i++;
                }
                default -> throw new IOException("no constant has the tag " + tag);
            }
        }
    }

    /** All texts of the program. */
    List<String> strings() {
        return strings.values().stream().filter(each -> each[1] == 8).map(each -> texts.get(each[0])).toList();
    }

    /** The names of predicates that the code makes of a constant name and arity. */
    Set<String> predicates() {
        Set<String> names = new TreeSet<>();
        IntStream.range(0, bytes.length - 8).mapToObj(this::predicateAt).filter(Objects::nonNull).forEach(names::add);
        return names;
    }

    /** The name, then the arity by one byte or two, then the constructor. */
    private String predicateAt(int at) {
        boolean wide = at(at) == LDC + 1;
        int name = wide ? at(at + 1) << 8 | at(at + 2) : at(at + 1);
        int arity = at + (wide ? 3 : 2);
        int call = arity + (at(arity) == BIPUSH ? 2 : 1);
        boolean is = (wide || at(at) == LDC) && strings.containsKey(name) && at(call) == INVOKESPECIAL
                && PREDICATE.equals(method(at(call + 1) << 8 | at(call + 2)));
        return is ? texts.get(strings.get(name)[0]) : null;
    }

    private int at(int index) {
        return bytes[index] & 0xFF;
    }

    private String method(int index) {
        int[] method = pairs.get(index);
        if (method == null || !strings.containsKey(method[0]) || !pairs.containsKey(method[1])) {
            return null;
        }
        int[] signature = pairs.get(method[1]);
        return texts.get(strings.get(method[0])[0]) + "." + texts.get(signature[0]) + texts.get(signature[1]);
    }
}
