package keyagreement;

/** Events that {@link KeyAgreement} counts. */
public enum Event {
    /** Handshakes begun with certificates. */
    BEGUN,
    /** Handshakes begun from what was kept. */
    RENEWALS_BEGUN,
    /** First messages answered. */
    ANSWERED,
    /** Keys that a handshake gave to the board. */
    KEYS_SET,
    /** Handshakes that this host began and that came to nothing. */
    FAILED,
    /** Fragments sent again, and fragments asked for. */
    REPEATED,
    /** Messages between others, not for this host. */
    OVERHEARD,
    /** Words of no known kind or length. */
    MALFORMED,
    /** Messages of a handshake that were damaged, forged, or from whom they must not be. */
    REFUSED,
    /** Words that belong to nothing that goes on here. */
    STRAY,
    /** Messages not answered or not said, as too much is asked for. */
    LIMITED,
    /** First messages of a device with which this host's own handshake comes first. */
    CROSSED,
    /** Half-open handshakes that made room for newer ones, or had no message 3 in time. */
    EXPIRED,
    /** Contents that came again with an id that was here already. */
    DUPLICATES,
    /** Messages that were sent again under another key. */
    RESENT,
    /** Revocation lists taken that are newer than all before. */
    REVOCATION_LISTS
}
