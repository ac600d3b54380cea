package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.HostMessage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class KeyAgreementMessageTest {

    private static final Address SUPO = Address.parse("SUPO");
    private static final int PLAIN_LENGTH = 67;

    /** SPEC 11.3. */
    @ParameterizedTest
    @CsvSource({"MESSAGE_1,80,37", "MESSAGE_2,84,63 25", "MESSAGE_3,88,63", "RENEWAL_1,8c,16", "RENEWAL_2,90,16",
            "RENEWAL_3,94,8", "WANT,98,1", "GROUP,9c,0"})
    void plain_eachKind_hasItsNumberAndLengths(KeyAgreementMessage.Kind kind, String first, String lengths) {
        Bytes message = Bytes.copyOf(new byte[100]);
        List<String> found = new ArrayList<>();
        for (int i = 0; i < kind.fragments(); i++) {
            KeyAgreementMessage said = KeyAgreementMessage.of(kind, i, message);
            assertEquals(Integer.parseInt(first, 16) + i, said.to(SUPO).bytes().at(0));
            assertEquals(Optional.of(said), KeyAgreementMessage.plain(said.to(SUPO)));
            assertEquals(Optional.of(SUPO), KeyAgreementMessage.addressee(said.to(SUPO)));
            found.add(String.valueOf(said.body().length()));
        }
        assertEquals(lengths, String.join(" ", found));
    }

    @ParameterizedTest
    @CsvSource({"CONTENT,a0", "SEQUENCES,a4", "REVOCATION_LIST,a8", "GROUP_KEY,ac"})
    void sealed_eachKind_hasItsNumber(KeyAgreementMessage.Kind kind, String first) {
        KeyAgreementMessage said = KeyAgreementMessage.sealed(kind, Bytes.copyOf(new byte[16]));
        assertEquals(first, said.sealed().bytes().slice(0, 1).hex());
        assertEquals(Optional.of(said), KeyAgreementMessage.opened(said.sealed()));
    }

    @ParameterizedTest
    @EnumSource(KeyAgreementMessage.Kind.class)
    void read_anyOtherLength_isNone(KeyAgreementMessage.Kind kind) {
        int taken = 0;
        for (int length = 0; length <= PLAIN_LENGTH; length++) {
            HostMessage word = new HostMessage(Bytes.join(Bytes.of(kind.first(0)), Bytes.copyOf(new byte[length])));
            taken += KeyAgreementMessage.plain(word).isPresent() ? 1 : 0;
        }
        assertEquals(kind.compareTo(KeyAgreementMessage.Kind.GROUP) <= 0 ? 1 : 0, taken);
    }

    @Test
    void read_anyBytes_neverFails() {
        Random random = new Random(1);
        for (int i = 0; i < 100_000; i++) {
            byte[] bytes = new byte[1 + random.nextInt(i % 2 == 0 ? 80 : Content.MAX_LENGTH)];
            random.nextBytes(bytes);
            bytes[0] = (byte) (0x80 | bytes[0] & 0x3F);
            HostMessage word = new HostMessage(Bytes.copyOf(bytes));
            assertTrue(KeyAgreementMessage.plain(word).isEmpty() || KeyAgreementMessage.opened(word).isEmpty());
        }
    }

    @Test
    void fragments_forgedOnesBetween_doNotDisplaceTheGenuine() {
        Fragments fragments = new Fragments(2);
        assertEquals(List.of(), fragments.add(0, Bytes.of(1)));
        assertEquals(1, fragments.lacking().orElseThrow());
        assertEquals(List.of(), fragments.add(0, Bytes.of(9)));
        assertEquals(List.of(Bytes.of(1, 8), Bytes.of(9, 8)), fragments.add(1, Bytes.of(8)));
        assertEquals(List.of(Bytes.of(1, 2), Bytes.of(9, 2)), fragments.add(1, Bytes.of(2)));
        assertEquals(List.of(), fragments.add(1, Bytes.of(2)), "known already");
        assertTrue(fragments.lacking().isEmpty());
    }

    @Test
    void sparingly_askedAllTheTime_keepsItsGapsAndNobodyKnowsThem() {
        Shared shared = new Shared(null, null, new SecureRandom());
        Sparingly sparingly = new Sparingly(shared);
        long[] taken = LongStream.range(0, 100 * Sparingly.GAP_MILLIS).filter(sparingly::take).toArray();
        long[] gaps = IntStream.range(1, taken.length).mapToLong(i -> taken[i] - taken[i - 1]).toArray();
        assertTrue(LongStream.of(gaps).allMatch(gap -> gap >= Sparingly.GAP_MILLIS && gap < 3 * Sparingly.GAP_MILLIS));
        assertTrue(LongStream.of(gaps).distinct().count() > gaps.length / 2, () -> Arrays.toString(gaps));
        assertEquals(100 * Sparingly.GAP_MILLIS - taken.length, shared.events().get(Event.LIMITED));
    }
}
