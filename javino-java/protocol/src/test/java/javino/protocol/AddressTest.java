package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class AddressTest {

    private static final VectorFile FILE = new VectorFile("addresses.json");

    static Stream<JsonObject> valid() {
        return FILE.list("valid");
    }

    static Stream<JsonObject> invalid() {
        return FILE.list("invalid");
    }

    @ParameterizedTest
    @MethodSource("valid")
    void parse_validVector_hasItsValueAndClass(JsonObject vector) {
        Address address = VectorFile.address(vector, "text");
        assertEquals(VectorFile.text(vector, "value"), String.format("%06x", address.value()));
        assertEquals(VectorFile.text(vector, "class"), address.kind().name().toLowerCase(Locale.ROOT));
        assertEquals(VectorFile.text(vector, "group"), address.group());
        assertEquals(VectorFile.text(vector, "member"), address.member());
        assertEquals(VectorFile.text(vector, "text"), address.toString());
    }

    @ParameterizedTest
    @MethodSource("invalid")
    void parse_invalidVector_throws(JsonObject vector) {
        assertThrows(IllegalArgumentException.class, () -> Address.parse(VectorFile.text(vector, "text")));
    }

    @Test
    void parse_badDigit_messageNamesIt() {
        Exception e = assertThrows(IllegalArgumentException.class, () -> Address.parse("SU\\\\"));
        assertTrue(e.getMessage().contains("'\\'"), e.getMessage());
    }

    @Test
    void decode_addressAtTheEnd_isReadAndNothingShorter() throws ProtocolException {
        assertEquals(Address.parse("ROMA"), Address.decode(Bytes.ofText("xROMA"), 1));
        for (Bytes cut : List.of(Bytes.ofText("xROM"), Bytes.ofText("x"))) {
            assertEquals(ProtocolError.TOO_SHORT,
                    assertThrows(ProtocolException.class, () -> Address.decode(cut, 1)).error());
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0x7F, 0x80, 0xFF})
    void decode_noDigit_throws(int last) {
        assertEquals(ProtocolError.BAD_DIGIT, assertThrows(ProtocolException.class,
                () -> Address.decode(Bytes.of('R', 'O', 'M', last), 0)).error());
    }

    @Test
    void kind_everyValue_isCountedAsInTheTable() {
        Map<Address.Kind, Integer> counts = new EnumMap<>(Address.Kind.class);
        for (int value = 0; value <= 0xFFFFFF; value += value < 0xF80000 ? 0x1000 : 1) {
            counts.merge(new Address(value).kind(), 1, Integer::sum);
        }
        assertEquals(3968, counts.get(Address.Kind.DEVICE), "groups of devices");
        assertEquals(1, counts.get(Address.Kind.SERIAL));
        assertEquals(1, counts.get(Address.Kind.BROADCAST));
        assertEquals(4095, counts.get(Address.Kind.MULTICAST));
        assertEquals(4096, counts.get(Address.Kind.FRAGMENT));
        assertEquals(4096, counts.get(Address.Kind.ACKNOWLEDGEMENT));
        assertEquals(0x80000 - 1 - 1 - 4095 - 2 * 4096, counts.get(Address.Kind.RESERVED));
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 0x1000000})
    void constructor_outOfRange_throws(int value) {
        assertThrows(IllegalArgumentException.class, () -> new Address(value));
    }

    @ParameterizedTest
    @CsvSource({"SUPO,SUPO,true", "SUPO,SUPP,false", "//SU,SUPO,true", "//SU,ROMA,false", "////,ROMA,true",
            "+FSU,SUPO,false", "++++,SUPO,false"})
    void reaches_device_isWhomAFrameIsFor(String to, String device, boolean reached) {
        assertEquals(reached, Address.parse(to).reaches(Address.parse(device)));
    }

    @Test
    void multicast_group_isItsAddress() {
        assertEquals("//SU", Address.multicast("SU").toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "S", "SUP", "//", "S-"})
    void multicast_noGroup_throws(String group) {
        assertThrows(IllegalArgumentException.class, () -> Address.multicast(group));
    }
}
