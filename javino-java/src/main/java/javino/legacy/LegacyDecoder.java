package javino.legacy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javino.protocol.Bytes;

/**
 * Finds messages of the older protocol in the bytes of a serial line, however they are split (SPEC 8.1). They have no
 * checksum: what looks like a message is taken for one. All else is skipped and counted. Not for several threads.
 */
public final class LegacyDecoder {

    /** What the next byte is to be, if nothing is damaged. */
    private enum State {
        /** The first letter of the preamble; between messages. */
        FIRST_F,
        SECOND_F,
        THIRD_F,
        /** The last letter of the preamble; one more f than there should be is no harm. */
        E,
        SIZE_HIGH,
        SIZE_LOW,
        TEXT
    }

    private static final int HEXADECIMAL = 16;

    private final byte[] text = new byte[LegacyMessage.MAX_LENGTH];
    private State state = State.FIRST_F;
    /** Bytes since the message under way began. */
    private int begun;
    private int size;
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
            if (state == State.TEXT) {
                int taken = Math.min(count - at, size - length);
                System.arraycopy(bytes, at, text, length, taken);
                length += taken;
                begun += taken;
                at += taken;
            } else {
                accept(bytes[at] & 0xFF);
                at++;
            }
            if (state == State.TEXT && length == size) {
                messages.add(new LegacyMessage(Bytes.copyOf(Arrays.copyOf(text, length))));
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
        boolean underWay = begun > 0;
        skipped += begun;
        restart();
        return underWay;
    }

    /** How many bytes belonged to no message, so far. */
    public long skipped() {
        return skipped;
    }

    /** Takes a byte that comes before the text. */
    private void accept(int value) {
        begun++;
        switch (state) {
            case FIRST_F -> expect(value == 'f', State.SECOND_F);
            case SECOND_F -> expect(value == 'f', State.THIRD_F);
            case THIRD_F -> expect(value == 'f', State.E);
            case E -> {
                if (value == 'f') {
                    skipped++;
                    begun--;
                } else {
                    expect(value == 'e', State.SIZE_HIGH);
                }
            }
            case SIZE_HIGH, SIZE_LOW -> size(value);
            case TEXT -> throw new IllegalStateException("a text is not taken byte by byte");
        }
    }

    private void expect(boolean asExpected, State next) {
        if (asExpected) {
            state = next;
        } else {
            abandon();
        }
    }

    private void size(int value) {
        int digit = value < 0x80 ? Character.digit(value, HEXADECIMAL) : -1;
        if (digit < 0) {
            abandon();
        } else {
            size = size * HEXADECIMAL + digit;
            state = state == State.SIZE_HIGH ? State.SIZE_LOW : State.TEXT;
        }
    }

    private void restart() {
        state = State.FIRST_F;
        begun = 0;
        size = 0;
        length = 0;
    }
}
