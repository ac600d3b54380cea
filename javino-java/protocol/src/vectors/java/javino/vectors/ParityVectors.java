package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.bytes;
import static javino.vectors.Wire.counting;
import static javino.vectors.Wire.frame;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.repeated;
import static javino.vectors.Wire.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** SPEC 6.1: the parity of packets, by long division of polynomials without a table, and damaged codewords. */
final class ParityVectors {

    static final int LENGTH = 16;
    private static final int POLYNOMIAL = 0x11D;

    private ParityVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        byte[] packet = RadioVectors.packet(frame("////", "ROMA", text("tell;help")));
        List<byte[]> plain = List.of(bytes(1), bytes(0), repeated(0, 80), repeated(0xFF, 80), counting(0, 80), packet,
                RadioVectors.packet(bytes(0)), RadioVectors.packet(counting(0xB0, 77)), counting(1, 239));
        var lists = Vectors.lists("parities", plain.stream().map(ParityVectors::valid).toList());
        List<Map<String, Object>> damaged = new ArrayList<>();
        Random random = new Random(6);
        for (byte[] bytes : List.of(RadioVectors.packet(bytes(0)), packet, RadioVectors.packet(counting(0xB0, 77)))) {
            for (int erasures = 0; erasures <= LENGTH; erasures++) {
                damaged.add(damaged(join(bytes, of(bytes)), erasures, (LENGTH - erasures) / 2, random));
            }
        }
        lists.put("damaged", damaged);
        return lists;
    }

    private static Map<String, Object> valid(byte[] bytes) {
        return vector("bytes", Wire.hex(bytes), "parity", Wire.hex(of(bytes)));
    }

    /** As many wrong bytes at other places as can be corrected beside so many erasures, of which some may be right. */
    private static Map<String, Object> damaged(byte[] codeword, int erasures, int errors, Random random) {
        byte[] damaged = codeword.clone();
        int[] places = random.ints(0, codeword.length).distinct().limit(erasures + errors).toArray();
        for (int i = 0; i < places.length; i++) {
            damaged[places[i]] ^= (byte) (i < erasures ? random.nextInt(256) : 1 + random.nextInt(255));
        }
        return vector("received", Wire.hex(damaged), "erasures", Arrays.copyOf(places, erasures), "codeword",
                Wire.hex(codeword));
    }

    /** The rest of the bytes times x^16, divided by the generator: the highest coefficient first. */
    static byte[] of(byte[] bytes) {
        int[] generator = generator();
        byte[] rest = Arrays.copyOf(bytes, bytes.length + LENGTH);
        for (int i = 0; i < bytes.length; i++) {
            int factor = rest[i] & 0xFF;
            for (int k = 0; k <= LENGTH; k++) {
                rest[i + k] ^= (byte) product(factor, generator[k]);
            }
        }
        return Arrays.copyOfRange(rest, bytes.length, rest.length);
    }

    /** (x - 2) (x - 2^2) … (x - 2^16), the highest coefficient first. */
    private static int[] generator() {
        int[] generator = {1};
        int root = 1;
        for (int i = 0; i < LENGTH; i++) {
            root = product(root, 2);
            int[] longer = Arrays.copyOf(generator, generator.length + 1);
            for (int k = 0; k < generator.length; k++) {
                longer[k + 1] ^= product(generator[k], root);
            }
            generator = longer;
        }
        return generator;
    }

    /** Bit by bit, as one multiplies on paper. */
    private static int product(int a, int b) {
        int product = 0;
        for (int bit = 7; bit >= 0; bit--) {
            product <<= 1;
            product ^= (product & 0x100) != 0 ? POLYNOMIAL : 0;
            product ^= (b >> bit & 1) != 0 ? a : 0;
        }
        return product;
    }
}
