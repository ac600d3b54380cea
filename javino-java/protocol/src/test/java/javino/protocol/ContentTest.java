package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.google.gson.JsonObject;
import java.util.EnumSet;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class ContentTest {

    private static final VectorFile FILE = new VectorFile("contents.json");

    static Stream<JsonObject> valid() {
        return FILE.list("valid");
    }

    static Stream<JsonObject> invalid() {
        return FILE.list("invalid");
    }

    @ParameterizedTest
    @MethodSource("valid")
    void decode_validVector_hasItsPartsAndRoundTrips(JsonObject vector) throws ProtocolException {
        Bytes bytes = VectorFile.bytes(vector, "content");
        Content content = Content.decode(bytes);
        assertEquals(VectorFile.text(vector, "performative"), content.performative().toString());
        assertEquals(vector.get("conversation").isJsonNull() ? Optional.empty()
                : Optional.of(new Conversation(vector.get("conversation").getAsInt())), content.conversation());
        assertEquals(VectorFile.text(vector, "term"), content.term());
        assertEquals(bytes, content.encode());
        assertEquals(bytes, new Content(content.performative(), content.conversation(), content.term()).encode());
    }

    @ParameterizedTest
    @MethodSource("invalid")
    void decode_invalidVector_throwsItsError(JsonObject vector) {
        assertEquals(VectorFile.text(vector, "error"), assertThrows(ProtocolException.class,
                () -> Content.decode(VectorFile.bytes(vector, "content"))).error().name(),
                VectorFile.text(vector, "why"));
    }

    @Test
    void decode_vectors_haveEachPerformative() {
        assertEquals(EnumSet.allOf(Performative.class), valid().map(vector -> VectorFile.text(vector, "performative"))
                .map(name -> Performative.of(name).orElseThrow()).collect(Collectors.toSet()));
    }

    @ParameterizedTest
    @EnumSource(Performative.class)
    void constructor_conversationWhereNoneBelongs_throws(Performative performative) {
        boolean may = performative.isQuestion() || performative.canAnswer();
        boolean must = performative.isQuestion() || performative == Performative.SORRY;
        Optional<Conversation> some = Optional.of(new Conversation(7));
        if (may) {
            assertEquals(some, new Content(performative, some, "x").conversation());
        } else {
            assertThrows(IllegalArgumentException.class, () -> new Content(performative, some, "x"));
        }
        if (must) {
            assertThrows(IllegalArgumentException.class, () -> new Content(performative, "x"));
        } else {
            assertEquals(Optional.empty(), new Content(performative, "x").conversation());
        }
    }

    @Test
    void requiresSeal_performative_isWhatWantsAnAnswerGivesOneOrTouchesPlans() {
        assertEquals(
                EnumSet.of(Performative.ASK_ONE, Performative.ASK_ALL, Performative.ASK_HOW, Performative.TELL_HOW,
                        Performative.UNTELL_HOW,
                        Performative.SORRY),
                Stream.of(Performative.values()).filter(Performative::requiresSeal).collect(Collectors.toSet()));
    }

    @ParameterizedTest
    @CsvSource({"tell;x,false", "tell#AbC;x,true", "sorry#AbC;x,true", "askOne#AbC;x,false"})
    void isAnswer_content_isAnAnswersPerformativeWithAConversation(String content, boolean answer) {
        assertEquals(answer, Content.parse(content).isAnswer());
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 1 << 18})
    void conversation_outOfRange_throws(int id) {
        assertThrows(IllegalArgumentException.class, () -> new Conversation(id));
    }

    @Test
    void length_inBytesOfUtf8_is494AtMost() throws ProtocolException {
        Content longest = new Content(Performative.TELL, "\u00e9".repeat(244) + "x");
        assertEquals(Content.MAX_LENGTH, longest.encode().length());
        assertEquals(longest, Content.decode(longest.encode()));
        assertThrows(IllegalArgumentException.class, () -> new Content(Performative.TELL, "\u00e9".repeat(245)));
        Bytes tooLong = Bytes.ofText("tell;" + "x".repeat(490));
        assertEquals(ProtocolError.TOO_LONG,
                assertThrows(ProtocolException.class, () -> Content.decode(tooLong)).error());
    }

    @Test
    void parse_content_isReadAtItsFirstDivider() {
        assertEquals(new Content(Performative.ACHIEVE, "say(\"a;b\")"), Content.parse("achieve;say(\"a;b\")"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"help", "tell;", "shout;help", "tell;\ud800"})
    void parse_noContent_throws(String text) {
        assertThrows(IllegalArgumentException.class, () -> Content.parse(text));
    }

    @Test
    void constructor_emptyOrUnencodableTerm_throws() {
        assertThrows(IllegalArgumentException.class, () -> new Content(Performative.TELL, ""));
        assertThrows(IllegalArgumentException.class, () -> new Content(Performative.TELL, "\ud800"));
    }

    @Test
    void limit_longestContent_fitsOnePollReply() {
        assertEquals(494, Content.MAX_LENGTH);
        // The rest of a poll reply with one message: status and flags, type and length, number, two addresses, id.
        int besidesContent = 2 + 3 + 1 + 2 * Address.LENGTH + 3;
        assertEquals(Frame.MAX_MESSAGE_LENGTH, Content.MAX_LENGTH + besidesContent);
    }
}
