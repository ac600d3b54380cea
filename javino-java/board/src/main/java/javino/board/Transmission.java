package javino.board;

import java.util.concurrent.CompletableFuture;
import javino.protocol.Outcome;

/**
 * A message that a board was asked to transmit.
 *
 * @param taken completes when the board has accepted the message, and fails as any request of {@link Board}.
 * @param end   completes, after {@code taken}, with the outcome. It is UNDELIVERED for each kind of message if the
 *              board was reset or lost before it told the outcome, or if the session was closed. Fails if {@code taken}
 *              fails.
 */
public record Transmission(CompletableFuture<Void> taken, CompletableFuture<Outcome> end) {
}
