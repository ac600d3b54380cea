package diffuser.gate;

/** A text from a board or from the air that is no AgentSpeak of the kind that was expected. */
public final class MalformedTextException extends Exception {

    private static final long serialVersionUID = 1L;

    /**
     * @param text   as it came.
     * @param reason the fault in it.
     */
    MalformedTextException(String text, String reason) {
        super("\"" + text + "\": " + reason);
    }
}
