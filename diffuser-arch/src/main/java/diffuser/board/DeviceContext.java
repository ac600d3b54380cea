package diffuser.board;

import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;

import diffuser.gate.TrustLevel;
import diffuser.report.Warnings;

import javino.board.ReceivedMessage;

/**
 * The agent around a device.
 *
 * @param agent    its name.
 * @param board    the name of its board.
 * @param messages takes its messages, with the trust level of each sender.
 * @param hosts    takes messages of hosts.
 * @param warnings tells its user what went wrong.
 * @param wake     ends its sleep.
 * @param printed  is told what the sketch prints.
 * @param keyService agrees on keys, if that library is there.
 * @param portWithSensors whether it believes whether the board is there only once its sensors were opened.
 */
public record DeviceContext(String agent, String board, BiConsumer<ReceivedMessage, TrustLevel> messages,
        HostMessages hosts, Warnings warnings, Runnable wake, Consumer<String> printed,
        Optional<KeyService> keyService, boolean portWithSensors) {
}
