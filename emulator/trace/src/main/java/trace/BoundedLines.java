package trace;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;

/** Reads lines, of which one may be too long: of that it keeps no more than the beginning. */
public final class BoundedLines implements AutoCloseable {

    /** The longest events are those of many boards, and take some thousands. */
    public static final int MOST_CHARACTERS = 1 << 18;

    /** The mark that some editors put before a text. */
    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private final BufferedReader in;
    private boolean first = true;

    /** Lines of UTF-8. */
    public BoundedLines(InputStream in) {
        this.in = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
    }

    /** The next line without its end, cut off where it is too long; null after the last. */
    public String next() throws IOException {
        StringBuilder line = new StringBuilder();
        int character = in.read();
        if (first && character == BYTE_ORDER_MARK) {
            character = in.read();
        }
        first = false;
        if (character < 0) {
            return null;
        }
        for (; character >= 0 && character != '\n'; character = in.read()) {
            // In an event a carriage return is white space; on the way to the page it would end a line.
            if (character != '\r' && line.length() < MOST_CHARACTERS) {
                line.append((char) character);
            }
        }
        return line.toString();
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
