package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class BytesTest {

    @Test
    void bytes_sourceOrCopyChanged_stayTheSame() {
        byte[] source = {1, 2, 3};
        Bytes bytes = Bytes.copyOf(source);
        source[0] = 9;
        bytes.toArray()[1] = 9;
        assertEquals(Bytes.of(1, 2, 3), bytes);
    }

    @Test
    void number_ofNumber_isBigEndian() {
        assertEquals("010203", Bytes.ofNumber(0x010203, 3).hex());
        assertEquals(0xFFFFFFFFL, Bytes.of(-1, -1, -1, -1).number(0, 4));
    }

    @Test
    void equals_otherBytes_differ() {
        assertNotEquals(Bytes.of(1), Bytes.of(1, 0));
        assertEquals(Bytes.of(1).hashCode(), Bytes.ofHex("01").hashCode());
    }

    @Test
    void slice_outside_throws() {
        assertThrows(IndexOutOfBoundsException.class, () -> Bytes.of(1).slice(0, 2));
        assertThrows(IndexOutOfBoundsException.class, () -> Bytes.of(1).from(2));
    }

    @Test
    void crc_checkInput_isThatOfTheSpec() {
        assertEquals(0x906E, Crc16.of(Bytes.ofText("123456789")));
    }
}
