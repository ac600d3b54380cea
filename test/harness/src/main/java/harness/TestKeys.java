package harness;

import java.nio.charset.StandardCharsets;

/** Keys for tests; never for anything else. */
public final class TestKeys {

    public static final byte[] PAIR = "a pair of tests!".getBytes(StandardCharsets.US_ASCII);
    public static final byte[] GROUP = "a group of tests".getBytes(StandardCharsets.US_ASCII);

    private TestKeys() {}
}
