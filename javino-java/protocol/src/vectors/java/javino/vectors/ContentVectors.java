package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.text;

import java.util.Base64;
import java.util.List;
import java.util.Map;

/** SPEC 3: each performative, alone and in a conversation, then what is no content. */
final class ContentVectors {

    private ContentVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("valid", List.of(
                valid("tell", null, "help"),
                valid("untell", null, "help[source(self)]"),
                valid("achieve", null, "goTo(12,\"km\")"),
                valid("unachieve", null, "goTo(_,_)"),
                valid("signal", null, "sirenHeard"),
                valid("tellHow", null, "{ @stop +!stop <- .act(stop) }"),
                valid("tellHow", null, "\"+!stop <- .act(stop).\""),
                valid("untellHow", null, "stop"),
                valid("askOne", "AbC", "speed(X)"),
                valid("askAll", "//+", "near(Who,_)"),
                valid("askHow", "AAA", "{ +!stop }"),
                valid("tell", "AbC", "speed(80)"),
                valid("tell", "///", "[near(bus1,3),near(bus2,7)]"),
                valid("tell", "AbC", "80"),
                valid("untell", "AAB", "speed(X)"),
                valid("tellHow", "+9z", "[{ @stop +!stop <- .act(stop) }]"),
                valid("sorry", "AbC", "\"too_long\""),
                valid("tell", null, ";a;"),
                valid("tell", null, "#AbC;help"),
                valid("tell", null, "say(\"\u00e9\u20ac\ud83d\ude00;\")"),
                valid("tell", null, "\u00e9".repeat(244) + "x"),
                valid("askOne", "AbC", "x".repeat(483))));
        lists.put("invalid", List.of(
                invalid("", "empty"), invalid(";", "no performative and no term"), invalid("tell", "no divider"),
                invalid("tell;", "no term"), invalid(";help", "no performative"), invalid("Tell;help", "a capital"),
                invalid("ask;help", "an unknown performative"), invalid(" tell;help", "a space before"),
                invalid("tell ;help", "a space after"), invalid("\0tell;help", "NUL before"),
                invalid("askone;help", "a capital is missing"), invalid("ask-one#AbC;help", "Jason's older name"),
                invalid("askOne;free(X)", "a question without a conversation"),
                invalid("askAll;free(X)", "a question without a conversation"),
                invalid("askHow;{ +!g }", "a question without a conversation"),
                invalid("sorry;\"too_long\"", "an answer to nothing"),
                invalid("achieve#AbC;go", "no answer"), invalid("unachieve#AbC;go", "no answer"),
                invalid("signal#AbC;go", "no answer"), invalid("move;R", "a host's, and no agent's"),
                invalid("untellHow#AbC;stop", "no answer"),
                invalid("tell#;help", "no digits"), invalid("tell#Ab;help", "two digits"),
                invalid("tell#AbCD;help", "four digits"), invalid("tell#Ab-;help", "- is no digit"),
                invalid("tell#A\u00e9;help", "\u00e9 is no digit"), invalid("tell##AbC;help", "two marks"),
                invalid("tell#AbC#AbC;help", "two conversations"), invalid("#AbC;help", "no performative"),
                invalid("tell#AbC;", "no term"), invalid("tell#AbC", "no divider"),
                invalid(join(text("tell;"), new byte[] {(byte) 0xFF}), "BAD_TEXT", "0xFF is no UTF-8"),
                invalid(join(text("tell;"), new byte[] {(byte) 0xC3}), "BAD_TEXT", "half a character"),
                invalid(join(text("tell;"), new byte[] {(byte) 0xC0, (byte) 0x80}), "BAD_TEXT", "NUL in two bytes"),
                invalid(text("tell;" + "x".repeat(490)), "TOO_LONG", "495 bytes"),
                invalid(text("askOne#AbC;" + "x".repeat(484)), "TOO_LONG", "495 bytes")));
        return lists;
    }

    private static Map<String, Object> valid(String performative, String conversation, String term) {
        String head = conversation == null ? performative : performative + "#" + conversation;
        return vector("text", head + ";" + term, "content", Wire.hex(text(head + ";" + term)), "performative",
                performative,
                "conversation", conversation == null ? null : number(conversation), "term", term);
    }

    /** Three digits as a number: with a digit of value 0 before them they are three bytes. */
    private static int number(String digits) {
        byte[] bytes = Base64.getDecoder().decode("A" + digits);
        return (bytes[0] & 0xFF) << 16 | (bytes[1] & 0xFF) << 8 | bytes[2] & 0xFF;
    }

    private static Map<String, Object> invalid(String text, String why) {
        return invalid(text(text), "BAD_CONTENT", why);
    }

    private static Map<String, Object> invalid(byte[] bytes, String error, String why) {
        return vector("content", Wire.hex(bytes), "error", error, "why", why);
    }
}
