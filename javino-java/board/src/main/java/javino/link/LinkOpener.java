package javino.link;

/** Knows the place of a board, and opens a link to it, as often as needed. */
public interface LinkOpener {

    /**
     * Opens the link.
     *
     * @throws LinkException if it cannot be opened now; it may be later.
     */
    Link open() throws LinkException;

    /** The user's name for this link, such as {@code /dev/ttyACM0}. */
    String name();
}
