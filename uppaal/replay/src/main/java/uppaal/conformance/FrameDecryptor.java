package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import javino.protocol.Bytes;

/** Compares frames with what hosts wanted to be sent, with the run's keys or without. */
final class FrameDecryptor {
    private final Optional<Keys> keys;
    private final Collection<BoardFrames> boards;
    private int opened;

    /** @param boards all of the run */
    FrameDecryptor(Optional<Keys> keys, Collection<BoardFrames> boards) {
        this.keys = keys;
        this.boards = boards;
    }

    boolean hasKeys() {
        return keys.isPresent();
    }

    /** How many messages were opened. */
    int opened() {
        return opened;
    }

    /** Those that may have sealed a frame. */
    List<SharedKey> keysOf(Frame frame) {
        return frame.key != null ? List.of(frame.key) : keys.isEmpty() || !frame.isSealed() ? List.of()
                : keys.get().of(addresses(frame.origin), addresses(frame.destination));
    }

    /** What else the board with this address was called. */
    private Collection<String> addresses(String address) {
        return boards.stream().filter(board -> board.ids.contains(address)).findFirst().map(board -> board.ids)
                .orElse(Set.of(address));
    }

    /** A frame must be what is made of its message, as far as its first packet shows. Finds out all about it. */
    void check(String board, BoardFrames.Outgoing message) throws RefusedException {
        Frame frame = message.frame;
        Bytes content = message.content;
        String what = board + " sends a message to " + frame.destination
                + (frame.nonce.isEmpty() ? "" : " under nonce " + frame.nonce);
        require(message.destination.equals(frame.destination), what, message.destination);
        if (content == null) {
            return;
        }
        require(content.length() == frame.contentLength(),
                what + " with a content of " + frame.contentLength() + " bytes", "" + content.length());
        if (frame.isSealed()) {
            require(content.length() == 0 || !isInTheClear(frame.first(), content),
                    what + " in the clear: " + Fields.shown(content), "it sealed");
            require(!hasKeys() || isOpened(frame, content), what + why(frame), Fields.shown(content));
        } else {
            byte[] header = SharedKey.header(frame.destination, frame.origin, content.length());
            require(frame.isWhole(Bytes.join(Bytes.copyOf(header), content)),
                    what + " that says " + Fields.shown(frame.content), Fields.shown(content));
        }
        frame.content = content;
    }

    private static boolean isInTheClear(Bytes first, Bytes content) {
        return IntStream.of(Frame.HEADER, Frame.CONTENT_AT).filter(from -> from < first.length()).anyMatch(from -> {
            int length = Math.min(content.length(), first.length() - from);
            return first.slice(from, from + length).equals(content.slice(0, length));
        });
    }

    private boolean isOpened(Frame frame, Bytes content) {
        frame.key = keysOf(frame).stream().filter(key -> frame.isWhole(key.seal(frame, content))).findFirst()
                .orElse(null);
        opened += frame.key == null ? 0 : 1;
        return frame.key != null;
    }

    private String why(Frame frame) {
        int shared = keysOf(frame).size();
        return said(frame).map(said -> " that says " + Fields.shown(said)).orElse(shared == 0
                ? ", and no key was given for " + frame.origin + " and " + frame.destination
                : " that opens under none of the " + shared + " keys for it");
    }

    /** What a frame in one packet says, if a key opens it. */
    private Optional<Bytes> said(Frame frame) {
        return frame.isCut() ? Optional.empty()
                : keysOf(frame).stream().flatMap(key -> key.open(frame.first().toArray()).stream()).findFirst()
                        .map(Bytes::copyOf);
    }

    /** Opens what somebody has sent whose host did not tell what. */
    void open(Frame frame) {
        if (frame.isSealed()) {
            frame.content = said(frame).orElse(null);
            frame.isForged = hasKeys() && !frame.isCut() && frame.content == null;
        }
    }
}
