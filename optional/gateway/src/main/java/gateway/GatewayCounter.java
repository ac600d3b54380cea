package gateway;

/** A gateway's counters. */
enum GatewayCounter {
    /** Questions which cell has heard a device. */
    SOUGHT("sought"),
    /** Questions of other cells beyond their limit, and answers for which nobody asked. */
    UNHEEDED("unheeded"),
    /** Packets that its board has heard. */
    HEARD("heard"),
    /** Heard packets that are damaged beyond correction; nobody else gets them. */
    DAMAGED("damaged"),
    /** Heard packets that are no frame of SPEC.md, or have an impossible address. */
    FOREIGN("foreign"),
    /** Heard frames that a gateway has just relayed here; they come from another cell. */
    ECHOES("echoes"),
    /** Heard frames that went to the broker. */
    PUBLISHED("published"),
    /** Heard frames for this cell alone, as far as is known. */
    LOCAL("local"),
    /** Packets that were heard and did not go, as the broker was not there or did not take them fast enough. */
    UNPUBLISHED("unpublished"),
    /** Messages from other cells. */
    ARRIVED("arrived"),
    /** Arrived messages that are no frame. */
    MALFORMED("malformed"),
    /** Arrived frames that another gateway of this cell is to relay, or whose own board is not there. */
    STANDBY("standby"),
    /** Arrived frames that have been on the air here already. */
    DUPLICATES("duplicates"),
    /** Arrived repeats of a frame whose acknowledgement is on its way back. */
    ANSWERED("answered"),
    /** Arrived frames for a group without a member here, and broadcasts that nobody wants. */
    ELSEWHERE("elsewhere"),
    /** Arrived frames that would have taken more of the air than a gateway may take. */
    OVER_BUDGET("overBudget"),
    /** Arrived frames that came so late, or waited so long, that their sender has given up. */
    EXPIRED("expired"),
    /** Arrived frames for which there was no room. */
    OVERFLOWED("overflowed"),
    /** Arrived frames that the board has sent. */
    RELAYED("relayed"),
    /** Arrived frames that the board has not sent. */
    FAILED("failed");

    private final String text;

    GatewayCounter(String text) {
        this.text = text;
    }

    /** The name in docs/mqtt.md. */
    @Override
    public String toString() {
        return text;
    }
}
