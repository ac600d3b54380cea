package diffuser.board;

/** The agent's use of a board's sensors. */
public enum SensorMode {
    /** They are read, and are beliefs. */
    OPEN,
    /** They are not read; what was believed of them last stays believed. */
    HELD,
    /** They are not read, and nothing is believed of them. */
    BLOCKED
}
