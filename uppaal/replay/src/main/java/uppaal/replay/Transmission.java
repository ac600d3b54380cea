package uppaal.replay;

/** What a host has given its board to send. */
final class Transmission {
    final int number;
    final String destination;
    /** When its host has asked for it, in seconds. */
    final double asked;
    /** The packet of another device that is to be sent as it is, in hexadecimal digits; empty if it is none. */
    String relayed = "";
    /** Whether that was sent. */
    boolean wasRelayed;
    /** What was sent of it; null as long as nothing was. */
    Message message;
    /** What was sent of it before it was sealed anew; null where it was not. */
    Message before;
    /** How often something else was sent once more though this had its turn. */
    int passedOver;
    /** The check value of the board's key for its destination when it was asked for; null where none is known. */
    String check;
    /** Whether it may end without having been sent: its board may lack the key. */
    boolean mayFail;
    /** Whether it may end at any moment: the key may be gone with which it was sealed. */
    boolean keyMayBeGone;
    /** How it ended, as the host was told; empty as long as it was not. */
    String outcome = "";

    Transmission(int number, String destination, double asked) {
        this.asked = asked;
        this.number = number;
        this.destination = destination;
    }
}
