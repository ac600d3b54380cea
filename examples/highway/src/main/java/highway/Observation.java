package highway;

/** Something that was seen from outside: in what an agent printed, on the air, or at a pin. */
sealed interface Observation {

    /** Emulated seconds since the boards were switched on. */
    double seconds();

    /** A line that an agent printed. */
    record Printed(double seconds, Device device, String text) implements Observation {}

    /** A warning of its Java virtual machine, or of a library there. */
    record Warned(double seconds, Device device, String text) implements Observation {}

    /**
     * A radio packet that was sent.
     *
     * @param content the content of a plain frame, empty for a sealed one
     */
    record Aired(double seconds, String origin, String destination, boolean sealed, String content)
            implements Observation {}

    /**
     * A packet with which one host speaks to another, before they have a key (SPEC 11.3).
     *
     * @param destination the address of the other
     * @param words       the kind of packet
     */
    record Hosts(double seconds, String origin, String destination, String words) implements Observation {}

    /**
     * An acknowledgement that was sent (SPEC 7.3).
     *
     * @param answers its meaning (SPEC 7.3)
     */
    record Acknowledged(double seconds, String origin, String answers) implements Observation {}

    /** A packet that a board could not make out. */
    record Spoilt(double seconds, Device device, String why) implements Observation {}

    /** A watched actuator pin that changed. */
    record Pin(double seconds, Device device, String name, int level) implements Observation {
        /** {@code siren on}. */
        String words() {
            return name + (level == 1 ? " on" : " off");
        }
    }
}
