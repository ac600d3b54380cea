package diffuser.mind;

import java.util.Iterator;
import java.util.List;
import java.util.Map;

/** Writes an event as a JSON object in one line: an agent's jars have no library for it. */
final class JsonLine {

    /** Of a longer text only the beginning is written, so that a line stays short. */
    private static final int MOST_CHARACTERS = 400;
    private static final int FIRST_PRINTABLE = 0x20;

    private JsonLine() {
    }

    /** @param object its values are texts, numbers, truth values, lists and objects. */
    static String of(Map<String, ?> object) {
        StringBuilder line = new StringBuilder();
        write(line, object);
        return line.toString();
    }

    private static void write(StringBuilder line, Object value) {
        if (value instanceof Map<?, ?> object) {
            line.append('{');
            for (Iterator<? extends Map.Entry<?, ?>> each = object.entrySet().iterator(); each.hasNext();) {
                Map.Entry<?, ?> field = each.next();
                write(line, field.getKey());
                line.append(':');
                write(line, field.getValue());
                line.append(each.hasNext() ? "," : "");
            }
            line.append('}');
        } else if (value instanceof List<?> list) {
            line.append('[');
            for (int i = 0; i < list.size(); i++) {
                line.append(i == 0 ? "" : ",");
                write(line, list.get(i));
            }
            line.append(']');
        } else if (value instanceof Number || value instanceof Boolean) {
            line.append(value);
        } else {
            text(line, String.valueOf(value));
        }
    }

    private static void text(StringBuilder line, String text) {
        line.append('"');
        for (int i = 0; i < Math.min(text.length(), MOST_CHARACTERS); i++) {
            char character = text.charAt(i);
            if (character == '"' || character == '\\') {
                line.append('\\').append(character);
            } else if (character < FIRST_PRINTABLE || Character.isSurrogate(character)) {
                line.append(String.format("\\u%04x", (int) character));
            } else {
                line.append(character);
            }
        }
        line.append(text.length() > MOST_CHARACTERS ? "…\"" : "\"");
    }
}
