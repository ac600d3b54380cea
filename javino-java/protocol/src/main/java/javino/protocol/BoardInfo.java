package javino.protocol;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The facts that a board tells of itself when it is greeted (SPEC 4.3, hello and list actions).
 *
 * @param protocolVersion the board's, 1…255; {@link #LEGACY_VERSION} where it speaks the older protocol.
 * @param rfId            its address on the radio, if it has one.
 * @param bootEpoch       the epoch of its nonces, raised in each boot; 0xFFFFFF where none is left, 0 where it is lost,
 *                        or where the board has no memory.
 * @param capabilities    its capabilities; none where it speaks the older protocol.
 * @param firmware        the sketch's name.
 * @param actions         the names of the sketch's actions in its order; none where it speaks the older protocol, which
 * cannot tell.
 */
public record BoardInfo(int protocolVersion, Optional<Address> rfId, int bootEpoch, Set<Capability> capabilities,
        String firmware, List<String> actions) {

    /** A value in place of a version: the board speaks the older protocol (SPEC 8), which has no hello. */
    public static final int LEGACY_VERSION = 0;
    /** The last epoch that nonces have; a board that has none left tells one more. */
    public static final int LAST_EPOCH = 0xFFFFFE;

    private static final int ID_OFFSET = 1;
    private static final int BOOT_EPOCH_OFFSET = ID_OFFSET + Address.LENGTH;
    private static final int CAPABILITIES_OFFSET = BOOT_EPOCH_OFFSET + 3;
    /** Such a byte in the place of the capabilities begins the name. */
    private static final int LEAST_OF_NAME = 0x20;

    static BoardInfo decode(Bytes body) throws ProtocolException {
        Reply.expect(body.length() >= CAPABILITIES_OFFSET, "a hello is answered with at least 8 bytes", body);
        Address id = Address.decode(body, ID_OFFSET);
        Bytes rest = body.from(CAPABILITIES_OFFSET);
        boolean earlier = rest.length() == 0 || rest.at(0) >= LEAST_OF_NAME;
        return new BoardInfo(body.at(0), id.equals(Address.SERIAL) ? Optional.empty() : Optional.of(id),
                (int) body.number(BOOT_EPOCH_OFFSET, CAPABILITIES_OFFSET),
                earlier ? Capability.OF_EARLIER_LIBRARY : Capability.decode(rest.at(0)),
                rest.from(earlier ? 0 : 1).text(), List.of());
    }

    /** A board that speaks the older protocol: it tells nothing of itself. */
    public static BoardInfo legacy() {
        return new BoardInfo(LEGACY_VERSION, Optional.empty(), 0, Set.of(),
                "a sketch with the older Javino library", List.of());
    }

    /** Whether it speaks the older protocol, which has percepts and actions, and nothing else. */
    public boolean isLegacy() {
        return protocolVersion == LEGACY_VERSION;
    }

    /** Whether it has a radio: without one it has neither address nor keys. */
    public boolean hasRadio() {
        return capabilities.contains(Capability.RADIO);
    }

    /** Whether its sketch left out all that needs more than sealed unicasts. */
    public boolean hasUnicastsOnly() {
        return capabilities.contains(Capability.UNICASTS_ONLY);
    }

    /** Whether its sketch was built with an earlier library of this protocol, or with the older protocol. */
    public boolean isOfEarlierLibrary() {
        return !capabilities.contains(Capability.SAYS_TAKEN);
    }

    /** Whether it counts the time that its radio sends. */
    public boolean countsAirtime() {
        return hasRadio() && !isOfEarlierLibrary();
    }

    /** Whether it has keys and no epoch: it seals nothing until it is given one. */
    public boolean hasLostEpoch() {
        return bootEpoch == 0 && capabilities.contains(Capability.MEMORY);
    }

    /** The same board after its epoch was raised. */
    public BoardInfo withBootEpoch(int epoch) {
        return new BoardInfo(protocolVersion, rfId, epoch, capabilities, firmware, actions);
    }

    /** The same board after it was given an address. */
    public BoardInfo withRfId(Address id) {
        return new BoardInfo(protocolVersion, Optional.of(id), bootEpoch, capabilities, firmware, actions);
    }

    /** The same board after it was asked for its actions. */
    public BoardInfo withActions(List<String> names) {
        return new BoardInfo(protocolVersion, rfId, bootEpoch, capabilities, firmware, List.copyOf(names));
    }
}
