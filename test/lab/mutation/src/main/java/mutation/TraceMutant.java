package mutation;

import java.util.List;
import java.util.function.Supplier;

/**
 * A trace with one small change.
 *
 * @param operator the kind of change
 * @param event    the event that was changed, e.g. {@code rf-tx unicast}
 * @param line     its line, from 1
 * @param detail   the change in full; empty where the operator says it
 * @param lines    the trace with it
 */
record TraceMutant(String operator, String event, int line, String detail, Supplier<List<String>> lines) {
    @Override
    public String toString() {
        return operator + ": " + event + (detail.isEmpty() ? "" : ", " + detail);
    }
}
