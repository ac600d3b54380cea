package highway;

/**
 * Something that was seen from outside, as the terminal and the picture tell it.
 *
 * @param seconds emulated time since the boards were switched on.
 * @param who     the address of the device.
 * @param to      the destination of a packet; else empty.
 * @param text    the line, the plain content, the packet's meaning (SPEC 7.3, 11.3), the reason, or the pin with its
 *                level; empty for a sealed packet.
 */
record Observation(double seconds, Kind kind, String who, String to, String text) {

    enum Kind {
        SAYS, WARNS, SENDS, SEALED, HOSTS, ACKS, LOSES, PIN
    }

    /** Without its time: the same is the same again. */
    Observation once() {
        return new Observation(0, kind, who, to, text);
    }
}
