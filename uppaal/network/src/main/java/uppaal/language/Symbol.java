package uppaal.language;

/** The meaning of a declared name. */
public sealed interface Symbol {
    /** A constant, or a parameter of an instance. */
    record Number(int value) implements Symbol {
    }

    /** A variable: the slot of the state that holds it. */
    record Variable(int slot) implements Symbol {
    }

    /** A clock: the slot of the state that holds its time. */
    record Clock(int slot) implements Symbol {
    }

    /** An array: its elements are declared too, as {@code name[0]} and so on. */
    record Array(int size) implements Symbol {
    }

    /**
     * A channel. Two channels are the same when they have the same name, since channels are global.
     *
     * @param broadcast whether all that listen hear it, rather than exactly one
     * @param urgent whether no time passes while it can be used
     */
    record Channel(String name, boolean broadcast, boolean urgent) implements Symbol {
        /** A channel that is not urgent. */
        public Channel(String name, boolean broadcast) {
            this(name, broadcast, false);
        }
    }
}
