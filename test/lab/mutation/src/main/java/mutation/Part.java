package mutation;

import harness.Report;

/** A kind of thing that mutants are made of. */
interface Part {

    /** One word, by which it can be asked for alone. */
    String name();

    /** The head of its section in docs/results.md. */
    String section();

    /**
     * Tries, and reports what was killed.
     *
     * @throws Exception where it could not be carried out
     */
    void run(Options options, Report report) throws Exception;
}
