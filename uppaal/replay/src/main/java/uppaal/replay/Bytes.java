package uppaal.replay;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Holds the bytes of each packet to what SPEC 2, 5 and 7 say of them, and to what hosts gave and got. What our boards seal
 * is opened if the run's keys are known. Strangers may send anything; it is only remembered.
 */
final class Bytes {
    /** Packets of which somebody may still hear the end. */
    private static final int PACKETS = 64;
    /** How far apart the starts of a packet may lie that its sender and a receiver see, in seconds. */
    private static final double LATENESS = 0.005;
    private static final int MOST_SHOWN = 40;
    /** Of a broadcast that is handed to a host. */
    private static final String NO_ID = "000000";

    private record Packet(String board, Payload payload, double start) {}

    private final Keys keys;
    private final Map<String, Desk> desks = new LinkedHashMap<>();
    /** Frames of our boards by origin and nonce, and broadcasts by what they begin with. */
    private final Map<String, Frame> frames = new Recent<>();
    /** What strangers have begun. */
    private final Map<String, Frame> strange = new Recent<>();
    private final Deque<Packet> packets = new ArrayDeque<>();
    private int opened;
    private int proofs;

    /** @param keys those of the run; null where they are not known */
    Bytes(Keys keys) {
        this.keys = keys;
    }

    /** How much was checked, if that took keys. */
    String checked() {
        return keys == null ? "" : ", " + opened + " messages opened, " + proofs + " proofs";
    }

    /** Text of somebody else's in one short line. */
    static String shown(String text) {
        String line = text.replaceAll("\\p{Cntrl}", "?");
        return line.length() <= MOST_SHOWN ? line : line.substring(0, MOST_SHOWN) + "…";
    }

    static String shown(byte[] content) {
        return content == null ? "what nobody knows" : "'" + shown(new String(content, StandardCharsets.UTF_8)) + "'";
    }

    private Desk desk(Event event) {
        return desk(event.board());
    }

    private Desk desk(String board) {
        return desks.computeIfAbsent(board, Desk::new);
    }

    void reset(Event event) {
        desk(event).reset(event.seconds());
    }

    void named(Event event) throws RefusedException {
        Desk desk = desk(event);
        desk.ids.add(event.text("id"));
        if (event.fields().has("epoch")) {
            desk.greetedAt = desk.greetedAt < 0 ? event.seconds() : desk.greetedAt;
            desk.told(HexFormat.fromHexDigits(event.text("epoch")));
        }
    }

    void transmit(Event event) {
        desk(event).ask(new Desk.Asked(event.text("destination"), content(event)));
    }

    /** What the event says was said; null where it does not say that, and without keys it need not. */
    private byte[] content(Event event) {
        if (event.fields().has("hex")) {
            return HexFormat.of().parseHex(event.text("hex"));
        }
        return keys == null && !event.fields().has("content") ? null
                : event.text("content").getBytes(StandardCharsets.UTF_8);
    }

    /** Somebody begins to send a packet. */
    void begin(Event event) throws RefusedException {
        Payload payload = Payload.of(event);
        Desk desk = desk(event);
        Fields.check(event, payload);
        packets.add(new Packet(desk.name, payload, event.number("start")));
        if (packets.size() > PACKETS) {
            packets.remove();
        }
        if (payload.isAcknowledgement()) {
            answer(desk, payload, event.number("start"));
        } else if (!payload.isData()) {
            return;
        } else if (!desk.isNamed()) {
            remember(payload, event.number("start"));
        } else if (payload.index() != 0) {
            later(desk, payload);
        } else {
            first(desk, new Frame(payload, event.number("start")), payload);
        }
    }

    /** A board of ours sends a frame, or its first piece. */
    private void first(Desk desk, Frame frame, Payload payload) throws RefusedException {
        checkForm(desk, frame, payload);
        Frame known = frame.isSealed() ? frames.get(frame.origin + frame.nonceHex())
                : frame.pieceId >= 0 ? desk.cut.get(frame.pieceId) : null;
        if (known != null && known.isSame(frame)) {
            return;
        }
        if (known != null && frame.isSealed()) {
            throw new RefusedException(
                    desk.name + " sends other bytes under the nonce of an earlier message; expected: " + known);
        }
        if (frame.pieceId < 0 && frame.isBroadcast() && isAgain(desk, frame)) {
            return;
        }
        Desk.Asked asked = asked(desk, frame);
        if (frame.isSealed()) {
            desk.checkNonce(frame, asked.frame);
        }
        if (frame.pieceId >= 0) {
            desk.checkId(frame);
        }
        desk.take(asked, frame);
        desk.lastBroadcast = frame.isBroadcast() ? frame : desk.lastBroadcast;
        frames.put(frame.origin + (frame.isSealed() ? frame.nonceHex() : HexFormat.of().formatHex(frame.first)), frame);
    }

    private static boolean isAgain(Desk desk, Frame frame) {
        return desk.lastBroadcast != null && Arrays.equals(desk.lastBroadcast.bytes, frame.bytes)
                && desk.askedFor(frame.destination).stream().noneMatch(asked -> isOf(asked, frame.content));
    }

    private static boolean isOf(Desk.Asked asked, byte[] content) {
        return asked.content == null || Arrays.equals(asked.content, content);
    }

    private static void checkForm(Desk desk, Frame frame, Payload payload) throws RefusedException {
        String wrong = frame.length == 0 || !frame.origin.equals(payload.origin()) ? "no header of a frame of its own"
                : frame.isSealed() && frame.contentLength() < 0 ? "no room for nonce and tag"
                        : payload.isPiece() && frame.length <= Payload.PART + Frame.HEADER
                                ? "a frame that fits one packet"
                                : payload.isPiece() && frame.first.length != Payload.PART
                                        ? frame.first.length + " bytes, not 67"
                                        : payload.isPiece() && payload.asks() && !frame.isUnicast()
                                                ? "a wish for an answer, though to many"
                                                : "";
        if (!wrong.isEmpty()) {
            throw new RefusedException(desk.name + " sends a " + payload.kind() + " with " + wrong);
        }
    }

    /** A board of ours sends a further piece of a frame. */
    private static void later(Desk desk, Payload payload) throws RefusedException {
        Frame frame = desk.cut.get(payload.pieceId());
        if (frame == null) {
            throw new RefusedException(
                    desk.name + " sends a piece of a message that it has not begun; expected a first piece");
        }
        if (payload.asks() && !frame.isUnicast()) {
            throw new RefusedException(desk.name + " asks for an answer to a piece of a message to many");
        }
        if (payload.index() >= frame.pieces() || !frame.hasPiece(payload.index(), payload.message())) {
            throw new RefusedException(desk.name + " sends other bytes as piece " + payload.index() + " of " + frame
                    + "; expected those of the whole that it has sealed and cut");
        }
    }

    /** Which of the messages that its host wants to be sent this is. Finds out all about the frame. */
    private Desk.Asked asked(Desk desk, Frame frame) throws RefusedException {
        List<Desk.Asked> able = desk.askedFor(frame.destination);
        if (able.isEmpty()) {
            throw new RefusedException(desk.name + " sends a message to " + frame.destination
                    + "; expected that its host asks for it first");
        }
        for (Desk.Asked asked : able) {
            if (asked.content != null && asked.content.length > 0 && isInTheClear(frame, asked.content)) {
                throw new RefusedException(desk.name + " sends a message to " + frame.destination
                        + " in the clear: " + shown(asked.content) + "; expected it sealed");
            }
        }
        List<SharedKey> shared = frame.isSealed() && keys != null ? keysOf(frame) : List.of();
        Optional<Desk.Asked> found = able.stream().filter(asked -> isOf(asked, frame, shared)).findFirst();
        if (found.isEmpty() && keys != null && frame.isSealed() && keys.refresh()) {
            return asked(desk, frame);
        }
        if (found.isPresent()) {
            opened += frame.key == null ? 0 : 1;
            return found.get();
        }
        throw wrong(desk, frame, able, shared);
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
            byte[] header = Payload.header(frame.destination, frame.origin, asked.content.length);
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

    private List<SharedKey> keysOf(Frame frame) {
        return keys.of(addresses(frame.origin), addresses(frame.destination));
    }

    /** What else the board with this address was called. */
    private Collection<String> addresses(String address) {
        return desks.values().stream().filter(desk -> desk.ids.contains(address)).findFirst().map(desk -> desk.ids)
                .orElse(Set.of(address));
    }

    /** Why a frame is none of the messages that the host has asked for. */
    private RefusedException wrong(Desk desk, Frame frame, List<Desk.Asked> able, List<SharedKey> shared) {
        Desk.Asked next = able.get(0);
        String why = " that opens under none of the " + shared.size() + " keys for it";
        if (able.stream().noneMatch(asked -> asked.content.length == frame.contentLength())) {
            why = " with a content of " + frame.contentLength() + " bytes; expected " + next.content.length;
        } else if (frame.isBroadcast()) {
            why = " that says " + shown(frame.content) + "; expected " + shown(next.content);
        } else if (shared.isEmpty()) {
            why = ", and no key was given for " + frame.origin + " and " + frame.destination;
        } else {
            for (SharedKey key : shared) {
                Optional<byte[]> said = frame.bytes == null ? Optional.empty() : key.open(frame.bytes);
                if (said.isPresent()) {
                    why = " that says " + shown(said.get()) + "; expected " + shown(next.content);
                }
                if (able.stream().anyMatch(asked -> hasWrongTag(frame, key, asked.content))) {
                    why = " with a wrong tag; expected that of " + shown(next.content);
                }
            }
        }
        return new RefusedException(desk.name + " sends a message to " + frame.destination
                + (frame.isSealed() ? " under nonce " + frame.nonceHex() : "") + why);
    }

    private static boolean hasWrongTag(Frame frame, SharedKey key, byte[] content) {
        byte[] right = key.seal(frame.destination, frame.origin, frame.nonce(), content);
        int end = Math.min(frame.length - SharedKey.TAG, frame.first.length);
        return right.length == frame.length && Arrays.equals(right, 0, end, frame.first, 0, end);
    }

    /** A stranger begins to send a frame: one of ours again, or anything. */
    private void remember(Payload payload, double start) {
        Frame frame = payload.index() == 0 ? new Frame(payload, start) : null;
        if (frame == null || frame.length == 0 || frame.isSealed() && frame.contentLength() < 0) {
            return;
        }
        Frame ours = frame.isSealed() ? frames.get(frame.origin + frame.nonceHex()) : null;
        if (ours != null && ours.isSame(frame)) {
            return;
        }
        if (frame.isSealed() && keys != null && frame.bytes != null) {
            keys.refresh();
            frame.content = keysOf(frame).stream().flatMap(key -> key.open(frame.bytes).stream()).findFirst()
                    .orElse(null);
            frame.isForged = frame.content == null;
        }
        strange.put(payload.identity(), frame);
    }

    /** A packet has come to a board, perhaps damaged. */
    void reach(Event event) throws RefusedException {
        if (event.fields().has("payload")) {
            Fields.check(event, Payload.of(event));
        }
        double start = event.number("start");
        String from = event.textOrEmpty("from");
        Optional<Payload> piece = packets.stream().filter(packet -> Math.abs(packet.start() - start) < LATENESS
                && (from.isEmpty() || packet.board().equals(from))).map(Packet::payload).filter(Payload::isPiece)
                .findFirst();
        piece.ifPresent(payload -> desk(event).pieces
                .put(Answers.place(payload.origin(), payload.pieceId(), payload.index()), event.seconds()));
    }

    /** A board acknowledges. */
    private void answer(Desk desk, Payload payload, double start) throws RefusedException {
        List<Frame> meant = Stream.of(frames, strange).flatMap(known -> known.values().stream())
                .filter(frame -> Answers.mayMean(payload, frame)).toList();
        List<Frame> proved = keys == null ? meant : proved(payload, meant);
        if (desk.isNamed()) {
            proofs += keys == null ? 0 : 1;
            Answers.check(desk, payload, start, meant, proved);
            if (payload.message().length == Answers.STALE) {
                Answers.checkFloor(desk, payload, proved, frames.values());
            }
        }
        if (payload.message().length == Answers.STALE) {
            for (Frame frame : proved) {
                desks.values().stream().filter(sender -> sender.ids.contains(frame.origin))
                        .forEach(sender -> sender.goOnAbove(frame));
            }
        }
    }

    private List<Frame> proved(Payload payload, List<Frame> meant) {
        List<Frame> proved = meant.stream().filter(frame -> (frame.key != null ? List.of(frame.key) : keysOf(frame))
                .stream().anyMatch(key -> Answers.isProof(key, payload, frame))).toList();
        return proved.isEmpty() && keys.refresh() ? proved(payload, meant) : proved;
    }

    /** A board hands its host a message: what was said, and to whom. */
    void hand(Event event) throws RefusedException {
        byte[] content = content(event);
        if (content == null) {
            return;
        }
        List<Frame> meant = Stream.of(frames, strange).flatMap(known -> known.values().stream())
                .filter(frame -> isHanded(frame, event)).toList();
        boolean said = meant.stream().anyMatch(frame -> !frame.isForged
                && (frame.content == null || Arrays.equals(frame.content, content)));
        if (!said) {
            String expected = meant.stream().filter(frame -> !frame.isForged).map(frame -> shown(frame.content))
                    .reduce((one, other) -> other).orElse("nothing that any key opens");
            throw new RefusedException(event.board() + " hands its host " + shown(content) + " from "
                    + event.text("origin") + "; expected " + expected);
        }
    }

    private static boolean isHanded(Frame frame, Event event) {
        String nonce = frame.nonceHex();
        return frame.origin.equals(event.text("origin")) && frame.destination.equals(event.text("destination"))
                && event.text("id").equals(frame.isBroadcast() ? NO_ID : nonce.substring(4, 6) + nonce.substring(8));
    }
}
