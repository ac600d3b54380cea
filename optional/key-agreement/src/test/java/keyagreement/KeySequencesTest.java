package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.AnnotatedElementContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.io.TempDirFactory;

/** Whatever befalls boards, keys and hosts: no nonce comes twice under a key, and no message is taken twice. */
class KeySequencesTest {

    private static final int FEW = 48;
    private static final int MANY = 200;
    private static final int MOST = 10_000;
    /** One of so many sequences has certificates, as agreements take most of the time. */
    private static final int CERTIFIED_OF_FEW = 4;
    private static final int CERTIFIED_OF_MANY = 16;

    @TempDir(factory = InMemory.class)
    static Path identities;
    @TempDir(factory = InMemory.class)
    Path folder;

    /** Notes are written to the disk before anything is done by them; where there is no disk, that takes no time. */
    static final class InMemory implements TempDirFactory {

        private static final Path MEMORY = Path.of("/dev/shm");

        @Override
        public Path createTempDirectory(AnnotatedElementContext element, ExtensionContext extension)
                throws IOException {
            return Files.isWritable(MEMORY) ? Files.createTempDirectory(MEMORY, "javino")
                    : Files.createTempDirectory("javino");
        }
    }

    @BeforeAll
    static void certify() {
        TestAuthority authority = new TestAuthority(identities);
        authority.certified("BUSA");
        authority.certified("BUSB");
        authority.groupKeyServer("BUKE");
    }

    private void run(int count, int certifiedOf) throws Exception {
        List<String> wrong = new ArrayList<>();
        for (long seed = 0; seed < count; seed++) {
            boolean certified = seed % certifiedOf == 0;
            try (KeySequence sequence = new KeySequence(seed, folder.resolve("" + seed),
                    certified ? Optional.of(identities) : Optional.empty())) {
                sequence.run();
                if (!sequence.wrong.isEmpty()) {
                    wrong.add("seed " + seed + ": " + sequence.wrong + " after " + sequence.steps);
                }
            }
        }
        assertEquals(List.of(), wrong, () -> wrong.size() + " of " + count);
    }

    @Test
    void sequences_some_repeatNoNonceAndTakeNothingTwice() throws Exception {
        run(FEW, CERTIFIED_OF_FEW);
    }

    @Test
    @Tag("verify")
    void sequences_twoHundred_repeatNoNonceAndTakeNothingTwice() throws Exception {
        run(MANY, CERTIFIED_OF_MANY);
    }

    @Test
    @Tag("soak")
    void sequences_tenThousand_repeatNoNonceAndTakeNothingTwice() throws Exception {
        run(MOST, CERTIFIED_OF_MANY);
    }
}
