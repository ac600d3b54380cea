package gateway;

/** What a gateway counts. */
enum GatewayCounter {
    /** Questions which cell has heard a device. */
    SOUGHT("sought"),
    /** Questions of other cells beyond their limit, and answers for which nobody asked. */
    UNHEEDED("unheeded"),
    /** Packets that its board has heard. */
    HEARD("heard"),
    /** Of these, packets that came damaged beyond mending; nobody else gets them. */
    DAMAGED("damaged"),
    /** Of these, packets that are no frame of SPEC.md, or of an impossible address. */
    FOREIGN("foreign"),
    /** Of these, frames that a gateway has just relayed here; they come from another cell. */
    ECHOES("echoes"),
    /** Of these, frames that went to the broker. */
    PUBLISHED("published"),
    /** Of these, frames for this cell alone, as far as is known. */
    LOCAL("local"),
    /** Packets that were heard and did not go, as the broker was not there or did not take them fast enough. */
    UNPUBLISHED("unpublished"),
    /** Messages from other cells. */
    ARRIVED("arrived"),
    /** Of these, messages that are no frame. */
    MALFORMED("malformed"),
    /** Of these, frames that another gateway of this cell is to relay, or whose own board is not there. */
    STANDBY("standby"),
    /** Of these, frames that have been on the air here already. */
    DUPLICATES("duplicates"),
    /** Of these, repeats of a frame whose acknowledgement is on its way back. */
    ANSWERED("answered"),
    /** Of these, frames for a group without a member here, and broadcasts that nobody wants. */
    ELSEWHERE("elsewhere"),
    /** Of these, frames that would have taken more of the air than a gateway may take. */
    OVER_BUDGET("overBudget"),
    /** Of these, frames that came or waited so long that their sender has given up. */
    EXPIRED("expired"),
    /** Of these, frames for which there was no room. */
    OVERFLOWED("overflowed"),
    /** Of these, frames that the board has sent. */
    RELAYED("relayed"),
    /** Of these, frames that the board has not sent. */
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
