package uppaal.replay;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javino.protocol.Payload;
import trace.TraceEvent;

/**
 * Holds the bytes of each packet to what SPEC 2, 5 and 7 say of them, and to what hosts gave and got. What our boards
 * seal is opened if the run's keys are known. Strangers may send anything; it is only remembered.
 */
final class Bytes {
    private static final int MOST_SHOWN = 40;
    /** Of a broadcast that is handed to a host. */
    private static final String NO_ID = "000000";

    private final Opener opener;
    private final Map<String, Desk> desks = new LinkedHashMap<>();
    /** Frames of our boards by origin and nonce, and broadcasts by what they begin with. */
    private final Map<String, Frame> frames = new Recent<>();
    /** What strangers have begun. */
    private final Map<String, Frame> strange = new Recent<>();
    /** Who has sent something with a trailer, and to whom. */
    private final Set<String> trailed = new HashSet<>();
    private int proofs;

    /** @param keys those of the run; null where they are not known */
    Bytes(Keys keys) {
        opener = new Opener(keys, desks.values());
    }

    /** How much was checked, if that took keys. */
    String checked() {
        return !opener.hasKeys() ? "" : ", " + opener.opened() + " messages opened, " + proofs + " proofs";
    }

    /** Text of somebody else's in one short line. */
    static String shown(String text) {
        String line = text.replaceAll("[\\p{Cc}\\p{Zl}\\p{Zp}\\uFFFD]", "?");
        return line.length() <= MOST_SHOWN ? line : line.substring(0, MOST_SHOWN) + "…";
    }

    static String shown(byte[] content) {
        return content == null ? "what nobody knows" : "'" + shown(new String(content, StandardCharsets.UTF_8)) + "'";
    }

    private Desk desk(TraceEvent event) {
        return desk(event.board());
    }

    private Desk desk(String board) {
        return desks.computeIfAbsent(board, Desk::new);
    }

    void reset(TraceEvent event) {
        desk(event).reset(event.seconds());
    }

    void named(TraceEvent event) throws RefusedException {
        Desk desk = desk(event);
        desk.ids.add(event.text("id"));
        if (event.has("epoch")) {
            desk.greetedAt = desk.greetedAt < 0 ? event.seconds() : desk.greetedAt;
            desk.told(HexFormat.fromHexDigits(event.text("epoch")));
        }
    }

    void transmit(TraceEvent event) {
        desk(event).ask(
                new Desk.Asked(event.number("number"), event.text("destination"), content(event)));
    }

    void outcome(TraceEvent event) {
        desk(event).end(event.number("number"));
    }

    /** What the event says was said; null where it does not say that, and without keys it need not. */
    private byte[] content(TraceEvent event) {
        Optional<byte[]> said = event.said();
        if (said.isEmpty() && opener.hasKeys()) {
            throw event.wrong("an event '" + event.name() + "' without 'content'");
        }
        return said.orElse(null);
    }

    /** Somebody begins to send a packet. */
    void begin(TraceEvent event, Payload payload) throws RefusedException {
        Desk desk = desk(event);
        desk.useRadio(event.textOrEmpty("radio"));
        boolean isOwn = desk.ids.contains(payload.origin());
        if (payload.isAcknowledgement()) {
            answer(desk, payload, event.real("start"));
        } else if (!payload.isData()) {
            return;
        } else if (!isOwn) {
            remember(payload, event.real("start"));
        } else if (payload.index() != 0) {
            later(desk, payload);
        } else {
            first(desk, new Frame(payload, event.real("start")), payload);
        }
        Frame cut = isOwn && payload.isFragment() ? desk.cut.get(payload.fragmentId()) : null;
        if (cut != null) {
            order(desk, cut, payload);
        }
        if (event.has("trailer")) {
            trailed.add(payload.origin() + (cut == null ? payload.destination() : cut.destination));
        }
    }

    private static void order(Desk desk, Frame frame, Payload piece) throws RefusedException {
        String wrong = frame.wrongNow(piece);
        if (!wrong.isEmpty()) {
            throw new RefusedException(desk.name + " sends fragment " + piece.index() + " of " + frame + " " + wrong);
        }
        frame.last = piece;
    }

    /** A board of ours sends a frame, or its first piece. */
    private void first(Desk desk, Frame frame, Payload payload) throws RefusedException {
        checkForm(desk, frame, payload);
        Frame known = frame.isSealed() ? frames.get(frame.origin + frame.nonceHex)
                : frame.fragmentId >= 0 ? desk.cut.get(frame.fragmentId) : null;
        if (known != null && known.isSame(frame)) {
            return;
        }
        if (known != null && frame.isSealed()) {
            throw new RefusedException(
                    desk.name + " sends other bytes under the nonce of an earlier message; expected: " + known);
        }
        if (frame.fragmentId < 0 && frame.isBroadcast() && isAgain(desk, frame)) {
            return;
        }
        Desk.Asked asked = opener.asked(desk, frame);
        if (frame.isSealed()) {
            desk.checkNonce(frame,
                    asked.frame != null || opener.hasKeys() ? asked.frame : desk.lastTo(frame.destination));
        }
        if (frame.fragmentId >= 0) {
            desk.checkId(frame);
        }
        desk.take(asked, frame);
        desk.lastBroadcast = frame.isBroadcast() ? frame : desk.lastBroadcast;
        frames.put(frame.origin + (frame.isSealed() ? frame.nonceHex : HexFormat.of().formatHex(frame.first)), frame);
    }

    private static boolean isAgain(Desk desk, Frame frame) {
        return desk.lastBroadcast != null && Arrays.equals(desk.lastBroadcast.bytes, frame.bytes)
                && desk.askedFor(frame.destination).stream().noneMatch(asked -> isOf(asked, frame.content));
    }

    private static boolean isOf(Desk.Asked asked, byte[] content) {
        return asked.content == null || Arrays.equals(asked.content, content);
    }

    private static void checkForm(Desk desk, Frame frame, Payload payload) throws RefusedException {
        String wrong = wrongForm(frame, payload, desk.pieceLength);
        if (!wrong.isEmpty()) {
            throw new RefusedException(desk.name + " sends a " + payload.kind() + " with " + wrong);
        }
    }

    private static String wrongForm(Frame frame, Payload payload, int piece) {
        if (frame.length == 0 || !frame.origin.equals(payload.origin())) {
            return "no header of a frame of its own";
        }
        if (frame.isSealed() && frame.contentLength() < 0) {
            return "no room for nonce and tag";
        }
        if (payload.isFragment() && frame.length <= piece + Frame.HEADER) {
            return "a frame that fits one packet";
        }
        if (payload.isFragment() && frame.first.length != piece) {
            return frame.first.length + " bytes; expected " + piece;
        }
        return payload.isFragment() && payload.asks() && !frame.isUnicast() ? "a wish for an answer, though to many"
                : "";
    }

    /** A board of ours sends a further piece of a frame. */
    private static void later(Desk desk, Payload payload) throws RefusedException {
        Frame frame = desk.cut.get(payload.fragmentId());
        if (frame == null) {
            throw new RefusedException(
                    desk.name + " sends a fragment of a message that it has not begun; expected a first fragment");
        }
        if (payload.asks() && !frame.isUnicast()) {
            throw new RefusedException(desk.name + " asks for an answer to a fragment of a message to many");
        }
        if (payload.index() >= frame.pieces() || !frame.hasPiece(payload.index(), payload.message().toArray())) {
            throw new RefusedException(desk.name + " sends other bytes as fragment " + payload.index() + " of " + frame
                    + "; expected those of the whole that it has sealed and cut");
        }
    }

    /** A stranger begins to send a frame: one of ours again, or anything. */
    private void remember(Payload payload, double start) {
        if (payload.isFragment() && payload.index() != 0) {
            desks.values().stream().filter(desk -> desk.ids.contains(payload.origin()))
                    .map(desk -> desk.cut.get(payload.fragmentId())).filter(Objects::nonNull)
                    // Of one whose bytes are not known a board's own piece is still to be the first that counts.
                    .filter(cut -> cut.isBroadcast() && cut.bytes != null && payload.index() < cut.pieces())
                    .filter(cut -> !cut.hasPiece(payload.index(), payload.message().toArray()))
                    .forEach(cut -> cut.hasOtherPiece = true);
        }
        Frame frame = payload.index() == 0 ? new Frame(payload, start) : null;
        boolean isWhole = frame != null && frame.length != 0
                && (frame.isBroadcast() || frame.contentLength() >= 0 && !frame.nonceHex.isEmpty());
        if (!isWhole) {
            return;
        }
        Frame ours = frame.isSealed() ? frames.get(frame.origin + frame.nonceHex) : null;
        if (ours != null && ours.isSame(frame)) {
            return;
        }
        if (frame.isSealed() && opener.hasKeys() && frame.bytes != null) {
            opener.refresh();
            frame.content = opener.keysOf(frame).stream().flatMap(key -> key.open(frame.bytes).stream()).findFirst()
                    .orElse(null);
            frame.isForged = frame.content == null;
        } else if (frame.isSealed() && desks.values().stream().anyMatch(desk -> desk.ids.contains(frame.origin))) {
            frame.isForged = true; // a first piece that none of our boards has sent
        }
        strange.put(payload.identity(), frame);
    }

    /**
     * A packet has come to a board, perhaps damaged.
     *
     * @param sent as its sender has sent it
     */
    void reach(TraceEvent event, Payload sent) throws RefusedException {
        if (event.has("payload")) {
            Fields.payload(event);
        }
        if (sent.isFragment()) {
            desk(event).pieces.put(Answers.place(sent.origin(), sent.fragmentId(), sent.index()), event.seconds());
        }
    }

    /** A board acknowledges. */
    private void answer(Desk desk, Payload payload, double start) throws RefusedException {
        List<Frame> meant = Stream.of(frames, strange).flatMap(known -> known.values().stream())
                .filter(frame -> Answers.mayMean(payload, frame)).toList();
        List<Frame> proved = !opener.hasKeys() ? meant : proved(payload, meant);
        if (desk.ids.contains(payload.origin())) {
            proofs += !opener.hasKeys() ? 0 : 1;
            Answers.check(desk, payload, start, meant, proved);
            checkParity(desk, payload, proved);
            if (payload.message().length() == Answers.STALE) {
                Answers.checkFloor(desk, payload, proved, frames.values());
            }
        }
        if (payload.message().length() == Answers.PIECES) {
            proved.forEach(frame -> frame.isAnswered = true);
        }
        if (payload.message().length() == Answers.STALE) {
            for (Frame frame : proved) {
                desks.values().stream().filter(sender -> sender.ids.contains(frame.origin))
                        .forEach(sender -> sender.goOnAbove(frame));
            }
        }
    }

    /** A board asks for parity where a packet has come with a trailer: then its sender understands them. */
    private void checkParity(Desk desk, Payload payload, List<Frame> proved) throws RefusedException {
        if (opener.hasKeys() && proved.stream().allMatch(frame -> !trailed.contains(frame.origin + frame.destination)
                && keysOf(frame).stream().anyMatch(key -> Answers.asksParity(key, payload, frame)))) {
            throw new RefusedException(desk.name + " asks for parity (" + proved.get(0)
                    + "); expected that a packet with a trailer comes first");
        }
    }

    private List<SharedKey> keysOf(Frame frame) {
        return frame.key != null ? List.of(frame.key) : opener.keysOf(frame);
    }

    private List<Frame> proved(Payload payload, List<Frame> meant) {
        List<Frame> proved =
                meant.stream().filter(
                        frame -> keysOf(frame).stream().anyMatch(key -> Answers.isProof(key, payload, frame))).toList();
        return proved.isEmpty() && opener.refresh() ? proved(payload, meant) : proved;
    }

    /** A board hands its host a message: what was said, and to whom. */
    void hand(TraceEvent event) throws RefusedException {
        byte[] content = content(event);
        if (content == null) {
            return;
        }
        List<Frame> meant = Stream.of(frames, strange).flatMap(known -> known.values().stream())
                .filter(frame -> isHanded(frame, event)).toList();
        boolean said = meant.stream().anyMatch(frame -> !frame.isForged && (frame.content == null
                || frame.hasOtherPiece || Arrays.equals(frame.content, content)));
        if (!said) {
            String expected = meant.stream().filter(frame -> !frame.isForged).map(frame -> shown(frame.content))
                    .reduce((one, other) -> other).orElse("nothing that any key opens");
            throw new RefusedException(event.board() + " hands its host " + shown(content) + " from "
                    + event.text("origin") + "; expected " + expected);
        }
    }

    private static boolean isHanded(Frame frame, TraceEvent event) {
        return frame.origin.equals(event.text("origin")) && frame.destination.equals(event.text("destination"))
                && event.text("id").equals(frame.isBroadcast() ? NO_ID : Frame.id(frame.nonceHex));
    }
}
