package bench;

import java.util.List;

/** Something that is measured. */
interface Subject {

    /** One word, by which it can be asked for alone. */
    String name();

    /** Sentences for the full report: how it is measured, and what the figures do not say. */
    String method();

    /** Measures. */
    List<Row> measure() throws Exception;
}
