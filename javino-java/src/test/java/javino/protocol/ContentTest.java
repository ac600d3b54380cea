package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class ContentTest {

    @ParameterizedTest
    @EnumSource(Force.class)
    void decode_eachForce_roundTrips(Force force) throws ProtocolException {
        Content content = new Content(force, "goTo(12,\"km;\u00e9\")");
        assertEquals(content, Content.decode(content.encode()));
    }

    @Test
    void decode_severalDividers_firstDivides() throws ProtocolException {
        assertEquals(new Content(Force.TELL, ";a;"), Content.decode(Bytes.ofText("tell;;a;")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ";", "tell", "tell;", ";help", "Tell;help", "ask;help", " tell;help", "\0tell;help"})
    void decode_noContent_throwsBadContent(String text) {
        assertEquals(ProtocolError.BAD_CONTENT,
                assertThrows(ProtocolException.class, () -> Content.decode(Bytes.ofText(text))).error());
    }

    @ParameterizedTest
    @ValueSource(strings = {"74656c6c3bff", "74656c6c3bc3", "74656c6c3bc080", "74656c6c3beda080", "80"})
    void decode_noUtf8_throwsBadText(String hex) {
        assertEquals(ProtocolError.BAD_TEXT,
                assertThrows(ProtocolException.class, () -> Content.decode(Bytes.ofHex(hex))).error());
    }

    @Test
    void length_inBytesOfUtf8_is494AtMost() throws ProtocolException {
        Content longest = new Content(Force.TELL, "\u00e9".repeat(244) + "x");
        assertEquals(Content.MAX_LENGTH, longest.encode().length());
        assertEquals(longest, Content.decode(longest.encode()));
        assertThrows(IllegalArgumentException.class, () -> new Content(Force.TELL, "\u00e9".repeat(245)));
        Bytes tooLong = Bytes.ofText("tell;" + "x".repeat(490));
        assertEquals(ProtocolError.TOO_LONG,
                assertThrows(ProtocolException.class, () -> Content.decode(tooLong)).error());
    }

    @Test
    void parse_content_isReadAtItsFirstDivider() {
        assertEquals(new Content(Force.ACHIEVE, "say(\"a;b\")"), Content.parse("achieve;say(\"a;b\")"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"help", "tell;", "shout;help", "tell;\ud800"})
    void parse_noContent_throws(String text) {
        assertThrows(IllegalArgumentException.class, () -> Content.parse(text));
    }

    @Test
    void constructor_emptyOrUnencodableTerm_throws() {
        assertThrows(IllegalArgumentException.class, () -> new Content(Force.TELL, ""));
        assertThrows(IllegalArgumentException.class, () -> new Content(Force.TELL, "\ud800"));
    }

    @Test
    void limits_areThoseOfTheSpec() {
        assertEquals(67, Content.MAX_BROADCAST_LENGTH);
        assertEquals(53, Content.MAX_SEALED_LENGTH);
        assertEquals(494, Content.MAX_LENGTH);
        // Of a poll reply with one message: status and flags, type and length, number, two addresses, id.
        int besidesContent = 2 + 3 + 1 + 2 * Address.LENGTH + 3;
        assertEquals(Frame.MAX_MESSAGE_LENGTH, Content.MAX_LENGTH + besidesContent);
    }
}
