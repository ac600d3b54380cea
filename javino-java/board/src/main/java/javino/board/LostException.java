package javino.board;

/** The board was greeted, and is lost again; the link may still be good. */
class LostException extends Exception {

    private static final long serialVersionUID = 1L;

    /** @param why one line that begins with the link's name. */
    LostException(String why) {
        super(why);
    }
}
