package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class CommandTest {

    private static final VectorFile FILE = new VectorFile("commands.json");

    static Stream<JsonObject> requests() {
        return FILE.list("requests");
    }

    static Stream<JsonObject> replies() {
        return FILE.list("replies");
    }

    static Stream<JsonObject> badReplies() {
        return FILE.list("badReplies");
    }

    private static Request requestOf(JsonObject vector) throws ProtocolException {
        return switch (VectorFile.text(vector, "name")) {
            case "hello" -> Request.hello();
            case "poll" -> Request.poll(
                    Request.Percepts.valueOf(VectorFile.text(vector, "percepts").toUpperCase(Locale.ROOT)),
                    vector.get("hold").getAsInt(), vector.get("least").getAsInt(),
                    vector.get("taken").isJsonNull() ? Request.NOTHING_TAKEN : vector.get("taken").getAsInt(),
                    Request.LastReply.valueOf(VectorFile.text(vector, "lastReply").toUpperCase(Locale.ROOT)));
            case "act" -> Request.act(VectorFile.text(vector, "action"));
            case "listActions" -> Request.listActions(vector.get("offset").getAsInt());
            case "setRfId" -> Request.setRfId(VectorFile.address(vector, "address"));
            case "radio" -> Request.radio(vector.get("open").getAsBoolean());
            case "overhear" -> Request.overhear(vector.get("on").getAsBoolean());
            case "relaying" -> vector.get("on").getAsBoolean()
                    ? Request.relaying(vector.get("number").getAsInt())
                    : Request.notRelaying();
            case "isRelaying" -> Request.isRelaying();
            case "relay" -> Request.relay(Frame.decode(VectorFile.bytes(vector, "frame")));
            case "setKey" -> Request.setKey(VectorFile.address(vector, "address"),
                    Key.ofHex(VectorFile.text(vector, "key")));
            case "renewKey" -> Request.renewKey(VectorFile.address(vector, "address"),
                    Key.ofHex(VectorFile.text(vector, "key")));
            case "raiseEpoch" -> Request.raiseEpoch(vector.get("epoch").getAsInt());
            case "useKey" -> Request.useKey(VectorFile.address(vector, "address"));
            case "finishRenewal" -> Request.finishRenewal(VectorFile.address(vector, "address"));
            case "deleteKey" -> Request.deleteKey(VectorFile.address(vector, "address"));
            case "setSessionKey" -> Request.setSessionKey(VectorFile.address(vector, "address"),
                    Key.ofHex(VectorFile.text(vector, "key")));
            case "listKeys" -> Request.listKeys();
            case "statistics" -> Request.statistics();
            case "transmit" -> Request.transmit(VectorFile.address(vector, "destination"),
                    VectorFile.address(vector, "origin"),
                    Content.decode(Bytes.ofText(VectorFile.text(vector, "content"))));
            default -> throw new AssertionError(vector);
        };
    }

    private static Reply replyOf(JsonObject vector) throws ProtocolException {
        return Reply.decode(new Frame(Address.SERIAL, Address.SERIAL, VectorFile.bytes(vector, "message")));
    }

    @ParameterizedTest
    @MethodSource("requests")
    void frame_requestVector_carriesItsMessage(JsonObject vector) throws ProtocolException {
        Frame frame = requestOf(vector).frame();
        assertEquals(VectorFile.bytes(vector, "message"), frame.message());
        boolean transmission = vector.has("destination");
        assertEquals(transmission ? VectorFile.text(vector, "destination") : "++++", frame.destination().toString());
        assertEquals(transmission ? VectorFile.text(vector, "origin") : "++++", frame.origin().toString());
    }

    @ParameterizedTest
    @MethodSource("replies")
    void decode_replyVector_givesItsFields(JsonObject vector) throws ProtocolException {
        Reply reply = replyOf(vector);
        assertEquals(VectorFile.text(vector, "status"), reply.status().name());
        assertEquals(vector.getAsJsonObject("fields").toString(),
                ReplyFields.read(VectorFile.text(vector, "name"), reply).toString());
    }

    @ParameterizedTest
    @MethodSource("badReplies")
    void decode_badReplyVector_throws(JsonObject vector) {
        assertThrows(ProtocolException.class,
                () -> ReplyFields.read(VectorFile.text(vector, "name"), replyOf(vector)));
    }

    @Test
    void decode_replyNotBetweenHostAndBoard_throws() {
        Frame frame = new Frame(Address.BROADCAST, Address.SERIAL, Bytes.of(0));
        assertEquals(ProtocolError.BAD_REPLY,
                assertThrows(ProtocolException.class, () -> Reply.decode(frame)).error());
    }

    @ParameterizedTest
    @MethodSource("replies")
    void decode_replyCutAnywhereOrChanged_throwsOnlyProtocolExceptions(JsonObject vector) {
        Bytes whole = VectorFile.bytes(vector, "message");
        Random random = new Random(5);
        for (int length = 0; length < whole.length(); length++) {
            assertReadOrRefused(vector, whole.slice(0, length));
            byte[] changed = whole.toArray();
            changed[length] = (byte) random.nextInt(256);
            assertReadOrRefused(vector, Bytes.copyOf(changed));
        }
    }

    private static void assertReadOrRefused(JsonObject vector, Bytes message) {
        try {
            Reply reply = Reply.decode(new Frame(Address.SERIAL, Address.SERIAL, message));
            ReplyFields.read(VectorFile.text(vector, "name"), reply);
        } catch (ProtocolException e) {
            assertFalse(e.getMessage().isBlank());
        }
    }

    @Test
    void and_nextPart_joinsNamesThatWereCut() throws ProtocolException {
        ActionNames first = new ActionNames(2, Bytes.ofText("stop\0g"));
        ActionNames all = first.and(new ActionNames(2, Bytes.ofText("o\0")));
        assertFalse(first.areAll());
        assertEquals(List.of("stop"), first.names());
        assertTrue(all.areAll());
        assertEquals(List.of("stop", "go"), all.names());
        assertEquals(0xFFFF, first.and(new ActionNames(2, Bytes.ofText("x".repeat(0xFFFF - 6)))).told().length());
    }

    @Test
    void and_partThatDoesNotFit_throws() {
        ActionNames first = new ActionNames(2, Bytes.ofText("stop\0g"));
        for (ActionNames next : List.of(new ActionNames(2, Bytes.EMPTY), new ActionNames(3, Bytes.ofText("o\0")),
                new ActionNames(2, Bytes.ofText("o\0x")), new ActionNames(2, Bytes.ofText("o\0x\0")),
                new ActionNames(2, Bytes.ofText("x".repeat(0xFFFF))))) {
            assertEquals(ProtocolError.BAD_REPLY,
                    assertThrows(ProtocolException.class, () -> first.and(next)).error(), next.toString());
        }
    }

    @Test
    void request_valuesOutOfRange_throw() {
        Key key = Key.ofHex("00".repeat(16));
        assertThrows(IllegalArgumentException.class, () -> Request.act(""));
        assertThrows(IllegalArgumentException.class, () -> Request.act("\u00e9".repeat(256)));
        assertThrows(IllegalArgumentException.class,
                () -> Request.poll(Request.Percepts.NONE, 0, 0, 256, Request.LastReply.HERE));
        assertThrows(IllegalArgumentException.class,
                () -> Request.poll(Request.Percepts.NONE, 0x10000, 0, 0, Request.LastReply.HERE));
        assertThrows(IllegalArgumentException.class,
                () -> Request.poll(Request.Percepts.NONE, 0, 0x1000000, 0, Request.LastReply.HERE));
        assertThrows(IllegalArgumentException.class, () -> Request.act("x".repeat(511)));
        assertThrows(IllegalArgumentException.class, () -> Request.listActions(0x10000));
        assertThrows(IllegalArgumentException.class, () -> Request.raiseEpoch(-1));
        assertThrows(IllegalArgumentException.class, () -> Request.raiseEpoch(0xFFFFFF));
        assertThrows(IllegalArgumentException.class, () -> Request.setRfId(Address.BROADCAST));
        assertThrows(IllegalArgumentException.class, () -> Request.setKey(Address.BROADCAST, key));
        assertThrows(IllegalArgumentException.class, () -> Request.renewKey(Address.SERIAL, key));
        assertThrows(IllegalArgumentException.class, () -> Request.setSessionKey(Address.parse("//SU"), key));
        assertThrows(IllegalArgumentException.class,
                () -> Request.transmit(Address.SERIAL, Address.parse("ROMA"), new Content(Performative.TELL, "x")));
    }

    @Test
    void request_firstAndLastValues_areCarried() throws ProtocolException {
        assertEquals("As", Request.act("s").frame().message().text());
        assertEquals(Frame.MAX_MESSAGE_LENGTH, Request.act("x".repeat(510)).frame().message().length());
        assertEquals(Bytes.of('C', 0, 0), Request.listActions(0).frame().message());
        assertEquals(Bytes.of('C', 0xFF, 0xFF), Request.listActions(0xFFFF).frame().message());
        assertEquals(Bytes.of('E', 0, 0, 0), Request.raiseEpoch(0).frame().message());
        assertEquals(Bytes.of('E', 0xFF, 0xFF, 0xFE), Request.raiseEpoch(0xFFFFFE).frame().message());
    }

    @Test
    void writesEeprom_command_isWhatChangesAnAddressAnEpochOrAKey() {
        assertEquals(EnumSet.of(Request.Command.SET_RF_ID, Request.Command.RELAYING, Request.Command.RAISE_EPOCH,
                Request.Command.SET_KEY,
                Request.Command.RENEW_KEY, Request.Command.USE_KEY, Request.Command.FINISH_RENEWAL,
                Request.Command.DELETE_KEY),
                Stream.of(Request.Command.values()).filter(Request.Command::writesEeprom).collect(Collectors.toSet()));
    }

    @Test
    void needsRadio_command_isWhatABoardWithoutARadioRefuses() {
        assertEquals(EnumSet.of(Request.Command.HELLO, Request.Command.POLL, Request.Command.ACT,
                Request.Command.LIST_ACTIONS, Request.Command.STATISTICS),
                Stream.of(Request.Command.values()).filter(command -> !command.needsRadio())
                        .collect(Collectors.toSet()));
    }

    @Test
    void isTime_counter_isWhatCountsNothing() {
        assertEquals(EnumSet.of(Counter.LOOP_MILLIS, Counter.PERCEPTS_MILLIS, Counter.ACTION_MILLIS,
                Counter.RADIO_LATE_MICROS, Counter.RADIO_AIRTIME, Counter.AIRTIME_WAIT),
                Stream.of(Counter.values()).filter(Counter::isTime).collect(Collectors.toSet()));
    }

    @Test
    void of_numberOfACounter_isTheCounter() {
        for (Counter counter : Counter.values()) {
            assertEquals(Optional.of(counter), Counter.of(counter.number()));
        }
    }

    @Test
    void toString_keyInside_hidesIt() {
        Key key = Key.ofHex("ab".repeat(16));
        assertFalse(Request.setKey(Address.parse("ROMA"), key).toString().contains("abab"));
        assertFalse(Request.renewKey(Address.parse("ROMA"), key).toString().contains("abab"));
        assertFalse(Request.setSessionKey(Address.parse("ROMA"), key).toString().contains("abab"));
        assertFalse(key.toString().contains("abab"));
    }
}
