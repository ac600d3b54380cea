package javino.board;

import javino.protocol.Address;
import javino.protocol.Content;

/**
 * A message from the radio.
 *
 * @param from    the device that sent it.
 * @param to      this device, its group, or all.
 * @param content what it said.
 */
public record ReceivedMessage(Address from, Address to, Content content) {
}
