package trace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import org.junit.jupiter.api.Test;

class TransitionHandlerTest {

    @Test
    void publish_transitionThatItsFilterLeavesOut_isNotWritten() {
        List<Map<String, ?>> written = new ArrayList<>();
        TransitionHandler handler = new TransitionHandler(written::add);
        LogRecord transition = new LogRecord(Level.FINE, "");
        transition.setParameters(new Object[] {"departure", "SUAA", "SUBB", "01", "GONE"});
        handler.setFilter(any -> false);
        handler.publish(transition);
        handler.setFilter(any -> true);

        handler.publish(transition);

        assertEquals(List.of(Map.of("do", "transition", "machine", "departure", "host", "SUAA", "peer", "SUBB", "id",
                "01", "state", "gone")), written);
    }
}
