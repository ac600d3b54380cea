package javino.protocol;

import java.util.List;
import java.util.Optional;

/**
 * What a board says of itself when it is greeted (SPEC 4.3, hello and list actions).
 *
 * @param protocolVersion the board's, 1…255; {@link #LEGACY_VERSION} where it speaks the older protocol.
 * @param rfId            its address on the radio, if it has one.
 * @param bootEpoch       the epoch of its nonces, raised in each boot; 0xFFFFFF where none is left, 0 where it is lost.
 * @param firmware        the sketch's name.
 * @param actions         the names of the sketch's actions in its order; none where it speaks the older protocol, which
 * cannot tell.
 */
public record BoardInfo(int protocolVersion, Optional<Address> rfId, int bootEpoch, String firmware,
        List<String> actions) {

    /** In the place of a version: the board speaks the older protocol (SPEC 8), which has no hello. */
    public static final int LEGACY_VERSION = 0;
    /** The last epoch that nonces have; what a board says that has none left is one more. */
    public static final int LAST_EPOCH = 0xFFFFFE;

    private static final int ID_OFFSET = 1;
    private static final int BOOT_EPOCH_OFFSET = ID_OFFSET + Address.LENGTH;
    private static final int FIRMWARE_OFFSET = BOOT_EPOCH_OFFSET + 3;

    static BoardInfo decode(Bytes body) throws ProtocolException {
        Reply.expect(body.length() >= FIRMWARE_OFFSET, "a hello is answered with at least 8 bytes", body);
        Address id = Address.decode(body, ID_OFFSET);
        return new BoardInfo(body.at(0),
                id.equals(Address.SERIAL) ? Optional.empty() : Optional.of(id),
                (int) body.number(BOOT_EPOCH_OFFSET, FIRMWARE_OFFSET),
                body.from(FIRMWARE_OFFSET).text(), List.of());
    }

    /** A board that speaks the older protocol: it tells nothing of itself. */
    public static BoardInfo legacy() {
        return new BoardInfo(LEGACY_VERSION, Optional.empty(), 0, "a sketch with the older Javino library",
                List.of());
    }

    /** Whether it speaks the older protocol, which has percepts and actions, and nothing else. */
    public boolean isLegacy() {
        return protocolVersion == LEGACY_VERSION;
    }

    /** Whether it has keys and no epoch: it seals nothing until it is given one. */
    public boolean hasLostEpoch() {
        return bootEpoch == 0 && !isLegacy();
    }

    /** The same board after its epoch was raised. */
    public BoardInfo withBootEpoch(int epoch) {
        return new BoardInfo(protocolVersion, rfId, epoch, firmware, actions);
    }

    /** The same board after it was given an address. */
    public BoardInfo withRfId(Address id) {
        return new BoardInfo(protocolVersion, Optional.of(id), bootEpoch, firmware, actions);
    }

    /** The same board after it was asked for its actions. */
    public BoardInfo withActions(List<String> names) {
        return new BoardInfo(protocolVersion, rfId, bootEpoch, firmware, List.copyOf(names));
    }
}
