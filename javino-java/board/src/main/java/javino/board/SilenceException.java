package javino.board;

/** The board has left a request unanswered: its sketch may hang. */
final class SilenceException extends LostException {

    private static final long serialVersionUID = 1L;

    /** @param why one line that begins with the link's name. */
    SilenceException(String why) {
        super(why);
    }
}
