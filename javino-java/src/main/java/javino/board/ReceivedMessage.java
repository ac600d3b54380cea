package javino.board;

import javino.protocol.Address;
import javino.protocol.Content;

/**
 * A message from the radio.
 *
 * @param from    the device that sent it.
 * @param to      this device, its group, or all.
 * @param id      0…0xFFFFFF: a message that comes once more, to a later run of the host, has the same (SPEC 7.2); of
 *                a broadcast 0, which tells nothing.
 * @param content what it said.
 */
public record ReceivedMessage(Address from, Address to, int id, Content content) {
}
