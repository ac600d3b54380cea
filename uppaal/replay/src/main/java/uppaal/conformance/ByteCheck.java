package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.HashSet;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import trace.TraceEvent;

/**
 * Holds the bytes of each packet to what SPEC 2, 5 and 7 say of them, and to what hosts gave and got. What our boards
 * seal is sealed again if the run's keys are known. Others may send anything; it is only remembered.
 */
final class ByteCheck implements Check {
    private final Map<String, BoardFrames> boards = new LinkedHashMap<>();
    private final Keys keys;
    /** By what they begin with. */
    private final Map<String, Frame> frames = new BoundedMap<>();
    /** By origin and id, of what others have sent fragments: nothing proves those of a broadcast. */
    private final Set<String> touched = new HashSet<>();
    /** The senders of packets with a trailer, with their receivers, and those whose partner has asked for parity. */
    private final Set<String> trailed = new HashSet<>();
    private final Set<String> askedForParity = new HashSet<>();
    private final Header header;
    private int proofs;

    ByteCheck(Header header) {
        this.header = header;
        keys = new Keys(header.keys(), this::names);
    }

    @Override
    public String checked() {
        return keys.areKnown() ? keys.opened() + " messages opened, " + proofs + " proofs" : "";
    }

    private BoardFrames board(String name) {
        return boards.computeIfAbsent(name, added -> new BoardFrames(added, header));
    }

    /** The boards that ever had this address. */
    private Stream<BoardFrames> called(String address) {
        return boards.values().stream().filter(board -> board.ids.contains(address));
    }

    /** All names that the device with this address ever had. */
    private Set<String> names(String address) {
        return called(address).map(board -> board.ids).findFirst().orElse(Set.of(address));
    }

    @Override
    public void point(Point point) throws RefusedException {
        BoardFrames board = board(point.board());
        board.runsSince = board.runsSince < 0 ? point.seconds() : board.runsSince;
        board.declares = true;
        board.eeprom.point(point);
        switch (point.name()) {
            case "EPOCH_STORED" -> board.storeEpoch();
            case "COUNT" -> board.count(point);
            case "TAKE_UP", "RESEAL" -> board.seal(point);
            case "OWE_DELIVERED", "OWE_FRAGMENTS", "OWE_STALE" -> board.owe(point);
            case "DELIVERED" -> answer(board, point, Acknowledgement.DELIVERED);
            case "STALE_HEARD" -> board.hearStale(point, answer(board, point, Acknowledgement.STALE).uptime());
            case "FRAGMENTS_NEW", "FRAGMENTS_KNOWN" ->
                answer(board, point, Acknowledgement.FRAGMENTS + point.operand("have"));
            default -> {}
        }
    }

    /** The answer that a board has heard. */
    private Acknowledgement answer(BoardFrames board, Point point, String answer) throws RefusedException {
        Frame frame = board.message(point).frame;
        return point.packets().stream().map(each -> each.packet().payload()).filter(Payload::isAcknowledgement)
                .flatMap(payload -> Acknowledgement.of(payload).stream())
                .filter(each -> frame != null && each.answer().equals(answer) && each.mayMean(frame)
                        && each.isProved(frame, keys))
                .findFirst().orElseThrow(() -> new RefusedException(
                        board.name + " declares " + point.name() + " of message " + point.number(),
                        "an acknowledgement of that with a right proof before"));
    }

    @Override
    public void begins(Transmission packet) throws RefusedException {
        Fields.check(packet.event(), packet.payload());
        BoardFrames board = board(packet.board());
        Payload payload = packet.payload();
        if (packet.isDeclared("SEND")) {
            BoardFrames.Outgoing message = board.message(packet.declared());
            if (!message.isRelayed) {
                send(board, message, packet);
                return;
            }
            require(payload.bytes().equals(message.content), board.name + " sends " + payload.hex(),
                    "the bytes that its host wants to be relayed");
        }
        if (payload.isAcknowledgement()) {
            answer(board, packet);
        } else if (payload.isData()) {
            overhear(payload);
        }
    }

    /** A board of ours sends a frame of its own, or a fragment of one. */
    private void send(BoardFrames board, BoardFrames.Outgoing message, Transmission packet) throws RefusedException {
        Payload payload = packet.payload();
        require(payload.isData()
                && 1 << payload.index() == Integer.lowestOneBit(packet.declared().operand("pending")),
                board.name + " sends " + packet, "fragments of its attempt in their order");
        if (message.frame == null) {
            require(payload.index() == 0,
                    board.name + " sends fragment " + payload.index() + " of a message first", "fragment 0");
            board.begin(message, packet);
            frames.put(payload.identity(), message.frame);
            if (message.content != null) {
                keys.check(board.name, message.frame, message.content);
            }
        }
        Frame frame = message.frame;
        require(frame.isPart(payload), board.name + " sends other bytes as " + (payload.isFragment()
                ? "fragment " + payload.index() + " of " : "") + frame,
                "those of the whole that it has sealed" + (frame.isCut() ? " and cut" : ""));
        require(!frame.isCut() || payload.asks() == (frame.isUnicast() && packet.declared().is("SEND")),
                board.name + " sends fragment " + payload.index() + " of " + frame
                        + (payload.asks() ? " and asks" : " and does not ask") + " for an answer",
                "that the last one of an attempt asks, if it is for one device");
        checkTrailer(board, frame, packet);
        frame.sent |= 1 << payload.index();
    }

    private void checkTrailer(BoardFrames board, Frame frame, Transmission packet) throws RefusedException {
        require(packet.told() == 0 || frame.sent == 0, board.name + " tells a distance again with " + frame, "none");
        if (packet.trailer().isEmpty()) {
            return;
        }
        String what = board.name + " sends a trailer '" + packet.trailer() + "' behind " + frame;
        require(frame.isUnicast(), what, "none behind a frame to many");
        if (packet.trailer().equals("parity")) {
            require(!keys.areKnown() || askedForParity.contains(frame.pair()), what,
                    "that its partner asks for parity first");
        } else {
            require((frame.sent & 1 << packet.payload().index()) != 0, what,
                    "one only behind a packet that is sent again");
        }
        trailed.add(frame.pair());
    }

    /** Somebody else begins to send a frame: one of ours again, or anything. */
    private void overhear(Payload payload) {
        if (payload.index() != 0) {
            touched.add(payload.origin() + payload.fragmentId());
            return;
        }
        Frame frame = new Frame(payload);
        if (frame.length >= Frame.around(frame.destination) && !frames.containsKey(payload.identity())) {
            frame.isForged = frame.isSealed() && called(frame.origin).anyMatch(board -> board.declares);
            frames.put(payload.identity(), frame);
        }
    }

    /** A board acknowledges, or somebody tries to. */
    private void answer(BoardFrames board, Transmission packet) throws RefusedException {
        Optional<Acknowledgement> read = Acknowledgement.of(packet.payload());
        boolean isOwn = packet.isDeclared("ANSWER");
        require(!isOwn || read.isPresent(),
                board.name + " acknowledges with " + packet.payload().message().length() + " bytes", "8, 9 or 16");
        if (read.isEmpty()) {
            return;
        }
        Acknowledgement answer = read.get();
        List<Frame> meant = frames.values().stream().filter(answer::mayMean).toList();
        List<Frame> proved = meant.stream().filter(frame -> answer.isProved(frame, keys)).toList();
        if (isOwn) {
            checkOwn(board, packet.declared().operand("key"), answer, meant, proved);
            answer.check(board, packet.start(), proved);
        }
        for (Frame frame : proved) {
            if (answer.asksParity(frame, keys)) {
                askedForParity.add(frame.pair());
            }
            called(frame.origin).forEach(sender -> sender.wasStale |= answer.is(Acknowledgement.STALE));
        }
    }

    private void checkOwn(BoardFrames board, int key, Acknowledgement answer, List<Frame> meant, List<Frame> proved)
            throws RefusedException {
        Payload payload = answer.payload();
        require(board.ids.contains(payload.origin()), board.name + " acknowledges as " + payload.origin(),
                "" + board.ids);
        require(!meant.isEmpty(), String.format("%s acknowledges a nonce that ends in %03x", board.name,
                payload.answered()), "that of a message to it");
        board.pay(key, answer);
        require(!proved.isEmpty(), board.name + " acknowledges with a wrong proof",
                "that of " + meant.get(meant.size() - 1));
        proofs += keys.areKnown() ? 1 : 0;
        require(proved.stream().anyMatch(frame -> trailed.contains(frame.pair()) || !answer.asksParity(frame, keys)),
                board.name + " asks for parity of " + proved.get(0), "that a packet with a trailer comes first");
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        BoardFrames board = board(event.board());
        board.eeprom.event(event);
        switch (event.name()) {
            case "reset" -> {
                board.reset(event.seconds());
                frames.values().forEach(frame -> frame.reached.remove(board.name));
            }
            case "host-id" -> {
                board.ids.add(event.text("id"));
                if (event.has("epoch") && board.declares) {
                    require(HexFormat.fromHexDigits(event.text("epoch")) == board.eeprom.epoch(),
                            board.name + " says that it has epoch " + event.text("epoch"),
                            String.format("%06x, as stored", board.eeprom.epoch()));
                }
            }
            case "host-transmit" -> board.outgoing.put(event.number("number"),
                    new BoardFrames.Outgoing(event.text("destination"), content(event), false));
            case "host-relay" -> board.outgoing.put(event.number("number"),
                    new BoardFrames.Outgoing(Frame.ALL, Bytes.copyOf(event.bytes("payload")), true));
            case "host-handed" -> hand(event);
            default -> {}
        }
    }

    /** The content that the event tells; null where it does not say that, and without keys it need not. */
    private Bytes content(TraceEvent event) {
        Optional<byte[]> said = event.said();
        if (said.isEmpty() && keys.areKnown()) {
            throw event.wrong("an event '" + event.name() + "' without 'content'");
        }
        return said.map(Bytes::copyOf).orElse(null);
    }

    @Override
    public void hears(Reception reception) throws RefusedException {
        if (reception.isIntact()) {
            Fields.check(reception.event(), Payload.of(Bytes.copyOf(reception.event().bytes("payload"))));
        }
        Payload payload = reception.packet().payload();
        frames.values().stream().filter(frame -> payload.isFragment() && frame.isOf(payload)).forEach(
                frame -> frame.reached.merge(reception.board(), 1 << payload.index(), (one, other) -> one | other));
    }

    /** A board hands its host a message: what was said, and to whom. */
    private void hand(TraceEvent event) throws RefusedException {
        Bytes content = content(event);
        List<Frame> meant = frames.values().stream().filter(frame -> frame.origin.equals(event.text("origin"))
                && frame.destination.equals(event.text("destination"))
                && frame.id().equals(event.text("id")) && !frame.isForged)
                .toList();
        require(content == null || meant.stream().anyMatch(frame -> keys.says(frame, content)
                || !frame.isSealed() && touched.contains(frame.origin + frame.fragmentId)),
                event.board() + " hands its host " + Fields.shown(content) + " from " + event.text("origin"),
                meant.isEmpty() ? "a message that it has sent" : Fields.shown(meant.get(meant.size() - 1).content));
    }
}
