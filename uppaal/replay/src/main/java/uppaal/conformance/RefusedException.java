package uppaal.conformance;

/** A board did what it must not; the message says what that was and what was expected. */
final class RefusedException extends Exception {
    private static final long serialVersionUID = 1L;

    /** @param expected what could have been instead */
    RefusedException(String what, String expected) {
        super(what + "; expected " + expected);
    }

    static void require(boolean isRight, String what, String expected) throws RefusedException {
        if (!isRight) {
            throw new RefusedException(what, expected);
        }
    }
}
