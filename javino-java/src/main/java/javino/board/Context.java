package javino.board;

/**
 * What the parts of a session share.
 *
 * @param name     the link's, for error lines.
 * @param config   of the session.
 * @param queue    the requests that wait, and the sign that the session was closed.
 * @param wishes   what the host wants of the board all the time.
 * @param tally    the session's counters.
 * @param listener told what happens; never throws.
 */
record Context(String name, BoardConfig config, RequestQueue queue, Wishes wishes, Tally tally,
               ListenerGuard listener) {
}
