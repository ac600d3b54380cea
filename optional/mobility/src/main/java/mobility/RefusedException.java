package mobility;

/** Why an agent does not leave, or is not taken in. */
public final class RefusedException extends Exception {

    private static final long serialVersionUID = 1L;

    private final String error;

    /**
     * @param error  an atom that a plan of the sender can match, such as {@code too_large}.
     * @param reason in one line.
     */
    public RefusedException(String error, String reason) {
        super(reason);
        this.error = error;
    }

    /** The atom. */
    public String error() {
        return error;
    }
}
