package campaign;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** The plan of faults, of their boards and times: mixed, and each pair of boards at its own times. */
final class FaultPlan {

    /** The time from one fault of a pair to its next: to recover, and for a host to start. */
    static final double BETWEEN_SECONDS = 8;
    private static final int MOST_WRITES = 30;

    private FaultPlan() {}

    /**
     * Makes a plan.
     *
     * @param each  how many faults of each kind.
     * @param begin emulated time of the first ones.
     */
    static List<Fault> of(long seed, int pairs, int each, double begin) {
        Random random = new Random(seed);
        List<Fault.Kind> kinds = new ArrayList<>();
        for (Fault.Kind kind : Fault.Kind.values()) {
            kinds.addAll(Collections.nCopies(each, kind));
        }
        Collections.shuffle(kinds, random);
        List<Fault> faults = new ArrayList<>();
        for (int i = 0; i < kinds.size(); i++) {
            double second = begin + i / pairs * BETWEEN_SECONDS + random.nextDouble();
            faults.add(new Fault(kinds.get(i), i % pairs, random.nextInt(2), second, 1 + random.nextInt(MOST_WRITES)));
        }
        return faults;
    }

    /** Emulated time at which the last one has had time to pass. */
    static double end(List<Fault> faults) {
        return faults.stream().mapToDouble(Fault::second).max().orElseThrow() + BETWEEN_SECONDS;
    }
}
