package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class VerifytaTest {
    private static final Path MODEL = Path.of("models/quiet.xml");
    private static final Path QUERIES = Path.of("models/quiet.q");

    @TempDir
    private Path folder;

    /** A program that writes what UPPAAL's would. */
    private Verifyta pretending(String output, int status) throws IOException {
        Path program = Files.writeString(folder.resolve("verifyta"),
                "#!/bin/sh\ncat <<'END'\n" + output + "\nEND\nexit " + status + "\n");
        Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwx------"));
        return new Verifyta(program.toString());
    }

    @Test
    void verdicts_bothWordings_areRead() {
        assertEquals(List.of(true, false, true), Verifyta.verdicts(
                "Verifying formula 1 at paper.q:5\n\033[2K -- Formula is satisfied.\nVerifying formula 2\n -- "
                        + "Formula is NOT satisfied.\n"
                        + "Verifying property 3 at line 9\n -- Property is satisfied.\n"));
    }

    @Test
    void check_oneVerdictEach_isTaken() throws IOException {
        assertEquals(List.of(true), pretending(" -- Formula is satisfied.", 0).check(MODEL, QUERIES, 1));
    }

    @Test
    void check_noLicence_saysWhatItWrote() throws IOException {
        Verifyta silent = pretending("License key is not set.", 0);
        assertEquals("verifyta gave 0 verdicts on the 1 properties of quiet.q: License key is not set.",
                assertThrows(IOException.class, () -> silent.check(MODEL, QUERIES, 1)).getMessage());
        Verifyta failing = pretending("License key is not set.", 1);
        assertTrue(assertThrows(IOException.class, () -> failing.check(MODEL, QUERIES, 1)).getMessage()
                .endsWith("ended with 1: License key is not set."));
    }
}
