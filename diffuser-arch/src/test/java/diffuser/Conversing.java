package diffuser;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

import javino.fake.FakeBoard;

/** Questions and answers on the line to a fake board, for tests. */
final class Conversing {

    private static final Pattern REQUEST = Pattern.compile("(\\S+ \\w+)#([A-Za-z0-9+/]{3});(.*)");

    private Conversing() {
    }

    /** The board is asked next to send what begins a conversation, {@code ROMA askOne;p(X)} but for its digits. */
    static String asked(FakeBoard board, String expected) {
        String request = RunningAgent.next(board.requests, "a request");
        Matcher parts = REQUEST.matcher(request);
        assertTrue(parts.matches(), request);
        assertTrue((parts.group(1) + ";" + parts.group(3)).matches(expected), request);
        return parts.group(2);
    }
}
