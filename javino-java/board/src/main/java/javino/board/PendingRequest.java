package javino.board;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import javino.JavinoException;
import javino.protocol.BoardInfo;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;
import javino.protocol.Request;
import javino.protocol.Status;

/**
 * A request that waits for the board.
 *
 * @param description for error lines.
 * @param source      makes the request when its turn has come.
 * @param reader      makes the result of the reply.
 * @param result      completed on the session's thread.
 * @param expiry      when it fails if the board is still offline.
 * @param isTransmission whether it waits where the board has no room for it.
 */
record PendingRequest<T>(String description, Source source, Reader<T> reader, CompletableFuture<T> result,
        Deadline expiry, boolean isTransmission) {

    /** Makes a request for the board as it is then. */
    interface Source {
        Request request(BoardInfo board) throws RequestFailedException;
    }

    /** Makes a result of an OK reply. */
    interface Reader<T> {
        T read(Reply reply) throws ProtocolException;
    }

    /** @param said what the sketch has printed before it refused an action. */
    void answer(Reply reply, Optional<String> said) throws ProtocolException {
        if (reply.status() != Status.OK) {
            result.completeExceptionally(new RequestFailedException(description, reply.status(), said));
        } else {
            result.complete(reader.read(reply));
        }
    }

    void fail(JavinoException cause) {
        result.completeExceptionally(cause);
    }

    void failOffline(String why) {
        fail(new BoardOfflineException(description, why));
    }
}
