package gateway;

/**
 * How long messages have been on their way, though the clocks of their senders may be wrong: longer than the fastest
 * message of the same gateway. No cell displaces the clocks of others, however many gateways it invents.
 */
final class MessageAges {

    private static final int MOST_CELLS = 256;
    /** Gateways of one cell; as many as a gateway knows of its own. */
    private static final int MOST_GATEWAYS = CellGateways.MOST;
    /** No message takes so long; the clock was set. */
    private static final long SET_MILLIS = 60_000;
    /** By so much a clock may be slow: one ms in a second. */
    private static final double DRIFT = 0.001;

    private final BoundedMap<String, BoundedMap<String, Fastest>> cells = new BoundedMap<>(MOST_CELLS);

    /** @param difference between the two clocks, with the way of the fastest message, at that time. */
    private record Fastest(double difference, long now) {
    }

    /**
     * The age of a message in ms.
     *
     * @param cell    the sender's cell.
     * @param gateway the sender's name, as it says.
     * @param sent    by its clock.
     * @param now     by ours.
     */
    long of(String cell, String gateway, long sent, long now) {
        BoundedMap<String, Fastest> gateways = cells.getOrDefault(cell, new BoundedMap<>(MOST_GATEWAYS));
        cells.renew(cell, gateways);
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
