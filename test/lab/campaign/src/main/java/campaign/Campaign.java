package campaign;

import harness.Report;

/** A question that takes many tries to answer. */
public interface Campaign {

    /** One word, by which it can be asked for alone. */
    String name();

    /**
     * Tries, and reports what came of it. All that it has started has ended when this returns or throws.
     *
     * @throws Exception where it could not be carried out; then nothing is shown.
     */
    void run(Settings settings, Report report) throws Exception;
}
