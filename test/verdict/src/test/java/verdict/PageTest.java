package verdict;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PageTest {

    private static Row row(int cases, int run, int right) {
        return new Row("Wycheproof aes_ccm", "0.7.0", "`Ccm`", cases, run, right, "");
    }

    private static List<String> lines(Row... rows) {
        return Page.page(List.of(rows).stream().map(Row::toString).toList());
    }

    @Test
    void page_isReadAsItWasWritten() {
        Row skipping = new Row("Wycheproof ecdh", "0.7.0", "`P256`", 612, 331, 331, "281: not our encoding");
        List<Row> read = lines(row(552, 552, 552), skipping).stream().map(Row::parse)
                .flatMap(Optional::stream).toList();
        assertEquals(List.of(row(552, 552, 552), skipping), read);
        assertTrue(lines(row(552, 552, 552), skipping).contains("883 cases were run, of 1164."));
    }

    @ParameterizedTest
    @CsvSource({"9, 8, 8, 'Wycheproof aes_ccm, `Ccm`: cases 9, before 10'",
            "10, 7, 7, 'Wycheproof aes_ccm, `Ccm`: run 7, before 8'",
            "10, 8, 7, 'Wycheproof aes_ccm, `Ccm`: right 7, before 8'", "11, 9, 9, ", "10, 8, 8, "})
    void number_thatFalls_isTold(int cases, int run, int right, String told) {
        assertEquals(told == null ? List.of() : List.of(told),
                Page.worse(lines(row(10, 8, 8)), lines(row(cases, run, right))));
    }

    @Test
    void row_thatIsMissing_isTold() {
        assertEquals(List.of("Wycheproof aes_ccm, `Ccm`: was not run"), Page.worse(lines(row(10, 8, 8)), List.of()));
        assertEquals(List.of(), Page.worse(List.of(), lines(row(10, 8, 8))));
    }

    @Test
    void row_ofASourceThatIsNotRun_isKept() {
        List<String> earlier = lines(row(10, 8, 8));
        assertEquals(List.of(row(10, 8, 8)), Page.kept(earlier, List.of(), Set.of("Wycheproof aes_ccm")));
        assertEquals(List.of(), Page.kept(earlier, List.of(), Set.of("Jason's own tests")));
        assertEquals(List.of(), Page.kept(earlier, lines(row(9, 8, 8)), Set.of("Wycheproof aes_ccm")));
    }
}
