package javino.cli;

import java.io.PrintWriter;

import javino.Printable;

/** What an examination finds, written a line each: ok, or what to do. */
final class Findings {

    private final PrintWriter out;
    private boolean healthy = true;

    Findings(PrintWriter out) {
        this.out = out;
    }

    void ok(String what, Object found) {
        line(what, "ok, " + found);
    }

    void trouble(String what, String remedy) {
        healthy = false;
        line(what, remedy);
    }

    /** Whether there was no trouble. */
    boolean areHealthy() {
        return healthy;
    }

    private void line(String what, String text) {
        out.println(Printable.of(InfoCommand.line(what, text)));
    }
}
