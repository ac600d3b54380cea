package javino.link;

import javino.JavinoException;

/** A link cannot be opened, or broke. */
public final class LinkException extends JavinoException {

    private static final long serialVersionUID = 1L;

    private final String port;

    /**
     * @param port   the link's name.
     * @param reason the failure, with the system's error if there is one.
     */
    public LinkException(String port, String reason) {
        super(port + ": " + reason);
        this.port = port;
    }

    /** The link's name. */
    public String port() {
        return port;
    }
}
