package bench;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Values of one kind. */
final class Samples {

    private final List<Double> values = new ArrayList<>();

    synchronized void add(double value) {
        values.add(value);
    }

    synchronized double median() {
        return sorted().get(values.size() / 2);
    }

    synchronized double greatest() {
        return Collections.max(values);
    }

    private List<Double> sorted() {
        return values.stream().sorted().toList();
    }
}
