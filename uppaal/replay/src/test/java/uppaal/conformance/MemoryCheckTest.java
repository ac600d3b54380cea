package uppaal.conformance;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Boards' points about their EEPROM, by scripts of {@link TestTrace}. */
class MemoryCheckTest {
    private static final String STORE = "support stores 300 F F; support FLOOR_STORED key=0 place=0; ";
    private static final String KEY =
            "support does eeprom at=500 length=43 hex=4943ce0001aabbcc; support KEY_STORED key=0; ";
    private static final String AGAIN =
            "support does reset why=watchdog; support stores 400 000002; support stores 420 000002; "
                    + "support EPOCH_STORED low=2; ";

    /** F is a floor of SUPO under key 0, of epoch 1 and counter 31; G one of 63, H of 62, L of 30; O another's. */
    private static String verdict(String script) {
        return new TestTrace(script.replace("STORE; ", STORE).replace("KEY; ", KEY).replace("AGAIN; ", AGAIN)
                .replaceAll("\\bF\\b", "004943ce00000100001f").replaceAll("\\bG\\b", "004943ce00000100003f")
                .replaceAll("\\bL\\b", "004943ce00000100001e").replaceAll("\\bO\\b", "004943cf00000100001f")
                .replaceAll("\\bH\\b", "004943ce00000100003e"))
                .verdict(MemoryCheck::new);
    }

    @ParameterizedTest
    @ValueSource(strings = {
            "STORE; support queues 0; support hands 0 SUPP 010000 help; support queues 31; "
                    + "support hands 1 SUPP 01001f help",
            "STORE; support stores 326 G G; support FLOOR_STORED key=0 place=1; support queues 32; "
                    + "support hands 0 SUPP 010020 help",
            "support KEY_STORED key=9; support queues 0 9; support hands 0 SUPP 010000 help",
            "support queues 0 255; support hands 0 //// 000000 help",
            "KEY; support asks SUPO help; support seals 0 0",
            "KEY; support KEY_DELETED key=0; support asks SUPO help; support seals 0 1",
            "KEY; support KEY_STORED key=1; support asks SUPO help; support seals 0 1",
            "KEY; support does host-key step=set asked=3 address=SUPO check=aabbcc",
            "support does host-key step=set asked=3 address=SUPO check=aabbcc",
            "STORE; AGAIN; support MEMORY kept=1; support queues 1; support hands 0 SUPP 010001 help",
            "support stores 300 F; support does reset why=watchdog; support stores 400 000002; "
                    + "support stores 420 000002; support EPOCH_STORED low=2; support MEMORY kept=1; "
                    + "support stores 313 F; support QUIET; support queues 0; support hands 0 SUPP 010000 a",
            "support does fault torn=313; support boots 000002; support stores 300 F; "
                    + "support answers STALE a:0:00000100001f0000",
            "support does fault torn=313; support boots 000002; support answers STALE a:0:00000100001f0000",
            "STORE; support answers STALE a:0:00000100001f0000",
            "STORE; KEY; support stores 326 L L; support FLOOR_STORED key=0 place=1; support queues 0; "
                    + "support hands 0 SUPP 010000 help",
    })
    void genuine_isAccepted(String script) {
        TestTrace.assertAccepted(verdict(script));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "support FLOOR_STORED key=0 place=0 | support declares a floor of key 0 stored; "
                    + "expected two whole records of it",
            "support stores 300 F; support FLOOR_STORED key=0 place=0 | two whole records",
            "support stores 300 F G; support FLOOR_STORED key=0 place=0 | two whole records",
            "support stores 300 F F; support FLOOR_STORED key=1 place=0 | two whole records",
            "STORE; support FLOOR_STORED key=0 place=0 | two whole records",
            "STORE; support stores 326 H H; support FLOOR_STORED key=0 place=1"
                    + " | stores the floor 00000100003e; expected one for a nonce above",
            "STORE; support stores 400 G G; support FLOOR_STORED key=0 place=1"
                    + " | place 1 of its ring, which begins at 300",
            "support queues 0; support hands 0 SUPP 010000 help"
                    + " | hands its host message 0 of SUPO with the id 010000; expect",
            "STORE; support queues 32; support hands 0 SUPP 010020 help"
                    + " | that a floor of at most 31 above it was stored",
            "support stores 300 G G; support FLOOR_STORED key=0 place=0; support queues 0; "
                    + "support hands 0 SUPP 010000 help | "
                    + "that a floor",
            "support stores 300 O O; support FLOOR_STORED key=0 place=0; support queues 0; "
                    + "support hands 0 SUPP 010000 help | "
                    + "that a floor",
            "STORE; support queues 0; support hands 0 SUPP 020000 help | that a floor",
            "STORE; support queues 1; support hands 0 SUPP 010000 help | that a floor",
            "support queues 0; STORE; support hands 0 SUPP 010000 help | that a floor",
            "STORE; AGAIN; support MEMORY kept=0; support QUIET; support queues 1; support hands 0 SUPP 010001 help"
                    + " | after memory was lost",
            "STORE; support KEY_DELETED key=0; support queues 0; support hands 0 SUPP 010000 help | that a floor",
            "STORE; support answers STALE a:0:00000100001e0000 | support tells the floor 00000100001e; "
                    + "expected one that it",
            "support stores 300 F; support boots 000002; support answers STALE a:0:00000100001f0000 | one that",
            "support stores 300 F; support QUIET; support queues 0; support hands 0 SUPP 010000 help | that a floor",
            "AGAIN; support MEMORY kept=1; support MEMORY kept=1 | declares MEMORY; expected it once, and none kept",
            "support does reset why=power; support stores 400 000002; support stores 420 000002; "
                    + "support EPOCH_STORED low=2; support MEMORY kept=1 | none kept where its power was cut",
            "AGAIN; support QUIET | support declares QUIET; expected MEMORY first",
            "support does reset why=watchdog; support stores 400 000002; support stores 420 000002; "
                    + "support MEMORY kept=1 | expected EPOCH_STORED, as there is a new one",
            "KEY; support does eeprom at=544 length=43 hex=4943ce0001aabbcc; support KEY_STORED key=2"
                    + " | expected place 1",
            "support does eeprom at=500 length=43 hex=4943cf0001aabbcc; support KEY_STORED key=0; "
                    + "support asks SUPO help; support seals 0 0 | expected the place of a key of",
            "KEY; support asks SUPO help; support seals 0 1 | expected the place of a key of",
            "support asks SUPO help; support seals 0 255 | expected no key, if it is for all",
            "support EPOCH_STORED low=2 | support declares an epoch stored that ends in 2; "
                    + "expected two whole records of it, ab",
            "support stores 300 000002; support EPOCH_STORED low=2 | an epoch stored that ends in 2",
            "support stores 300 000001; support stores 400 000001; support EPOCH_STORED low=1 | above 000001",
            "support KEY_STORED key=0; support does host-key step=set asked=3 address=SUPO check=aabbcc | "
                    + "support declares the key of SUPO stored; "
                    + "expected a record of that address and check value aabbcc",
            "KEY; support does host-key step=renew asked=3 address=SUPO check=aabbcd | check value aabbcd",
            "KEY; support does host-key step=set asked=3 address=SUPP check=aabbcc | the key of SUPP stored",
    })
    void lie_isRefusedByName(String script, String why) {
        TestTrace.assertRefused(verdict(script), why);
    }
}
