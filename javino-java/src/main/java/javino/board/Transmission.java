package javino.board;

import java.util.concurrent.CompletableFuture;
import javino.protocol.Outcome;

/**
 * A message that a board was asked to transmit.
 *
 * @param taken completes when the board has taken the message over, and fails as any request of {@link Board}.
 * @param end   completes, after {@code taken}, with how the message ended: UNDELIVERED also, whatever it was, where the
 *              board was reset or lost before it told, or the session was closed. Fails as {@code taken} where that fails.
 */
public record Transmission(CompletableFuture<Void> taken, CompletableFuture<Outcome> end) {
}
