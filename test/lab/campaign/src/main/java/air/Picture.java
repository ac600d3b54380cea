package air;

import harness.Table;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/** The air as SVG: a row for each board, time from left to right, in lines below each other. */
final class Picture {

    private static final int WIDTH = 1200;
    private static final int LEFT = 120;
    private static final int RIGHT = 24;
    private static final int ROW = 16;
    private static final int BAR = 12;
    private static final int HEAD = 80;
    private static final int GAP = 34;
    private static final int LETTER = 5;
    private static final double LINE_SECONDS = 2;
    private static final int MOST_TICKS = 12;
    private static final String RED = "#d00000";
    private static final String TRAILER = "#222";
    private static final String JAM = "#ccc";

    private final AirTrace trace;
    private final List<Packet> packets;
    private final List<String> boards;
    private final double from;
    private final double to;
    private final double line;
    private final StringBuilder svg = new StringBuilder();

    /** @param packets in the order of their beginnings */
    Picture(AirTrace trace, List<Packet> packets, double from, double to) {
        this.trace = trace;
        this.packets = packets.stream().filter(packet -> packet.overlaps(from, to)).toList();
        boards = trace.boards().stream()
                .filter(board -> this.packets.stream().anyMatch(packet -> packet.board.equals(board))).toList();
        this.from = from;
        this.to = to;
        line = Math.min(LINE_SECONDS, to - from);
    }

    /** @param below text that stands below the picture */
    String svg(String below) {
        int lines = (int) Math.ceil((to - from) / line - 1e-9);
        int height = HEAD + lines * (boards.size() * ROW + GAP);
        List<String> text = below.lines().toList();
        add("<svg xmlns='http://www.w3.org/2000/svg' width='%1$d' height='%2$d' viewBox='0 0 %1$d %2$d' "
                + "font-family='sans-serif' font-size='11'>", WIDTH, height + (text.size() + 2) * ROW);
        add("<title>The air from %.3f s to %.3f s</title>", from, to);
        add("<rect width='100%%' height='100%%' fill='white'/>");
        legend();
        for (int i = 0; i < lines; i++) {
            line(from + i * line, HEAD + i * (boards.size() * ROW + GAP));
        }
        for (int i = 0; i < text.size(); i++) {
            add("<text x='10' y='%d' font-family='monospace' xml:space='preserve'>%s</text>",
                    height + (i + 1) * ROW, escaped(text.get(i)));
        }
        return svg.append("</svg>\n").toString();
    }

    private void add(String format, Object... values) {
        svg.append(Table.text(format, values)).append('\n');
    }

    private void legend() {
        int x = 10;
        for (Packet.Kind kind : Packet.Kind.values()) {
            x = legend(x, kind.title, kind.colour);
        }
        legend(legend(x, "trailer", TRAILER), "jam", JAM);
        add("<text x='10' y='38'>Number: slots since its sender heard the air become quiet. <tspan fill='%1$s'>Red "
                + "line</tspan>: it collided: another was on the air that some board heard too. <tspan fill='%1$s'>✗n"
                + "</tspan>: damaged at n boards. Point at a packet to see more.</text>", RED);
        String marks = Arrays.stream(Cause.values()).map(cause -> cause.mark + " " + cause.title)
                .collect(Collectors.joining(", "));
        add("<text x='10' y='56'>Letter: why it began all the same, or was damaged: %s.</text>", marks);
    }

    private int legend(int x, String title, String colour) {
        add("<rect x='%d' y='10' width='24' height='%d' fill='%s'/><text x='%d' y='20'>%s</text>", x, BAR, colour,
                x + 28,
                title);
        return x + 50 + title.length() * 6;
    }

    private void line(double begin, int top) {
        double end = Math.min(to, begin + line);
        int bottom = top + boards.size() * ROW;
        double tick = tick();
        for (int i = 0; i <= MOST_TICKS; i++) {
            double t = (Math.ceil(begin / tick - 1e-6) + i) * tick;
            if (t > end + tick * 1e-6) {
                break;
            }
            add("<path d='M%.1f %dV%d' stroke='#ddd'/><text x='%.1f' y='%d' fill='#555' text-anchor='middle'>%s"
                    + "</text>", x(t, begin), top, bottom + 3, x(t, begin), bottom + 14, time(t, tick));
        }
        for (int row = 0; row < boards.size(); row++) {
            int y = top + row * ROW;
            add("<path d='M%d %dH%.1f' stroke='#eee'/><text x='%d' y='%d' text-anchor='end'>%s</text>", LEFT,
                    y + ROW, x(end, begin), LEFT - 6, y + BAR, escaped(trace.title(boards.get(row))));
        }
        for (AirTrace.Jam jam : trace.jams()) {
            stretch(jam.start(), jam.end(), begin, end, top, boards.size() * ROW, JAM);
        }
        packets.stream().filter(packet -> packet.overlaps(begin, end))
                .forEach(packet -> bar(packet, begin, end, top + boards.indexOf(packet.board) * ROW + 2));
    }

    private void bar(Packet packet, double begin, double end, int y) {
        add("<g><title>%s</title>", escaped(words(packet)));
        stretch(packet.start, packet.end, begin, end, y, packet.kind.colour);
        stretch(packet.bodyEnd, packet.end, begin, end, y, TRAILER);
        overlaps(packet).forEach(each -> stretch(each[0], each[1], begin, end, y + BAR - 3, 4, RED));
        double left = x(Math.max(packet.start, begin), begin);
        String label = packet.start < begin ? "" : label(packet);
        if (length(packet.start, Math.min(packet.end, end)) > LETTER * label.length() + 4) {
            add("<text x='%.1f' y='%d' font-size='9' fill='white'>%s</text>", left + 2, y + 8, label);
        }
        if (!packet.damagedAt.isEmpty() && packet.end <= end) {
            add("<text x='%.1f' y='%d' font-size='10' font-weight='bold' fill='%s'>✗%d</text>",
                    x(packet.end, begin) + 1, y + 10, RED, packet.damagedAt.size());
        }
        add("</g>");
    }

    private static String label(Packet packet) {
        String slots = Double.isNaN(packet.quietSlots) ? ""
                : packet.quietSlots > 99 ? "&gt;99" : Table.text("%.1f", packet.quietSlots);
        return packet.cause == null ? slots : packet.cause.mark + " " + slots;
    }

    private void stretch(double start, double stop, double begin, double end, int y, String colour) {
        stretch(start, stop, begin, end, y, BAR, colour);
    }

    private void stretch(double start, double stop, double begin, double end, int y, int height, String colour) {
        double left = Math.max(start, begin);
        double right = Math.min(stop, end);
        if (left < right) {
            add("<rect x='%.1f' y='%d' width='%.1f' height='%d' fill='%s'/>", x(left, begin), y,
                    length(left, right), height, colour);
        }
    }

    /** When another was on the air, in stretches that do not overlap. */
    private static List<double[]> overlaps(Packet packet) {
        List<double[]> stretches = new ArrayList<>();
        packet.met.stream().sorted(Comparator.comparingDouble(other -> other.start)).forEach(other -> {
            double start = Math.max(packet.start, other.start);
            double end = Math.min(packet.end, other.end);
            if (!stretches.isEmpty() && stretches.get(stretches.size() - 1)[1] >= start) {
                double[] last = stretches.get(stretches.size() - 1);
                last[1] = Math.max(last[1], end);
            } else {
                stretches.add(new double[] {start, end});
            }
        });
        return stretches;
    }

    private String words(Packet packet) {
        StringBuilder words =
                new StringBuilder(Table.text("%s: %s %s, %.4f s to %.4f s", packet.board, packet.kind.title,
                        packet.address, packet.start, packet.end));
        if (!packet.trailer.isEmpty()) {
            words.append(", with ").append(packet.trailer);
        }
        if (!Double.isNaN(packet.quietSlots)) {
            words.append(
                    Table.text("; began %.2f slots after its sender heard the air become quiet", packet.quietSlots));
        }
        for (Packet other : packet.met) {
            words.append(Table.text("; collided with that of %s, which began %.2f slots %s", other.board,
                    Math.abs(packet.start - other.start) / packet.slot,
                    other.start > packet.start ? "later" : "before"));
        }
        if (packet.cause != null) {
            words.append("; ").append(packet.cause.title).append(": ").append(packet.cause.meaning);
        }
        if (!packet.damagedAt.isEmpty()) {
            words.append("; damaged at ").append(String.join(", ", packet.damagedAt));
        }
        return words.toString();
    }

    private double x(double seconds, double begin) {
        return LEFT + (seconds - begin) * (WIDTH - LEFT - RIGHT) / line;
    }

    private double length(double start, double end) {
        return (end - start) * (WIDTH - LEFT - RIGHT) / line;
    }

    /** The least of 1, 2, 5, 10, … with which a line has not too many marks. */
    private double tick() {
        double power = Math.pow(10, Math.floor(Math.log10(line / MOST_TICKS)));
        for (int factor : new int[] {1, 2, 5}) {
            if (power * factor * MOST_TICKS >= line) {
                return power * factor;
            }
        }
        return power * 10;
    }

    private static String time(double seconds, double tick) {
        int places = (int) Math.max(1, Math.ceil(-Math.log10(tick) - 1e-9));
        return Table.text("%." + places + "f s", seconds);
    }

    private static String escaped(String text) {
        // XML knows no other control characters than these, and no halves of surrogate pairs.
        return text.replaceAll("[^\\t\\x20-\\uD7FF\\uE000-\\uFFFD\\x{10000}-\\x{10FFFF}]", "?").replace("&", "&amp;")
                .replace("<", "&lt;").replace(">", "&gt;");
    }
}
