package mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigInteger;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

class RegionTest {

    private static final String UNICAST = "42303031423030304256000001000000aabb0001020304050607";
    private static final int BASE = 16;

    @Test
    void of_unicast_isAddressesSizeNonceCiphertextAndTag() {
        assertEquals(List.of(new Region("destination", 0, 4), new Region("origin", 4, 8), new Region("size", 8, 10),
                new Region("nonce", 10, 16), new Region("ciphertext", 16, 18), new Region("tag", 18, 26)),
                Region.of("unicast", UNICAST));
    }

    @Test
    void of_acknowledgementWithoutMore_hasNoEmptyRegion() {
        assertEquals(List.of("destination", "origin", "size", "proof"),
                Region.of("acknowledgement", "2b4b41414230303142410001020304050607").stream().map(Region::name)
                        .toList());
    }

    @Test
    void flipped_anySeed_turnsOneBitOfTheRegion() {
        for (int seed = 0; seed < 200; seed++) {
            for (Region region : Region.of("unicast", UNICAST)) {
                String flipped = region.flipped(UNICAST, new Random(seed));
                assertEquals(UNICAST.length(), flipped.length());
                assertEquals(UNICAST, region.with(flipped, region.in(UNICAST)));
                assertEquals(1, new BigInteger(flipped, BASE).xor(new BigInteger(UNICAST, BASE)).bitCount());
            }
        }
    }

    @Test
    void zeroed_region_leavesTheRest() {
        Region tag = Region.of("unicast", UNICAST).get(5);
        assertEquals(UNICAST.substring(0, 36) + "0".repeat(16), tag.zeroed(UNICAST));
    }

    @Test
    void nonce_packetWithoutOne_isEmpty() {
        assertEquals(Optional.empty(), Region.nonce("broadcast", UNICAST));
    }
}
