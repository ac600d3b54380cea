package uppaal.replay;

/** The model does not allow what was seen; the message says what it was and what could have been instead. */
final class RefusedException extends Exception {
    private static final long serialVersionUID = 1L;

    RefusedException(String what) {
        super(what);
    }
}
