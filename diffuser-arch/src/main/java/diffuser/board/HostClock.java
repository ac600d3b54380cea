package diffuser.board;

/** The time for what a host does by itself, and the one thread on which it does that. For any thread. */
public interface HostClock {

    /** In ms; never goes back. */
    long millis();

    /** Has something done as soon as that time has passed; not if all has been closed. */
    void after(long millis, Runnable step);

    /** Has something done behind all that waits. */
    default void execute(Runnable step) {
        after(0, step);
    }

    /** Nothing more is done. */
    void close();
}
