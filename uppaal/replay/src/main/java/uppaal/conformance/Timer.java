package uppaal.conformance;

/** What a board waits for in quiet air. */
interface Timer {
    /** None, or one of which the trace does not tell enough. */
    Timer NONE = new Timer() {};

    /** The board's air becomes busy; called before the air is. */
    default void busy(Point point) {}

    /** It becomes quiet. */
    default void quiet(Point point) {}

    /** It has done nothing up to the run() before. */
    default void checkNotLate(Point point) throws RefusedException {}

    /** It does it now. */
    default void checkNotEarly(Point point) throws RefusedException {}
}
