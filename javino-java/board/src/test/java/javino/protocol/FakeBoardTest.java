package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.google.gson.JsonObject;
import java.time.Duration;
import java.util.List;
import javino.fake.FakeBoard;
import javino.fake.FakeLegacyBoard;
import javino.link.Link;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Holds the fake boards to the vectors, apart from the library that they test. */
@Timeout(60)
class FakeBoardTest {

    private static final VectorFile FILE = new VectorFile("commands.json");
    private static final Bytes HELLO = Bytes.of('H', 1);
    /** How long a reply is waited for before a byte ends the hold of a poll. */
    private static final Duration WAIT = Duration.ofMillis(20);

    private final FakeBoard board = new FakeBoard();
    private final PacketDecoder decoder = new PacketDecoder();
    private Link link;
    private int sequence;

    @BeforeEach
    void open() throws Exception {
        link = board.port.open();
    }

    @AfterEach
    void close() {
        link.close();
    }

    @Test
    void requests_ofTheVectors_arePerformedAndAnsweredInTheirForm() throws Exception {
        board.setActions("stop", "goTo").perceive("light(1)", "dark").endAll(Outcome.SENT);
        board.receive("tell;help");
        board.mail.receiveWithoutKey("SUPO", "CAFE");
        board.mail.overhear(1, 0, Bytes.ofText("////ROMAAIx"));
        board.keys.setSession("CAFE", Bytes.of(7, 7, 7));
        assertEquals(Status.NOT_GREETED, ask(Request.listKeys().frame()).status());
        for (JsonObject vector : FILE.list("requests").toList()) {
            Frame request = frame(vector);
            if (vector.has("origin")) {
                board.setRfId(request.origin().toString());
            }
            Reply reply = ask(request);
            assertEquals(Status.OK, reply.status(), vector::toString);
            ReplyFields.read(VectorFile.text(vector, "name"), reply);
        }
        for (JsonObject vector : FILE.list("badRequests").toList()) {
            if (VectorFile.text(vector, "status").equals(Status.UNKNOWN_COMMAND.name())) {
                assertEquals(Status.UNKNOWN_COMMAND, ask(frame(vector)).status(), vector::toString);
            }
        }
        assertEquals(Status.WRONG_ORIGIN, ask(new Frame(Address.BROADCAST, Address.parse("SUHO"), HELLO)).status());
    }

    /** A host says what it has taken with each poll, whether it has said so before or not. */
    @Test
    void taken_sameNumberAgainWithMoreWaitingThanNumbers_forgetsNoMore() throws Exception {
        for (int i = 0; i < 300; i++) {
            board.receive("SUPO", "ROMA", "tell;x");
        }
        ask(request(HELLO));
        Bytes poll = Bytes.of('P', 0, 0, 0, 0, 0, 0);
        Frame threeTaken = request(Bytes.join(poll, Bytes.of(3)));
        ask(request(poll));
        Bytes left = ask(threeTaken).body();
        assertEquals(4, ((PollReply.Message) ask(threeTaken).poll().records().get(0)).number());
        assertEquals(left, ask(threeTaken).body());
    }

    private static Frame request(Bytes message) {
        return new Frame(Address.SERIAL, Address.SERIAL, message);
    }

    private static Frame frame(JsonObject vector) {
        Bytes message = VectorFile.bytes(vector, "message");
        return vector.has("destination")
                ? new Frame(VectorFile.address(vector, "destination"), VectorFile.address(vector, "origin"), message)
                : request(message);
    }

    private Reply ask(Frame request) throws Exception {
        SerialPacket packet = new SerialPacket(sequence++ & 0xFF, request);
        link.write(packet.encode().toArray());
        byte[] buffer = new byte[1024];
        while (true) {
            List<PacketDecoder.Result> results = decoder.feed(buffer, link.read(buffer, WAIT)).stream()
                    .filter(result -> !(result instanceof PacketDecoder.Empty)).toList();
            if (!results.isEmpty()) {
                PacketDecoder.Found found = (PacketDecoder.Found) results.get(0);
                assertEquals(1, results.size(), request + " has more than one reply");
                assertEquals(packet.sequence(), found.packet().sequence(), request::toString);
                return Reply.decode(found.packet().frame());
            }
            link.write(new byte[1]);
        }
    }

    /** SPEC 8.1, whose example is what the host writes here. */
    @Test
    void getPercepts_ofABoardWithTheOlderProtocol_isAnsweredInItsForm() throws Exception {
        try (Link older = new FakeLegacyBoard().perceive("light(1);dark;").port.open()) {
            older.setBaud(9600);
            older.write(Bytes.ofText("fffe0BgetPercepts").toArray());
            byte[] buffer = new byte[64];
            int count = older.read(buffer, Duration.ofMinutes(1));
            assertEquals("fffe0Elight(1);dark;", Bytes.copyOf(buffer).slice(0, count).text());
        }
    }
}
