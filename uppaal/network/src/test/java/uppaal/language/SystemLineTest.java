package uppaal.language;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import uppaal.ModelException;

class SystemLineTest {
    @Test
    void parse_instances_areInTheOrderOfTheSystemLine() {
        List<SystemLine.Instance> instances = SystemLine.parse(
                "A1 = T(1 + 1, true); B1 = T(0, false); unused = T3(); system V, B1, A1;", Scope.global(), "here");

        assertEquals(List.of("V", "B1", "A1"), instances.stream().map(SystemLine.Instance::name).toList());
        assertEquals(List.of("V", "T", "T"), instances.stream().map(SystemLine.Instance::template).toList());
        assertArrayEquals(new int[] {2, 1}, instances.get(2).arguments());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "system P, P;            | 'P' stands twice in the system line",
            "P = T(); P = T(); system P; | 'P' is instantiated twice",
            "system P < Q;           | expected ';', not '<'",
            "int x; system P;        | 'int' here, where a name is read, is outside the subset that this checker reads",
            "P = T(x); system P;     | 'x' has no value here",
            "P = T(1 2); system P;   | expected ',', not '2'",
            "''                      | expected a name, not the end",
            "system P; progress { }  | 'progress' here, where the end is read, is outside the subset that this "
                    + "checker reads"})
    void parse_wrong_saysWhat(String text, String message) {
        assertEquals("here: " + message,
                assertThrows(ModelException.class, () -> SystemLine.parse(text, Scope.global(), "here")).getMessage());
    }
}
