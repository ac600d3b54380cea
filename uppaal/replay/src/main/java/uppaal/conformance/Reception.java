package uppaal.conformance;

import trace.TraceEvent;

/**
 * A packet that comes to a board, perhaps damaged.
 *
 * @param readBy the board has read it in the first run() behind this, in seconds; what is damaged, what others overlap,
 *     and what a module hands on late, may take longer, and what comes behind that waits
 */
record Reception(TraceEvent event, Transmission packet, double readBy) {

    String board() {
        return event.board();
    }

    boolean isIntact() {
        return event.is("rf-rx");
    }
}
