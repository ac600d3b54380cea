package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.google.gson.JsonObject;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/** The vectors of commands, for all that plays a board: it answers what they ask in the form that they have. */
public final class BoardVectors {

    private static final VectorFile FILE = new VectorFile("commands.json");

    /** What hosts ask without being told to, so that each board has to know it. */
    private static final Set<String> KNOWN_TO_ALL = Set.of("hello", "poll", "listActions", "listKeys", "statistics");

    /** How often a reply is waited for, each time a little; a byte between ends the hold of a poll. */
    private static final int MOST_WAITS = 500;
    private static final Duration WAIT = Duration.ofMillis(20);

    private final Link link;
    private final PacketDecoder decoder = new PacketDecoder();
    private int sequence;

    private BoardVectors(Link link) {
        this.link = link;
    }

    /** Fails if a board that has booted answers a request of the vectors in a form that no reply has. */
    public static void assertAnswered(LinkOpener board) throws LinkException, ProtocolException {
        try (Link link = board.open()) {
            new BoardVectors(link).assertAnswered();
        }
    }

    private void assertAnswered() throws LinkException, ProtocolException {
        assertEquals(Status.NOT_GREETED, ask(Request.listKeys().frame()).status());
        for (JsonObject vector : FILE.list("requests").toList()) {
            String name = VectorFile.text(vector, "name");
            Reply reply = ask(frame(vector));
            if (reply.status() == Status.OK) {
                ReplyFields.read(name, reply);
            } else {
                assertFalse(KNOWN_TO_ALL.contains(name), name + " is answered " + reply.status());
                assertEquals(Bytes.EMPTY, reply.body(), name + " is refused with a body");
            }
        }
        for (JsonObject vector : FILE.list("badRequests").toList()) {
            if (VectorFile.text(vector, "status").equals(Status.UNKNOWN_COMMAND.name())) {
                assertEquals(Status.UNKNOWN_COMMAND, ask(frame(vector)).status(), vector::toString);
            }
        }
    }

    private static Frame frame(JsonObject vector) {
        Bytes message = VectorFile.bytes(vector, "message");
        return vector.has("destination")
                ? new Frame(VectorFile.address(vector, "destination"), VectorFile.address(vector, "origin"), message)
                : new Frame(Address.SERIAL, Address.SERIAL, message);
    }

    private Reply ask(Frame request) throws LinkException, ProtocolException {
        SerialPacket packet = new SerialPacket(sequence++ & 0xFF, request);
        link.write(packet.encode().toArray());
        byte[] buffer = new byte[1024];
        for (int i = 0; i < MOST_WAITS; i++) {
            List<PacketDecoder.Result> results = decoder.feed(buffer, link.read(buffer, WAIT));
            if (!results.isEmpty()) {
                PacketDecoder.Found found = (PacketDecoder.Found) results.get(0);
                assertEquals(1, results.size(), request + " has more than one reply");
                assertEquals(packet.sequence(), found.packet().sequence(), request::toString);
                return Reply.decode(found.packet().frame());
            }
            link.write(new byte[1]);
        }
        throw new AssertionError("no reply to " + request);
    }
}
