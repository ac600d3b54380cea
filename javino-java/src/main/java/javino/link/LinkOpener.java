package javino.link;

/** Knows where a board is, and opens a link to it, again and again if need be. */
public interface LinkOpener {

    /**
     * Opens the link.
     *
     * @throws LinkException if it cannot be opened now; it may be later.
     */
    Link open() throws LinkException;

    /** What a user calls this link, such as {@code /dev/ttyACM0}. */
    String name();
}
