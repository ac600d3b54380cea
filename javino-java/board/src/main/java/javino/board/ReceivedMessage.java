package javino.board;

import javino.protocol.Address;
import javino.protocol.Content;

/**
 * A message from the radio.
 *
 * @param from    the device that sent it.
 * @param to      this device, its group, or all.
 * @param id      0…0xFFFFFF: a message that comes again, to a later run of the host, has the same id (SPEC 7.2); 0 for
 *                each broadcast.
 * @param content the content, opened if it was sealed.
 */
public record ReceivedMessage(Address from, Address to, int id, Content content) {
}
