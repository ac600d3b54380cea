package gateway;

/** Limits to the work of this cell for each other one, so that no cell takes what is for all. */
final class CellLimits {

    private static final int MOST_CELLS = 256;
    private static final int PERCENT = 25;
    private static final int SEARCH_PERCENT = 1;
    private static final long AT_ONCE_MILLIS = 10_000;
    private static final long SEARCH_AT_ONCE_MILLIS = 2500;

    private final BoundedMap<String, Limits> cells = new BoundedMap<>(MOST_CELLS);

    /**
     * The limits of one cell.
     *
     * @param air      for its frames.
     * @param searches for those of its frames that look for a device.
     * @param answers  for answers to its questions: 20 at once, and then one a second.
     */
    record Limits(AirtimeBudget air, AirtimeBudget searches, AirtimeBudget answers) {
    }

    Limits of(String cell, long now) {
        Limits limits = cells.getOrDefault(cell, new Limits(new AirtimeBudget(AT_ONCE_MILLIS, PERCENT, now),
                new AirtimeBudget(SEARCH_AT_ONCE_MILLIS, SEARCH_PERCENT, now),
                new AirtimeBudget(DeviceSearch.AT_ONCE_MILLIS, 100, now)));
        cells.renew(cell, limits);
        return limits;
    }
}
