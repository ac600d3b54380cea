package fuzz;

/** Fails for what begins as a content does. */
public final class FaultyTarget {

    private FaultyTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) {
        if (data.length > 4 && data[0] == 't' && data[4] == ';') {
            throw new ArithmeticException("as was to be shown");
        }
    }
}
