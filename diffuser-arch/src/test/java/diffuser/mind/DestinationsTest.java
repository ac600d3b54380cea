package diffuser.mind;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;

import jason.JasonException;
import jason.asSyntax.ASSyntax;

import javino.protocol.Address;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DestinationsTest {

    @ParameterizedTest
    @CsvSource(quoteCharacter = '\0', value = {"broadcast,////", "\"broadcast\",////", "\"////\",////", "\"//SU\",//SU",
            "\"SU\\\\\",//SU", "\"ROMA\",ROMA", "roma,roma", "ROMA,ROMA"})
    void of_receiverAsUsersWriteIt_isItsAddress(String text, String address) throws Exception {
        assertEquals(address, Destinations.of(ASSyntax.parseTerm(text)).toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"\"++++\"", "\"+FSU\"", "\"ROM\"", "\"ROMAN\"", "5", "p(1)", "_", "\"\""})
    void of_anythingElse_isABadAddress(String text) throws Exception {
        assertBadAddress(assertThrows(JasonException.class, () -> Destinations.of(ASSyntax.parseTerm(text))));
    }

    @Test
    void device_addressOfAGroup_isABadAddress() throws Exception {
        assertEquals("ROMA", Destinations.device(ASSyntax.parseTerm("\"ROMA\"")).toString());
        assertBadAddress(assertThrows(JasonException.class,
                () -> Destinations.device(ASSyntax.parseTerm("\"//SU\""))));
    }

    private static void assertBadAddress(JasonException e) {
        assertEquals("error(bad_address)", e.getErrorTerms().get(0).toString());
        assertTrue(e.getMessage().contains(" is no RF address such as "), e.getMessage());
    }

    @Test
    void find_name_isItsAddressIfItIsOne() {
        assertEquals(Optional.of(Address.BROADCAST), Destinations.find("broadcast"));
        assertEquals(Optional.of(Address.parse("ROMA")), Destinations.find("ROMA"));
        assertEquals(Optional.of(Address.parse("//SU")), Destinations.find("SU\\"));
        assertEquals(Optional.empty(), Destinations.find("kitchen"));
        assertEquals(Optional.empty(), Destinations.find("++++"));
    }

    @ParameterizedTest
    @CsvSource({"SU//,true", "SUPO,false", "//SU,false", "////,false"})
    void isMistakable_address_isADeviceThatLooksLikeAGroup(String address, boolean mistakable) {
        assertEquals(mistakable, Destinations.isMistakable(Address.parse(address)));
    }
}
