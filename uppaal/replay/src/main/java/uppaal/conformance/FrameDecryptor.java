package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javino.protocol.Payload;

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

    /** Whether there are other keys now. */
    boolean refresh() {
        return keys.isPresent() && keys.get().refresh();
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
    void check(String board, Frame frame, BoardFrames.Outgoing message) throws RefusedException {
        byte[] content = message.content;
        String what = board + " sends a message to " + frame.destination
                + (frame.nonce.isEmpty() ? "" : " under nonce " + frame.nonce);
        require(message.destination.equals(frame.destination), what, "" + message.destination);
        if (content == null) {
            return;
        }
        require(content.length == frame.contentLength(),
                what + " with a content of " + frame.contentLength() + " bytes", "" + content.length);
        if (!frame.isSealed()) {
            frame.bytes = SharedKey.join(SharedKey.header(frame.destination, frame.origin, content.length), content);
            require(begins(frame.bytes, frame), what + " that says " + Fields.shown(frame.content),
                    Fields.shown(content));
        } else {
            require(content.length == 0 || !isInTheClear(frame, content),
                    what + " in the clear: " + Fields.shown(content), "it sealed");
            if (keys.isPresent() && !isOpened(frame, content) && !(refresh() && isOpened(frame, content))) {
                throw new RefusedException(what + why(frame, content), Fields.shown(content));
            }
        }
        frame.content = content;
    }

    private static boolean begins(byte[] whole, Frame frame) {
        return Arrays.equals(Arrays.copyOf(whole, frame.first.length), frame.first);
    }

    private static boolean isInTheClear(Frame frame, byte[] content) {
        return Stream.of(Frame.HEADER, Frame.CONTENT_AT).anyMatch(from -> {
            int length = Math.min(content.length, frame.first.length - from);
            return length > 0 && Arrays.equals(frame.first, from, from + length, content, 0, length);
        });
    }

    private boolean isOpened(Frame frame, byte[] content) {
        for (SharedKey key : keysOf(frame)) {
            byte[] whole = key.seal(frame, content);
            if (begins(whole, frame)) {
                frame.bytes = whole;
                frame.key = key;
                opened++;
                return true;
            }
        }
        return false;
    }

    private String why(Frame frame, byte[] content) {
        List<SharedKey> shared = keysOf(frame);
        for (SharedKey key : shared) {
            Optional<byte[]> said = frame.bytes == null ? Optional.empty() : key.open(frame.bytes);
            if (said.isPresent()) {
                return " that says " + Fields.shown(said.get());
            }
            int end = Math.min(frame.length - Payload.TAG_LENGTH, frame.first.length);
            if (Arrays.equals(key.seal(frame, content), 0, end, frame.first, 0, end)) {
                return " with a wrong tag";
            }
        }
        return shared.isEmpty() ? ", and no key was given for " + frame.origin + " and " + frame.destination
                : " that opens under none of the " + shared.size() + " keys for it";
    }

    /** Opens what somebody has sent that is none of our boards. */
    void open(Frame frame) {
        if (keys.isPresent() && frame.isSealed() && frame.bytes != null) {
            refresh();
            frame.content = keysOf(frame).stream().flatMap(key -> key.open(frame.bytes).stream()).findFirst()
                    .orElse(null);
            frame.isForged = frame.content == null;
        }
    }
}
