package systemtest;

import java.nio.charset.StandardCharsets;

/** Keys for tests; never for anything else. */
final class TestKeys {

    static final byte[] PAIR = "a pair of tests!".getBytes(StandardCharsets.US_ASCII);
    static final byte[] GROUP = "a group of tests".getBytes(StandardCharsets.US_ASCII);

    private TestKeys() { }
}
