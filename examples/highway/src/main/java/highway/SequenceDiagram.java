package highway;

import highway.Observation.Kind;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import javino.protocol.Address;

/** A run as a picture: a lifeline for each device, and going down, in the order of time, what it said, sent and did. */
final class SequenceDiagram {

    private static final int WIDTH = 1000;
    private static final int FIRST_LIFELINE = 130;
    private static final int BETWEEN_LIFELINES = 190;
    private static final int HEAD = 56;
    private static final int ROW = 30;
    /** Pixels that a monospaced letter of 11 pixels takes. */
    private static final double LETTER = 6.6;
    private static final int PADDING = 8;
    private static final Set<Kind> SHOWN = EnumSet.of(Kind.SAYS, Kind.PIN, Kind.SENDS, Kind.SEALED, Kind.HOSTS);
    private static final String TRAVELLER = "#fff3b0";

    private final List<Observation> shown = new ArrayList<>();
    private final Set<Observation> known = new HashSet<>();

    /**
     * Adds what was seen, if it is the first of its kind: a packet that is sent once more tells nothing new. The
     * picture begins when something is sent or done.
     */
    void add(Observation seen) {
        boolean begins = seen.kind() != Kind.SAYS || !shown.isEmpty();
        if (begins && SHOWN.contains(seen.kind()) && known.add(seen.once())) {
            shown.add(seen);
        }
    }

    /** Writes the picture as SVG. */
    void write(Path file) throws IOException {
        Files.writeString(file, svg(), StandardCharsets.UTF_8);
    }

    private String svg() {
        int height = HEAD + ROW * (shown.size() + 1);
        StringBuilder svg = new StringBuilder(String.format("""
            <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %1$d %2$d" font-family="sans-serif" font-size="12">
            <title>The highway: what five agents said, sent and did</title>
            <rect width="%1$d" height="%2$d" fill="white"/>
            """, WIDTH, height));
        for (Device device : Device.values()) {
            svg.append(lifeline(device, height));
        }
        for (int row = 0; row < shown.size(); row++) {
            svg.append(row(shown.get(row), HEAD + ROW * (row + 1)));
        }
        return svg.append("</svg>\n").toString();
    }

    private static String lifeline(Device device, int height) {
        int x = x(device);
        return String.format("""
            <marker id="%6$s" markerUnits="userSpaceOnUse" markerWidth="11" markerHeight="8" refX="11" refY="4"
                orient="auto">
            <path d="M0,0 L11,4 L0,8 Z" fill="%4$s"/></marker>
            <line x1="%1$d" y1="%2$d" x2="%1$d" y2="%3$d" stroke="#bbb"/>
            <text x="%1$d" y="24" text-anchor="middle" font-size="15" font-weight="bold" fill="%4$s">%5$s</text>
            <text x="%1$d" y="42" text-anchor="middle" fill="#555">%6$s</text>
            """, x, HEAD, height - ROW / 2, device.hue, device.title(), device.address);
    }

    private static String row(Observation seen, int y) {
        // The words of an agent have no time of their own: they came between two events.
        if (seen.kind() == Kind.SAYS) {
            // Another agent than the device's own has its name before what it says: it travels.
            return box(seen, "“" + seen.text() + "”", y, seen.text().startsWith("[") ? TRAVELLER : "white");
        }
        String time =
                String.format(Locale.ROOT, "<text x=\"58\" y=\"%d\" text-anchor=\"end\" fill=\"#777\">%.3f s</text>%n",
                        y + 4, seen.seconds());
        return time + (seen.kind() == Kind.PIN ? box(seen, seen.text(), y, "#eee") : arrows(seen, y));
    }

    /** The words or the act of a device: a box that begins at its lifeline, and the last one's ends there. */
    private static String box(Observation seen, String text, int y, String fill) {
        Device device = Device.withAddress(seen.who()).orElseThrow();
        int length = (int) Math.round(text.length() * LETTER);
        int left = Math.min(x(device) - PADDING, WIDTH - length - 3 * PADDING);
        // By its textLength the text fits its box where monospaced letters are narrower, too.
        return String.format("""
            <rect x="%d" y="%d" width="%d" height="20" rx="6" fill="%s" stroke="%s"/>
            <text x="%d" y="%d" textLength="%d" font-family="monospace" font-size="11">%s</text>
            """, left, y - 10, length + 2 * PADDING, fill, device.hue, left + PADDING, y + 4, length, escaped(text));
    }

    /** A packet: an arrow to each device that it is for, and above it what an eavesdropper can read. */
    private static String arrows(Observation packet, int y) {
        Device from = Device.withAddress(packet.who()).orElseThrow();
        List<Device> receivers = receivers(packet.who(), packet.to());
        boolean sealed = packet.kind() == Kind.SEALED;
        String label = packet.to() + "  " + (sealed ? "sealed" : packet.text());
        String tips = receivers.stream().map(to -> String.format("""
            <line x1="%d" y1="%d" x2="%d" y2="%2$d" stroke="%s" stroke-width="2" marker-end="url(#%s)"%s/>
            """, x(from), y, x(to), from.hue, from.address, sealed ? "" : " stroke-dasharray=\"6 3\""))
                .collect(Collectors.joining());
        int middle = receivers.stream().mapToInt(SequenceDiagram::x).filter(x -> x > x(from)).min()
                .orElseGet(() -> receivers.stream().mapToInt(SequenceDiagram::x).max().orElse(x(from)));
        return tips + String.format("<text x=\"%d\" y=\"%d\" text-anchor=\"middle\" fill=\"%s\">%s</text>%n",
                (x(from) + middle) / 2, y - 5, from.hue, escaped(label));
    }

    private static List<Device> receivers(String origin, String destination) {
        Address to = Address.parse(destination);
        return Arrays.stream(Device.values()).filter(device -> !device.address.equals(origin))
                .filter(device -> to.reaches(Address.parse(device.address))).toList();
    }

    private static int x(Device device) {
        return FIRST_LIFELINE + BETWEEN_LIFELINES * device.ordinal();
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
