package diffuser;

import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;

import org.junit.jupiter.params.provider.CsvSource;

/** The transitions of the paper's figure 1: from a state, by a symbol of its alphabet, to a state. */
@Retention(RetentionPolicy.RUNTIME)
@CsvSource({
        "OPEN,           -com, LIMITED_OPEN",
        "OPEN,           -mob, CLOSED",
        "CLOSED,         -com, TOTALLY_CLOSED",
        "CLOSED,         +mob, OPEN",
        "LIMITED_OPEN,   +com, OPEN",
        "LIMITED_OPEN,   -mob, TOTALLY_CLOSED",
        "TOTALLY_CLOSED, +com, CLOSED",
        "TOTALLY_CLOSED, +mob, LIMITED_OPEN",
})
@interface FigureOne {}
