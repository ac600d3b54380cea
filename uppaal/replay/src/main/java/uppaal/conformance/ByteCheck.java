package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Payload;
import trace.TraceEvent;

/**
 * Holds the bytes of each packet to what SPEC 2, 5 and 7 say of them, and to what hosts gave and got. What our boards
 * seal is opened if the run's keys are known. Others may send anything; it is only remembered.
 */
final class ByteCheck implements Check {
    private static final Set<String> BOOTS = Set.of("MEMORY", "EPOCH_STORED", "QUIET", "BUSY");
    private static final int MOST_RECENT = 64;
    private static final int LOW_BYTE = 0xFF;

    /** A packet at a board that it has reached. */
    private record Heard(String board, Payload payload) {}

    private final Map<String, BoardFrames> boards = new LinkedHashMap<>();
    private final FrameDecryptor decryptor;
    /** By origin and nonce, or by what they begin with. */
    private final Map<String, Frame> frames = new BoundedMap<>();
    /** By origin and id, of what others have sent fragments: nothing proves those of a broadcast. */
    private final Set<String> touched = new HashSet<>();
    private final Deque<Transmission> recent = new ArrayDeque<>();
    private final Map<Heard, Boolean> fragments = new BoundedMap<>();
    /** Who has sent something with a trailer, and to whom; and whose partner has asked for parity. */
    private final Set<String> trailed = new HashSet<>();
    private final Set<String> askedForParity = new HashSet<>();
    private final Header header;
    private final double tolerance;
    private int proofs;

    ByteCheck(Header header) {
        this.header = header;
        tolerance = PhysicalLimits.ARRIVAL_BITS * header.bit();
        decryptor = new FrameDecryptor(header.keys().map(Keys::new), boards.values());
    }

    @Override
    public String checked() {
        return decryptor.hasKeys() ? decryptor.opened() + " messages opened, " + proofs + " proofs" : "";
    }

    private BoardFrames board(String name) {
        return boards.computeIfAbsent(name, added -> new BoardFrames(added, header.second(added)));
    }

    @Override
    public void point(Point point) throws RefusedException {
        BoardFrames board = board(point.board());
        board.declares = true;
        board.runsSince = board.runsSince < 0 && BOOTS.contains(point.name()) ? point.seconds() : board.runsSince;
        switch (point.name()) {
            case "EPOCH_STORED" -> board.storeEpoch(point.operand("low"));
            case "TAKE_UP", "RESEAL" -> board.seal(point);
            case "OWE_DELIVERED", "OWE_FRAGMENTS", "OWE_STALE" -> board.owe(point);
            case "OWE_TWICE" -> board.oweTwice();
            case "DELIVERED" -> answered(board, point, Acknowledgement.DELIVERED);
            case "STALE_HEARD" -> answered(board, point, Acknowledgement.STALE);
            case "FRAGMENTS_NEW", "FRAGMENTS_KNOWN" ->
                answered(board, point, Acknowledgement.FRAGMENTS + point.operand("have"));
            default -> board.declared = AirCheck.SENDS.contains(point.name()) ? point : board.declared;
        }
    }

    /** A board has heard an answer: somebody must have given it. */
    private static void answered(BoardFrames board, Point point, String answer) throws RefusedException {
        Frame frame = board.message(point).frame;
        require(frame != null && frame.answers.contains(answer),
                board.name + " declares " + point.name() + " of message " + point.number(),
                "an acknowledgement of that with a right proof before");
    }

    @Override
    public void begins(Transmission packet) throws RefusedException {
        BoardFrames board = board(packet.board());
        Payload payload = Fields.payload(packet.event());
        recent.addLast(packet);
        if (recent.size() > MOST_RECENT) {
            recent.removeFirst();
        }
        Point declared = board.declared;
        board.declared = null;
        boolean isE32 = packet.event().textOrEmpty("radio").equals("e32");
        board.fragmentLength = isE32 ? Payload.E32_PART_LENGTH : Payload.PART_LENGTH;
        boolean isSend = declared != null && declared.name().startsWith("SEND");
        boolean isRelayed = isSend && board.isRelayed(declared);
        require(!isRelayed || board.message(declared).isOf(payload), board.name + " sends " + payload.hex(),
                "the bytes that its host wants to be relayed");
        if (isSend && !isRelayed) {
            send(board, packet, declared);
        } else if (payload.isAcknowledgement()) {
            answer(board, payload, packet.start(), declared);
        } else if (payload.isData()) {
            remember(payload);
        }
    }

    /** A board of ours sends a frame of its own, a fragment of one, or another device's for its host. */
    private void send(BoardFrames board, Transmission packet, Point declared) throws RefusedException {
        Payload payload = packet.payload();
        if (board.ids.isEmpty() && payload.kind() == Payload.Kind.BROADCAST) {
            remember(payload); // a sketch without a host
            return;
        }
        BoardFrames.Outgoing message = board.message(declared);
        require(payload.isData() && 1 << payload.index() == Integer.lowestOneBit(declared.operand("pending")),
                board.name + " sends " + packet, "fragments of its attempt in their order");
        if (message.frame == null) {
            first(board, message, payload);
        }
        Frame frame = message.frame;
        boolean isCut = frame.fragmentId != Frame.NO_ID;
        boolean isSame = payload.isFragment() == isCut && (isCut
                ? payload.fragmentId() == frame.fragmentId
                        && frame.hasFragment(payload.index(), payload.message().toArray())
                : Arrays.equals(payload.bytes().toArray(), frame.first));
        require(isSame, board.name + " sends other bytes as " + (payload.isFragment()
                ? "fragment " + payload.index() + " of " : "") + frame,
                "those of the whole that it has sealed" + (isCut ? " and cut" : ""));
        require(!isCut || payload.asks() == (frame.isUnicast() && declared.is("SEND")), board.name + " sends fragment "
                + payload.index() + " of " + frame + (payload.asks() ? " and asks" : " and does not ask")
                + " for an answer", "that the last one of an attempt asks, if it is for one device");
        checkTrailer(board, frame, packet);
    }

    private void checkTrailer(BoardFrames board, Frame frame, Transmission packet) throws RefusedException {
        int index = packet.payload().index();
        String expected = switch (packet.trailer()) {
            case "" -> "";
            case "parity" -> !decryptor.hasKeys() || askedForParity.contains(frame.pair()) ? ""
                    : "that its partner asks for parity first";
            default -> (frame.sent & 1 << index) != 0 ? "" : "one only behind a packet that is sent again";
        };
        require(expected.isEmpty(), board.name + " sends a trailer '" + packet.trailer() + "' behind " + frame,
                expected);
        require(packet.told() == 0 || frame.sent == 0, board.name + " tells a distance again with " + frame, "none");
        require(packet.trailer().isEmpty() || frame.isUnicast(), board.name + " sends a trailer behind " + frame,
                "none behind a frame to many");
        if (!packet.trailer().isEmpty()) {
            trailed.add(frame.pair());
        }
        frame.sent |= 1 << index;
    }

    private void first(BoardFrames board, BoardFrames.Outgoing message, Payload payload) throws RefusedException {
        require(payload.index() == 0, board.name + " sends fragment " + payload.index() + " of a message first",
                "fragment 0");
        Frame frame = new Frame(payload);
        boolean isForeign = message.destination != null && !board.ids.contains(frame.origin);
        String form = isForeign ? "the origin " + frame.origin : frame.wrongForm(payload, board.fragmentLength);
        require(form.isEmpty(), board.name + " sends a " + payload.kind() + " with " + form,
                "a frame as in SPEC 2 and 7.1");
        message.frame = frame;
        if (message.isSealed) {
            require(frame.isSealed(), board.name + " sends a message to many that it has sealed",
                    "an address for that");
            Frame known = frames.get(frame.origin + frame.nonce);
            require(known == null, board.name + " uses the nonce of an earlier message again: " + known, "the next");
            board.checkNonce(message);
        }
        if (frame.fragmentId != Frame.NO_ID) {
            board.checkId(message);
        }
        if (message.destination != null) {
            decryptor.check(board.name, frame, message);
        }
        if (board.ids.contains(frame.origin)) {
            frames.put(frame.isSealed() ? frame.origin + frame.nonce : payload.identity(), frame);
        } else {
            remember(payload);
        }
    }

    /** Somebody else begins to send a frame: one of ours again, or anything. */
    private void remember(Payload payload) {
        if (payload.index() != 0) {
            touched.add(payload.origin() + payload.fragmentId());
            return;
        }
        Frame frame = new Frame(payload);
        Frame ours = frames.get(frame.origin + frame.nonce);
        boolean isNone = frame.length == 0 || frame.isSealed() && (frame.contentLength() < 0 || frame.nonce.isEmpty());
        if (!isNone && (ours == null || !ours.isSame(frame))) {
            boolean isOurs =
                    boards.values().stream().anyMatch(board -> board.declares && board.ids.contains(frame.origin));
            frame.isForged = frame.isSealed() && isOurs && (!decryptor.hasKeys() || frame.bytes == null);
            decryptor.open(frame);
            frames.put("strange " + payload.identity(), frame);
        }
    }

    /** A board acknowledges, or somebody tries to. */
    private void answer(BoardFrames board, Payload payload, double start, Point declared) throws RefusedException {
        Optional<Acknowledgement> read = Acknowledgement.of(payload);
        boolean isOwn = declared != null && declared.is("ANSWER");
        require(!isOwn || read.isPresent(), board.name + " acknowledges with " + payload.message().length() + " bytes",
                "8, 9 or 16");
        if (read.isEmpty()) {
            return;
        }
        Acknowledgement answer = read.get();
        List<Frame> meant = frames.values().stream().filter(answer::mayMean).toList();
        List<Frame> proved = proved(answer, meant);
        if (isOwn) {
            check(board, answer, start, declared, meant, proved);
        }
        for (Frame frame : proved) {
            frame.answers.add(answer.answer());
            if (decryptor.hasKeys() && answer.asksParity(frame, decryptor.keysOf(frame))) {
                askedForParity.add(frame.pair());
            }
            boards.values().stream().filter(sender -> sender.ids.contains(frame.origin))
                    .forEach(sender -> sender.wasStale |= answer.is(Acknowledgement.STALE));
        }
    }

    /** Without keys all that may be. */
    private List<Frame> proved(Acknowledgement answer, List<Frame> meant) {
        List<Frame> proved = !decryptor.hasKeys() ? meant
                : meant.stream().filter(frame -> answer.isProved(frame, decryptor.keysOf(frame))).toList();
        return proved.isEmpty() && decryptor.refresh() ? proved(answer, meant) : proved;
    }

    private void check(BoardFrames board, Acknowledgement answer, double start, Point declared, List<Frame> meant,
            List<Frame> proved) throws RefusedException {
        Payload payload = answer.payload();
        String bits = String.format("%03x", payload.answered());
        require(board.ids.contains(payload.origin()), board.name + " acknowledges as " + payload.origin(),
                "" + board.ids);
        require(!meant.isEmpty(), board.name + " acknowledges a nonce that ends in " + bits,
                "that of a message to it");
        int key = declared.operand("key");
        int nonce = payload.answered() & LOW_BYTE;
        require(board.pays(key, nonce, answer.kind()), board.name + " sends '" + answer.kind()
                + "' about a nonce that ends in " + bits, board.owes(key, nonce));
        require(!proved.isEmpty(), board.name + " acknowledges with a wrong proof",
                "that of " + meant.get(meant.size() - 1));
        proofs += decryptor.hasKeys() ? 1 : 0;
        boolean mayAsk = !decryptor.hasKeys() || proved.stream().anyMatch(frame -> trailed.contains(frame.pair())
                || !answer.asksParity(frame, decryptor.keysOf(frame)));
        require(mayAsk, board.name + " asks for parity of " + proved.get(0),
                "that a packet with a trailer comes first");
        switch (answer.kind()) {
            case Acknowledgement.FRAGMENTS -> checkFragments(board, answer, proved);
            case Acknowledgement.STALE -> answer.checkStale(board, start, proved);
            default -> {}
        }
    }

    private void checkFragments(BoardFrames board, Acknowledgement answer, List<Frame> proved)
            throws RefusedException {
        int told = answer.fragments();
        int possible = 0;
        for (Frame frame : proved) {
            int come = fragments.keySet().stream().filter(heard -> heard.board.equals(board.name)
                    && heard.payload.origin().equals(frame.origin) && heard.payload.fragmentId() == frame.fragmentId)
                    .mapToInt(heard -> 1 << heard.payload.index()).reduce(0, (one, other) -> one | other);
            int all = (1 << frame.fragments()) - 1;
            if (frame.fragmentId != Frame.NO_ID && (told & ~come) == 0 && told != all
                    && ((told & 1) != 0 || come == all)) {
                return;
            }
            possible |= come;
        }
        throw new RefusedException(String.format("%s answers that it has the fragments %02x of %s", board.name, told,
                proved.get(proved.size() - 1)), String.format("%02x or fewer, with the first, and not all", possible));
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        switch (event.name()) {
            case "reset" -> {
                BoardFrames board = board(event.board());
                board.reset(event.seconds());
                fragments.keySet().removeIf(
                        heard -> heard.board.equals(board.name) || board.ids.contains(heard.payload.origin()));
            }
            case "host-id" -> {
                BoardFrames board = board(event.board());
                board.ids.add(event.text("id"));
                if (event.has("epoch") && board.declares) {
                    board.tellEpoch(HexFormat.fromHexDigits(event.text("epoch")));
                }
            }
            case "host-transmit", "host-relay" -> accept(event);
            case "rf-rx", "rf-damaged" -> reach(event);
            case "host-handed" -> hand(event);
            default -> {}
        }
    }

    private void accept(TraceEvent event) throws RefusedException {
        BoardFrames board = board(event.board());
        BoardFrames.Outgoing message = board.accept(event.number("number"));
        message.isRelayed = event.is("host-relay");
        message.destination = message.isRelayed ? Frame.ALL : event.text("destination");
        message.content = message.isRelayed ? event.bytes("payload") : content(event);
        if (message.frame != null) {
            decryptor.check(board.name, message.frame, message);
        }
    }

    /** What the event says was said; null where it does not say that, and without keys it need not. */
    private byte[] content(TraceEvent event) {
        Optional<byte[]> said = event.said();
        if (said.isEmpty() && decryptor.hasKeys()) {
            throw event.wrong("an event '" + event.name() + "' without 'content'");
        }
        return said.orElse(null);
    }

    /** A packet has come to a board, perhaps damaged. */
    private void reach(TraceEvent event) throws RefusedException {
        if (event.has("payload")) {
            Fields.payload(event);
        }
        recent.stream().filter(packet -> packet.board().equals(event.textOrEmpty("from"))
                && packet.payload().isFragment() && Math.abs(packet.start() - event.real("start")) < tolerance)
                .forEach(packet -> fragments.put(new Heard(event.board(), packet.payload()), true));
    }

    /** A board hands its host a message: what was said, and to whom. */
    private void hand(TraceEvent event) throws RefusedException {
        byte[] content = content(event);
        List<Frame> meant = frames.values().stream().filter(frame -> frame.origin.equals(event.text("origin"))
                && frame.destination.equals(event.text("destination"))
                && frame.id().equals(event.text("id")) && !frame.isForged)
                .toList();
        require(content == null || meant.stream().anyMatch(frame -> frame.content == null
                || frame.isBroadcast() && touched.contains(frame.origin + frame.fragmentId)
                || Arrays.equals(frame.content, content)),
                event.board() + " hands its host " + Fields.shown(content) + " from " + event.text("origin"),
                meant.isEmpty() ? "nothing that any key opens" : Fields.shown(meant.get(meant.size() - 1).content));
    }
}
