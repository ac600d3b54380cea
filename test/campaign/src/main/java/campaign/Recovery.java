package campaign;

import harness.TraceEvent;

/** What became of one fault: when its cause ended, and when each direction of its pair delivered again, in emulated seconds. */
final class Recovery {

    private static final double NEVER = Double.POSITIVE_INFINITY;
    /** An acknowledgement that says "delivered": header and proof (SPEC 7.3). */
    private static final int DELIVERED_BYTES = 18;
    private static final String TO_ACKNOWLEDGEMENT = "2b4b";

    private final Fault fault;
    private final Field.Post hit;
    private final Field.Post other;
    private double end = NEVER;
    private double hitDelivers = NEVER;
    private double otherDelivers = NEVER;

    /**
     * @param hit   the board that the fault befalls.
     * @param other its peer.
     */
    Recovery(Fault fault, Field.Post hit, Field.Post other) {
        this.fault = fault;
        this.hit = hit;
        this.other = other;
    }

    Fault fault() {
        return fault;
    }

    /** Takes notice of an event of the trace. */
    void see(TraceEvent event) {
        if (end == NEVER) end = fault.end(event, hit.name()).orElse(NEVER);
        if (end == NEVER || event.seconds() <= end || !isDelivered(event)) return;
        if (event.board().equals(hit.name())) hitDelivers = Math.min(hitDelivers, event.seconds());
        if (event.board().equals(other.name())) otherDelivers = Math.min(otherDelivers, event.seconds());
    }

    private static boolean isDelivered(TraceEvent event) {
        if (!event.name().equals("rf-rx")) return false;
        String payload = event.text("payload");
        return payload.length() == 2 * DELIVERED_BYTES && payload.startsWith(TO_ACKNOWLEDGEMENT);
    }

    boolean ended() {
        return end != NEVER;
    }

    /** From the cause's end to the first unicast delivered, whoever sent it; infinite if none was. */
    double first() {
        return Math.min(hitDelivers, otherDelivers) - end;
    }

    /** From the cause's end until both had delivered one; infinite if one never did. */
    double both() {
        return Math.max(hitDelivers, otherDelivers) - end;
    }
}
