package javino.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import javino.Printable;

/** The findings of an examination, written a line each: ok, or what to do. */
final class Findings {

    private final PrintWriter out;
    private final List<String> troubles = new ArrayList<>();

    Findings(PrintWriter out) {
        this.out = out;
    }

    void ok(String what, Object found) {
        line(what, "ok, " + found);
    }

    void trouble(String what, String remedy) {
        troubles.add(what);
        line(what, remedy);
    }

    /** The findings that were not ok. */
    List<String> troubles() {
        return troubles;
    }

    private void line(String what, String text) {
        out.println(Printable.of(String.format("%-19s %s", what, text)));
    }
}
