package harness;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;

/**
 * The report of one campaign, or of another program that measures: its progress while it runs, then claims, text,
 * tables, aims and violations.
 */
public final class Report {

    private final String name;
    private final PrintStream progress;
    private final List<String> claims = new ArrayList<>();
    private final List<String> markdown = new ArrayList<>();
    private final List<String> screen = new ArrayList<>();
    private final List<String> aims = new ArrayList<>();
    private final List<String> violations = new ArrayList<>();
    private final List<String> refused = new ArrayList<>();
    private int rules;

    /** @param progress the stream for the lines of {@link #progress}. */
    public Report(String name, PrintStream progress) {
        this.name = name;
        this.progress = progress;
    }

    /** Shows at once, on one line, how far it is. */
    public void progress(String format, Object... values) {
        progress.println(name + ": " + Table.text(format, values));
    }

    /**
     * A line of docs/results.md.
     *
     * @param spread that over seeds, runs or kinds; may be empty.
     */
    public void claim(String what, String figure, String spread) {
        claims.add("- " + what + ": **" + figure + "**" + (spread.isEmpty() ? "" : " (" + spread + ")"));
    }

    /** Sentences: how it was done, what was seen, what the figures do not say. Markdown, for the full report only. */
    public void text(String sentences) {
        markdown.add(sentences.strip());
    }

    /** A table, for full report and screen. */
    public void table(Table table) {
        markdown.add(table.markdown());
        screen.add(table.text());
    }

    /** Something that was to be reached, as often as not for one machine only, and whether it was. */
    public void aim(String what, boolean reached) {
        aims.add("- " + what + ": " + (reached ? "reached" : "**not reached**"));
        if (!reached) {
            claims.add("- **not reached**: " + what);
        }
        screen.add(what + ": " + (reached ? "reached" : "NOT REACHED"));
    }

    /**
     * Something that must hold always.
     *
     * @param what  the thing counted, e.g. {@code "delivered twice"}.
     * @param count how often it was seen; any fails the run.
     */
    public void never(String what, long count) {
        rules++;
        aims.add("- never: " + what + ": " + count + (count == 0 ? "" : " (**violated**)"));
        screen.add("never: " + what + ": " + count);
        if (count != 0) {
            violations.add(name + ": " + what + ": " + count);
        }
    }

    /**
     * A run that the replay refuses: all others count, and the campaign fails at its end. For any thread.
     *
     * @param why with its seed and where its trace is.
     */
    public synchronized void refused(String why) {
        progress("refused by the replay: %s", why);
        refused.add(why);
    }

    /** The rules that were violated, and the runs that were refused; empty if all held. */
    public synchronized List<String> violations() {
        List<String> all = new ArrayList<>(violations);
        if (!refused.isEmpty()) {
            all.add(name + ": runs that the replay refuses: " + refused.size() + "\n" + String.join("\n", refused));
        }
        return all;
    }

    /** The whole, for a screen. */
    public String screen() {
        return String.join("\n", screen);
    }

    /** The claims, the aims that were not reached, and how many rules were broken; Markdown. */
    public String claims() {
        List<String> lines = new ArrayList<>(claims);
        if (rules != 0) {
            lines.add("- rules broken: **" + violations().size() + "** of " + rules);
        }
        return String.join("\n", lines);
    }

    /** The full report, without its head and claims. */
    public String markdown() {
        List<String> parts = new ArrayList<>(markdown);
        if (!aims.isEmpty()) {
            parts.add(String.join("\n", aims));
        }
        return String.join("\n\n", parts);
    }
}
