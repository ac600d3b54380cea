package mobility;

/** Something in an agent has no text that could travel. */
final class CannotTravelException extends Exception {

    private static final long serialVersionUID = 1L;

    /** @param why what it is, and why, in one line. */
    CannotTravelException(String why) {
        super(why);
    }
}
