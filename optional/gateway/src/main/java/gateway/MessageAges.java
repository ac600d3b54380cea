package gateway;

/**
 * How long messages have been on their way, though the clocks of their senders may be wrong: longer than the fastest
 * message of the same gateway.
 */
final class MessageAges {

    private static final int MOST = 256;
    /** No message takes so long; the clock was set. */
    private static final long SET_MILLIS = 60_000;
    /** By so much a clock may be slow: one ms in a second. */
    private static final double DRIFT = 0.001;

    private final BoundedMap<String, Fastest> gateways = new BoundedMap<>(MOST);

    /** @param difference of the two clocks, with the way of the fastest message, at that time. */
    private record Fastest(double difference, long now) {
    }

    /**
     * The age of a message in ms.
     *
     * @param sent by the clock of the gateway that has sent it.
     * @param now  by ours.
     */
    long of(String gateway, long sent, long now) {
        long difference = now - sent;
        Fastest before = gateways.get(gateway);
        double least = before == null ? difference
                : Math.min(difference, before.difference + (now - before.now) * DRIFT);
        if (difference - least > SET_MILLIS) {
            least = difference;
        }
        gateways.renew(gateway, new Fastest(least, now));
        return Math.round(difference - least);
    }
}
