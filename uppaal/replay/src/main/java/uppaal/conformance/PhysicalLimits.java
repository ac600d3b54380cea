package uppaal.conformance;

/** All tolerances of the replay: boards and emulator tell nothing more exactly. */
final class PhysicalLimits {
    /** The emulator's decoder of the air may tell an edge later by so many bits ({@code sniffer.c}). */
    static final int ARRIVAL_BITS = 8;

    /**
     * Arduino's millis() rises by 1 or 2 each 1.024 ms at 16 MHz, each 2.048 ms at 8 MHz: a time between two readings
     * is longer or shorter by so much.
     */
    static final double MILLIS_STEP_SECONDS = 0.0031;

    private PhysicalLimits() {}
}
