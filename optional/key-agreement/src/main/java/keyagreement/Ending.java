package keyagreement;

import java.util.Locale;

/** The outcome of a message to a certified device. */
enum Ending {
    /** The device's host has taken it. */
    DELIVERED,
    /** There is no proof of that; it may have arrived all the same. */
    UNDELIVERED,
    /** Nobody of that address has proved a certificate that counts here. */
    NO_ANSWER,
    /** A revocation list of the authority names the certificate. */
    REVOKED,
    /** The certificate's last day is past. */
    EXPIRED,
    /** The board does not take the key, or the message. */
    NOT_SENT,
    /** No group key server has given the key of the group. */
    NO_GROUP_KEY,
    /** This host agrees on keys with nobody any more. */
    CLOSED;

    /** The error as an atom of AgentSpeak, such as {@code no_answer}. */
    String atom() {
        return this == NO_GROUP_KEY || this == CLOSED ? "no_key" : name().toLowerCase(Locale.ROOT);
    }
}
