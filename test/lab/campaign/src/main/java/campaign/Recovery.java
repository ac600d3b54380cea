package campaign;

import trace.TraceEvent;

/**
 * The recovery from one fault, in emulated seconds: when its cause ended, when a packet of its pair was answered again,
 * and when each direction delivered again.
 */
final class Recovery {

    private static final double NEVER = Double.POSITIVE_INFINITY;
    /** An acknowledgement that says "delivered": header and proof (SPEC 7.3). */
    private static final int DELIVERED_BYTES = 18;
    private static final String TO_ACKNOWLEDGEMENT = "2b4b";

    private final Fault fault;
    private final Field.Post hit;
    private final Field.Post other;
    private double end = NEVER;
    private double answered = NEVER;
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
        if (end == NEVER) {
            end = fault.end(event, hit.name()).orElse(NEVER);
        }
        if (end == NEVER || event.seconds() <= end || !isAnswer(event)) {
            return;
        }
        if (matches(event)) {
            answered = Math.min(answered, event.seconds());
        }
        if (!isDelivered(event)) {
            return;
        }
        if (event.board().equals(hit.name())) {
            hitDelivers = Math.min(hitDelivers, event.seconds());
        }
        if (event.board().equals(other.name())) {
            otherDelivers = Math.min(otherDelivers, event.seconds());
        }
    }

    private boolean matches(TraceEvent event) {
        return event.board().equals(hit.name()) || event.board().equals(other.name());
    }

    private static boolean isAnswer(TraceEvent event) {
        return event.name().equals("rf-rx") && event.text("payload").startsWith(TO_ACKNOWLEDGEMENT);
    }

    private static boolean isDelivered(TraceEvent answer) {
        return answer.text("payload").length() == 2 * DELIVERED_BYTES;
    }

    boolean ended() {
        return end != NEVER;
    }

    /**
     * From the cause's end until a packet of either board came to the other and its answer came back, whatever that
     * said; infinite if none did.
     */
    double answered() {
        return answered - end;
    }

    /** The time from the cause's end to the first unicast delivered, whoever sent it; infinite if none was. */
    double first() {
        return Math.min(hitDelivers, otherDelivers) - end;
    }

    /** The time from the cause's end until both had delivered one; infinite if one never did. */
    double both() {
        return Math.max(hitDelivers, otherDelivers) - end;
    }
}
