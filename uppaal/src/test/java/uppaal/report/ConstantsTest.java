package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import uppaal.ModelException;
import uppaal.document.Document;
import uppaal.document.Template;

class ConstantsTest {
    private static final Firmware FIRMWARE = new Firmware(List.of(
            "static const uint8_t TRIES = 8;\nconst uint16_t BITS = 4 * 4;\n#define SENDS 2\n",
            "static const uint8_t ALL_SENDS = SENDS;\nRadio(uint8_t pin = 1, uint16_t rate = 2000);\n"
                    + "const uint8_t TWICE = 1;\nconst uint8_t ODD = static_cast<uint8_t>(7);",
            "const uint8_t TWICE = 2;\nuint8_t number = 3, other;\n"));

    private static List<String> differences(String declarations) {
        return Constants.differences(new Document("m.xml", declarations, List.of(), ""), FIRMWARE);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "const int TRIES = 8;                                | ''",
            "const int TRIES = 9;                                | m.xml: TRIES is 9, by the firmware's sources "
                    + "it must be 8",
            "const int TRIES = 9; // a remark                    | m.xml: TRIES is 9, by the firmware's sources "
                    + "it must be 8",
            "const int T = 7; // = TRIES - 1                     | ''",
            "const int T = 7; // = TRIES: all of them            | m.xml: T is 7, by the firmware's sources it "
                    + "must be 8",
            "const int T = 125; // = rate / BITS                 | ''",
            "const int ALL_SENDS = 2, SENDS = 3;                 | m.xml: SENDS is 3, by the firmware's sources "
                    + "it must be 2",
            "const int[0,9] T = 5;                               | m.xml: the firmware has no T; say behind it "
                    + "'// = …' with the "
                    + "firmware's names, or '// model: …' if it is of the model alone",
            "const int T = 5; // many                            | m.xml: the firmware has no T; say behind it "
                    + "'// = …' with the firmware's names, or '// model: …' if it is of the model alone",
            "const int T = 5, U = 6; // model: why               | ''",
            "const bool T = true;                                | m.xml: the firmware has no T; say behind it "
                    + "'// = …' with the "
                    + "firmware's names, or '// model: …' if it is of the model alone",
            "const int T[2] = {1, 2}; // model: why              | ''",
            "int TRIES = 9; chan c;                              | ''"})
    void differences_declaration_areSaid(String declarations, String expected) {
        assertEquals(expected, String.join("; ", differences(declarations)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "const int TWICE = 1;             | the firmware's TWICE: it is given as 1 and as 2",
            "const int T = 1; // = NONE       | m.xml, T: 'NONE' has no value here",
            "const int ODD = 7;               | the firmware's ODD: 'static_cast' has no value here",
            "const int TRIES = 4 * N;         | m.xml, TRIES: write its number, so that it can be compared"})
    void differences_notToBeCompared_isSaid(String declarations, String expected) {
        assertEquals(expected,
                assertThrows(ModelException.class, () -> differences(declarations)).getMessage());
    }

    @Test
    void differences_constantOfATemplate_isComparedToo() {
        Template template = new Template("T", "", "const int TRIES = 7;", List.of(), "", List.of());
        assertEquals(1, Constants.differences(new Document("m.xml", "", List.of(template), ""), FIRMWARE).size());
    }

    @Test
    void of_sourcesOfTheFirmware_haveTheirNames() {
        Firmware firmware = Firmware.of(Path.of("../javino-firmware/src"));
        assertTrue(firmware.term("MAX_ATTEMPTS").isPresent() && firmware.term("bitRate").isPresent());
        assertTrue(firmware.term("NOT_THERE").isEmpty());
    }
}
