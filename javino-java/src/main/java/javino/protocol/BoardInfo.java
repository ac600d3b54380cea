package javino.protocol;

import java.util.Optional;

/**
 * What a board says of itself when it is greeted (SPEC 4.3, hello).
 *
 * @param protocolVersion the board's, 0…255.
 * @param rfId            its address on the radio, if it has one.
 * @param bootCount       how often it booted, 0…0xFFFFFF; also the epoch of its nonces.
 * @param firmware        the sketch's name.
 */
public record BoardInfo(int protocolVersion, Optional<Address> rfId, int bootCount, String firmware) {

    private static final int ID_OFFSET = 1;
    private static final int BOOT_COUNT_OFFSET = ID_OFFSET + Address.LENGTH;
    private static final int FIRMWARE_OFFSET = BOOT_COUNT_OFFSET + 3;

    static BoardInfo decode(Bytes body) throws ProtocolException {
        Reply.expect(body.length() >= FIRMWARE_OFFSET, "a hello is answered with at least 8 bytes", body);
        Address id = Address.decode(body, ID_OFFSET);
        return new BoardInfo(body.at(0),
                id.equals(Address.SERIAL) ? Optional.empty() : Optional.of(id),
                (int) body.number(BOOT_COUNT_OFFSET, FIRMWARE_OFFSET),
                body.from(FIRMWARE_OFFSET).text());
    }

    /** The same board after it was given an address. */
    public BoardInfo withRfId(Address id) {
        return new BoardInfo(protocolVersion, Optional.of(id), bootCount, firmware);
    }
}
