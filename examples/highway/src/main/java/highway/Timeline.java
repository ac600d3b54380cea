package highway;

import highway.Observation.Acknowledged;
import highway.Observation.Aired;
import highway.Observation.Hosts;
import highway.Observation.Pin;
import highway.Observation.Printed;
import highway.Observation.Spoilt;
import highway.Observation.Warned;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;

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
        if (seen instanceof Printed line) {
            return who(line.device()) + "says   " + line.text();
        }
        if (seen instanceof Aired aired) {
            return who(aired.origin()) + "sends  " + packet(aired);
        }
        if (seen instanceof Hosts hosts) {
            return who(hosts.origin()) + paint(GREY, "hosts  " + hosts.origin() + " → " + hosts.destination() + "  "
                    + hosts.words());
        }
        if (seen instanceof Acknowledged answer) {
            return who(answer.origin()) + paint(GREY, "acks   " + answer.answers());
        }
        if (seen instanceof Pin pin) {
            return who(pin.device()) + paint(GREY, pin.words());
        }
        if (seen instanceof Warned warned) {
            return who(warned.device()) + paint(RED, "warns  " + warned.text());
        }
        Spoilt spoilt = (Spoilt) seen;
        return who(spoilt.device()) + paint(RED, "loses  " + spoilt.why());
    }

    private String packet(Aired aired) {
        String route = aired.origin() + " → " + aired.destination();
        return aired.sealed() ? route + paint(GREEN, "  sealed") : route + "  plain  " + aired.content();
    }

    private String who(String origin) {
        return Device.withAddress(origin).map(this::who).orElse(String.format("%-10s ", origin));
    }

    private String who(Device device) {
        return paint(device.colour, String.format("%-10s ", device.title()));
    }

    /** The table of the behaviours with a mark each, what is missing, and the last line. */
    void table(List<Behaviour> behaviours) {
        println("");
        for (int row = 0; row < behaviours.size(); row++) {
            Behaviour behaviour = behaviours.get(row);
            String mark = behaviour.observed() ? paint(GREEN, "✓") : paint(RED, "✗");
            println(String.format(" %d  %s%s %s", row + 1, who(behaviour.device), mark, behaviour.text));
            for (String missing : behaviour.missing()) {
                println(paint(RED, "                 " + missing));
            }
        }
        long observed = behaviours.stream().filter(Behaviour::observed).count();
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
