package javino.legacy;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javino.protocol.Bytes;

/**
 * Finds messages of the older protocol in the bytes of a serial line, however they are split (SPEC 8.1). They have no
 * checksum: what looks like a message is taken for one. All else is skipped and counted. Not for several threads.
 */
public final class LegacyDecoder {

    /** All that comes before a text. */
    private static final Pattern BEGINNING = Pattern.compile(LegacyMessage.PREAMBLE + "([0-9A-Fa-f]{2})");
    private static final int HEXADECIMAL = 16;

    /** The characters before the text of the message under way. */
    private final StringBuilder beginning = new StringBuilder();
    /** The text, as far as {@link #length}; null before its size is known. */
    private byte[] text;
    private int length;
    private long skipped;

    /**
     * Takes bytes from the line.
     *
     * @param bytes read from.
     * @param count the first so many of them count.
     * @return the messages that ended in them, in order.
     */
    public List<LegacyMessage> feed(byte[] bytes, int count) {
        List<LegacyMessage> messages = new ArrayList<>(1);
        int at = 0;
        while (at < count) {
            if (text == null) {
                accept((char) (bytes[at] & 0xFF));
                at++;
            } else {
                int taken = Math.min(count - at, text.length - length);
                System.arraycopy(bytes, at, text, length, taken);
                length += taken;
                at += taken;
            }
            if (text != null && length == text.length) {
                messages.add(new LegacyMessage(Bytes.copyOf(text)));
                restart();
            }
        }
        return messages;
    }

    /**
     * Forgets a message that has begun and is not expected to end.
     *
     * @return whether there was one.
     */
    public boolean abandon() {
        int begun = beginning.length() + length;
        skipped += begun;
        restart();
        return begun > 0;
    }

    /** How many bytes belonged to no message, so far. */
    public long skipped() {
        return skipped;
    }

    private void accept(char next) {
        beginning.append(next);
        Matcher matcher = BEGINNING.matcher(beginning);
        if (matcher.matches()) {
            text = new byte[Integer.parseInt(matcher.group(1), HEXADECIMAL)];
        } else if (beginning.toString().equals("ffff")) {
            // An f more than there should be is no harm.
            beginning.deleteCharAt(0);
            skipped++;
        } else if (!matcher.hitEnd()) {
            abandon();
        }
    }

    private void restart() {
        beginning.setLength(0);
        text = null;
        length = 0;
    }
}
