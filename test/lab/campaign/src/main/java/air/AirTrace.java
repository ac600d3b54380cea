package air;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import javino.protocol.Airtime;
import trace.TraceEvent;
import trace.TraceReader;

/** The events on the air that a trace of the emulator (emulator/README.md) tells. */
final class AirTrace {

    /** How far apart the starts of a packet may lie that its sender and a receiver see, in seconds. */
    private static final double LATENESS = 0.005;
    private static final double LAST_SECOND = 1e9;
    private static final int FRAGMENTS = 8;
    private static final int HEADER_DIGITS = 20;

    /** A jam, in seconds. */
    record Jam(double start, double end) {}

    /** A packet has reached a board. */
    private record Heard(String board, String from, double start, boolean damaged) {}

    /** Transmissions began to overlap at a board. */
    private record Overlap(String board, double at, Set<String> sources) {}

    private final Map<String, TreeMap<Double, Packet>> sent = new HashMap<>();
    private final List<Heard> heard = new ArrayList<>();
    private final List<Overlap> overlaps = new ArrayList<>();
    private final List<Jam> jams = new ArrayList<>();
    private final Set<String> seen = new HashSet<>();
    private final Map<String, String> ids = new HashMap<>();

    private AirTrace() {}

    /**
     * Reads a trace.
     *
     * @throws trace.MalformedEventException if a line is none of a trace
     */
    static AirTrace read(Path file) throws IOException {
        AirTrace trace = new AirTrace();
        TraceReader.read(file, trace::add);
        trace.heard.forEach(trace::match);
        trace.overlaps.forEach(trace::match);
        return trace;
    }

    private void add(TraceEvent event) {
        switch (event.name()) {
            case "rf-tx" -> {
                Packet packet = packet(event);
                sent.computeIfAbsent(packet.board, board -> new TreeMap<>()).put(packet.start, packet);
            }
            case "rf-rx", "rf-damaged" -> {
                if (event.has("from")) {
                    heard.add(new Heard(event.board(), event.text("from"), real(event, "start"),
                            event.name().equals("rf-damaged")));
                }
            }
            case "rf-collision" -> {
                overlaps.add(new Overlap(event.board(), event.seconds(), new TreeSet<>(event.texts("boards"))));
            }
            case "fault" -> {
                if (event.text("do").equals("jam")) {
                    jams.add(new Jam(event.seconds(), real(event, "until")));
                }
            }
            default -> {} // not of the air
        }
    }

    private static double real(TraceEvent event, String field) {
        double value = event.real(field);
        if (!(value >= 0 && value <= LAST_SECOND)) {
            throw event.wrong("an event '" + event.name() + "' whose '" + field + "' is no time");
        }
        return value;
    }

    private Packet packet(TraceEvent event) {
        double start = real(event, "start");
        double end = real(event, "end");
        int bits = event.number("bits");
        if (start >= end || bits < Airtime.bits(0)) {
            throw event.wrong("a packet that takes no time");
        }
        String payload = event.text("payload");
        String kind = event.text("kind");
        String origin = event.textOrEmpty("origin");
        String address = origin.isEmpty() ? "" : origin + " → " + event.text("destination");
        ids.put(event.board(), origin);
        String trailer = event.textOrEmpty("trailer");
        return new Packet(event.board(), start, end, bits, payload.length(), kind(event, kind, payload), address,
                trailer);
    }

    private Packet.Kind kind(TraceEvent event, String kind, String payload) {
        return switch (kind) {
            case "unicast" -> seen.add(payload) ? Packet.Kind.FIRST : Packet.Kind.REPEAT;
            // Whether a fragment wants an answer may differ from one time to the next.
            case "fragment" ->
                seen.add(event.text("origin") + event.number("id") + "/" + event.number("index") % FRAGMENTS
                        + payload.substring(Math.min(HEADER_DIGITS, payload.length()))) ? Packet.Kind.FRAGMENT
                                : Packet.Kind.REPEAT;
            case "multicast", "broadcast" -> seen.add(payload) ? Packet.Kind.TO_MANY : Packet.Kind.REPEAT;
            case "acknowledgement" -> Packet.Kind.ACKNOWLEDGEMENT;
            default -> Packet.Kind.OTHER;
        };
    }

    private void match(Heard arrival) {
        Collection<Packet> near = sent.getOrDefault(arrival.from, new TreeMap<>())
                .subMap(arrival.start - LATENESS, arrival.start + LATENESS).values();
        near.stream().findFirst().ifPresent(packet -> {
            packet.heardBy.add(arrival.board);
            if (arrival.damaged) {
                packet.damagedAt.add(arrival.board);
            }
        });
    }

    private void match(Overlap overlap) {
        for (String source : overlap.sources) {
            Map.Entry<Double, Packet> last = sent.getOrDefault(source, new TreeMap<>()).floorEntry(overlap.at);
            if (last != null && last.getValue().end > overlap.at - LATENESS
                    && last.getValue().damagedAt.contains(overlap.board)) {
                last.getValue().beside.addAll(overlap.sources);
                last.getValue().beside.remove(source);
            }
        }
    }

    /** All packets, in the order of their beginnings. */
    List<Packet> packets() {
        return sent.values().stream().flatMap(each -> each.values().stream())
                .sorted(Comparator.comparingDouble((Packet packet) -> packet.start)
                        .thenComparing(packet -> packet.board))
                .toList();
    }

    List<Jam> jams() {
        return jams;
    }

    /** A board's name, and the id under which it sent last. */
    String title(String board) {
        String id = ids.getOrDefault(board, "");
        return id.isEmpty() ? board : board + " " + id;
    }

    /** The boards that have sent something, {@code board10} behind {@code board9}. */
    Set<String> boards() {
        Set<String> names = new TreeSet<>(Comparator.comparingInt(String::length).thenComparing(name -> name));
        names.addAll(sent.keySet());
        return names;
    }
}
