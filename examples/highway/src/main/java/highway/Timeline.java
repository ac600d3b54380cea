package highway;

import java.io.PrintStream;
import java.util.Locale;
import java.util.Map;

/** The run on the terminal: one line an observation, then the table. */
final class Timeline {

    private static final int GREY = 90;
    private static final int GREEN = 32;
    private static final int RED = 31;
    private static final String ERASE_REST = "\033[K";

    private final PrintStream out;
    private final boolean coloured;

    Timeline(PrintStream out, boolean coloured) {
        this.out = out;
        this.coloured = coloured;
    }

    /** A line as it is, such as an address. */
    void plain(String text) {
        out.println(text);
    }

    /** A line about the run itself. */
    void note(String text) {
        println(paint(GREY, text));
    }

    /** A line about what went wrong. */
    void warn(String text) {
        println(paint(RED, text));
    }

    void show(Observation seen) {
        println(String.format(Locale.ROOT, "%8.3f s  ", seen.seconds()) + line(seen));
    }

    private String line(Observation seen) {
        String route = seen.who() + " → " + seen.to();
        return who(seen.who()) + switch (seen.kind()) {
            case SAYS -> "says   " + seen.text();
            case WARNS -> paint(RED, "warns  " + seen.text());
            case SENDS -> "sends  " + route + "  plain  " + seen.text();
            case SEALED -> "sends  " + route + paint(GREEN, "  sealed");
            case HOSTS -> paint(GREY, "hosts  " + route + "  " + seen.text());
            case ACKS -> paint(GREY, "acks   " + seen.text());
            case LOSES -> paint(RED, "loses  " + seen.text());
            case PIN -> paint(GREY, seen.text());
        };
    }

    private String who(String origin) {
        return Device.withAddress(origin).map(this::who).orElse(String.format("%-10s ", origin));
    }

    private String who(Device device) {
        return paint(device.colour, String.format("%-10s ", device.title()));
    }

    /**
     * The table of the behaviours with a mark each, and the last line.
     *
     * @param behaviours what is missing of each; empty if it was observed.
     */
    void table(Map<String, String> behaviours) {
        println("");
        int row = 0;
        for (Map.Entry<String, String> behaviour : behaviours.entrySet()) {
            boolean observed = behaviour.getValue().isEmpty();
            String[] parts = behaviour.getKey().split(" ", 3);
            println(String.format(" %d  %s%s %s", ++row, who(parts[1].replace(":", "")),
                    observed ? paint(GREEN, "✓") : paint(RED, "✗"), parts[2]));
            if (!observed) {
                println(paint(RED, "                 " + behaviour.getValue()));
            }
        }
        long observed = behaviours.values().stream().filter(String::isEmpty).count();
        println("");
        println("highway: " + observed + " of " + behaviours.size() + " behaviours observed");
    }

    /** Shows the model's verdict on the run. */
    void verdict(String text, boolean good) {
        println(good ? text : paint(RED, text));
    }

    /** Gradle counts colours as columns, and so would leave the end of its progress line behind a line with colours. */
    private void println(String line) {
        out.println(coloured ? line + ERASE_REST : line);
    }

    private String paint(int colour, String text) {
        return coloured ? "\033[" + colour + "m" + text + "\033[0m" : text;
    }
}
