package uppaal.replay;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javino.protocol.Payload;

/** Finds which of its host's messages a board has put into a frame, with the run's keys or without. */
final class Opener {
    private final Keys keys;
    private final Collection<Desk> desks;
    private int opened;

    /**
     * @param keys those of the run; null where they are not known
     * @param desks of all boards
     */
    Opener(Keys keys, Collection<Desk> desks) {
        this.keys = keys;
        this.desks = desks;
    }

    boolean hasKeys() {
        return keys != null;
    }

    /** How many messages were opened. */
    int opened() {
        return opened;
    }

    /** @return whether there are other keys now. */
    boolean refresh() {
        return keys.refresh();
    }

    /** Which of the messages that its host wants to be sent this is. Finds out all about the frame. */
    Desk.Asked asked(Desk desk, Frame frame) throws RefusedException {
        List<Desk.Asked> able = desk.askedFor(frame.destination);
        if (able.isEmpty()) {
            throw new RefusedException(desk.name + " sends a message to " + frame.destination
                    + "; expected that its host asks for it first");
        }
        for (Desk.Asked asked : able) {
            if (asked.content != null && asked.content.length > 0 && isInTheClear(frame, asked.content)) {
                throw new RefusedException(desk.name + " sends a message to " + frame.destination
                        + " in the clear: " + Bytes.shown(asked.content) + "; expected it sealed");
            }
        }
        List<SharedKey> shared = frame.isSealed() && keys != null ? keysOf(frame) : List.of();
        Optional<Desk.Asked> found = able.stream().filter(asked -> isOf(asked, frame, shared)).findFirst();
        if (found.isEmpty() && keys != null && frame.isSealed() && keys.refresh()) {
            return asked(desk, frame);
        }
        if (found.isPresent()) {
            opened += frame.key == null ? 0 : 1;
            if (frame.isSealed() && keys == null && able.stream().anyMatch(other -> isAsLong(other, found.get()))) {
                frame.content = null;
            }
            return found.get();
        }
        throw wrong(desk, frame, able, shared);
    }

    /** Whether two messages differ, though a sealed frame does not show which of them it is. */
    private static boolean isAsLong(Desk.Asked one, Desk.Asked other) {
        return one.content == null || other.content == null
                || one.content.length == other.content.length && !Arrays.equals(one.content, other.content);
    }

    private static boolean isInTheClear(Frame frame, byte[] content) {
        return frame.isSealed() && Stream.of(Frame.HEADER, Frame.CONTENT).anyMatch(from -> {
            int length = Math.min(content.length, frame.first.length - from);
            return length > 0 && Arrays.equals(frame.first, from, from + length, content, 0, length);
        });
    }

    /** Whether a frame is what is made of a message. Without keys only its length tells. */
    private boolean isOf(Desk.Asked asked, Frame frame, List<SharedKey> shared) {
        if (asked.content == null || frame.isSealed() && keys == null) {
            frame.content = asked.content;
            return asked.content == null || asked.content.length == frame.contentLength();
        }
        if (asked.content.length != frame.contentLength()) {
            return false;
        }
        if (frame.isBroadcast()) {
            byte[] header = SharedKey.header(frame.destination, frame.origin, asked.content.length);
            return is(frame, SharedKey.join(header, asked.content), null, asked.content);
        }
        return shared.stream().anyMatch(key -> is(frame,
                key.seal(frame.destination, frame.origin, frame.nonce(), asked.content), key, asked.content));
    }

    private static boolean is(Frame frame, byte[] whole, SharedKey key, byte[] content) {
        if (!Arrays.equals(whole, 0, frame.first.length, frame.first, 0, frame.first.length)) {
            return false;
        }
        frame.bytes = whole;
        frame.key = key;
        frame.content = content;
        return true;
    }

    List<SharedKey> keysOf(Frame frame) {
        return keys.of(addresses(frame.origin), addresses(frame.destination));
    }

    /** What else the board with this address was called. */
    private Collection<String> addresses(String address) {
        return desks.stream().filter(desk -> desk.ids.contains(address)).findFirst().map(desk -> desk.ids)
                .orElse(Set.of(address));
    }

    /** Why a frame is none of the messages that the host has asked for. */
    private RefusedException wrong(Desk desk, Frame frame, List<Desk.Asked> able, List<SharedKey> shared) {
        Desk.Asked next = able.get(0);
        String why = " that opens under none of the " + shared.size() + " keys for it";
        if (able.stream().noneMatch(asked -> asked.content.length == frame.contentLength())) {
            why = " with a content of " + frame.contentLength() + " bytes; expected " + next.content.length;
        } else if (frame.isBroadcast()) {
            why = " that says " + Bytes.shown(frame.content) + "; expected " + Bytes.shown(next.content);
        } else if (shared.isEmpty()) {
            why = ", and no key was given for " + frame.origin + " and " + frame.destination;
        } else {
            for (SharedKey key : shared) {
                Optional<byte[]> said = frame.bytes == null ? Optional.empty() : key.open(frame.bytes);
                if (said.isPresent()) {
                    why = " that says " + Bytes.shown(said.get()) + "; expected " + Bytes.shown(next.content);
                }
                if (able.stream().anyMatch(asked -> hasWrongTag(frame, key, asked.content))) {
                    why = " with a wrong tag; expected that of " + Bytes.shown(next.content);
                }
            }
        }
        return new RefusedException(desk.name + " sends a message to " + frame.destination
                + (frame.isSealed() ? " under nonce " + frame.nonceHex : "") + why);
    }

    private static boolean hasWrongTag(Frame frame, SharedKey key, byte[] content) {
        byte[] right = key.seal(frame.destination, frame.origin, frame.nonce(), content);
        int end = Math.min(frame.length - Payload.TAG_LENGTH, frame.first.length);
        return right.length == frame.length && Arrays.equals(right, 0, end, frame.first, 0, end);
    }
}
