package trace.why;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Queue;
import java.util.TreeMap;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import trace.EmulatorControl;
import trace.MalformedEventException;
import trace.TraceEvent;
import trace.TraceReader;

/** The run's log, {@code build/run.jsonl}: the boards' trace and the last lines of the agents, in the order of time. */
public final class RunLog {

    /** Lines are left out by so many, so that a busy agent does not wait for that. */
    private static final int PORTION = 1000;
    /** The agents' last lines; older ones are left out, but for plans and settings among the first {@link #PORTION}. */
    public static final int KEPT_LINES = 10 * PORTION;
    /** Counts the lines that were left out; it stands before the others. */
    static final String LEFT_OUT = "left-out";
    private static final String CLOCK = "clock";
    private static final Pattern KEPT = Pattern.compile("\"event\":\"agent-(plan|settings|believes)\"");
    private static final double MICROS = 1e6;
    /** Of an event, in s. */
    private static final double NEARBY = 5;

    private final double begin;
    /** The last {@link #KEPT_LINES}, and those that came since. */
    private final Deque<List<Supplier<String>>> portions = new ArrayDeque<>(List.of(new ArrayList<>(PORTION)));
    private List<Supplier<String>> newest = portions.getLast();
    /** Of the first portion, once that is left out. */
    private List<String> kept = List.of();
    private int leftOut;
    /** What the clock showed, by the marks in the trace. */
    private final Map<String, Double> clocks = new HashMap<>();

    /**
     * A log without lines.
     *
     * @param begin what the agents' clock shows at the run's beginning, in s.
     */
    public RunLog(double begin) {
        this.begin = begin;
    }

    /**
     * Has an emulator write into its trace that an agents' clock is read now: so their times can be told in the boards'
     * time, also if that pauses or is slow.
     *
     * @param clock in s.
     * @throws IOException if there is no emulator, or it has ended.
     */
    public void show(DoubleSupplier clock, EmulatorControl emulator) throws IOException {
        String mark = String.format(Locale.ROOT, "%.6f", clock.getAsDouble());
        emulator.perform(Map.of("do", "transition", "machine", CLOCK, "host", "agents", "peer", "", "id", "", "state",
                mark));
        double answered = clock.getAsDouble();
        synchronized (this) {
            clocks.put(mark, answered);
        }
    }

    /** Takes a line of an agent, whose text is made when the log is read. */
    public synchronized void add(Supplier<String> line) {
        if (newest.size() == PORTION) {
            if (portions.size() * PORTION > KEPT_LINES) {
                List<Supplier<String>> oldest = portions.remove();
                if (leftOut == 0) {
                    kept = oldest.stream().map(RunLog::text).filter(text -> KEPT.matcher(text).find()).toList();
                    leftOut = -kept.size();
                }
                leftOut += PORTION;
            }
            newest = new ArrayList<>(PORTION);
            portions.add(newest);
        }
        newest.add(line);
    }

    /** Empty if its agent goes on meanwhile, and changes what it is made of. */
    private static String text(Supplier<String> line) {
        try {
            return line.get();
        } catch (RuntimeException changed) {
            return "";
        }
    }

    /** Makes the texts of all lines until now, while the agents can. */
    public synchronized void settle() {
        portions.forEach(portion -> portion.replaceAll(line -> {
            String text = text(line);
            return () -> text;
        }));
    }

    /**
     * Writes all events of the run.
     *
     * @param trace the boards', if there is one; what is no event there, as a line that is cut off, is not written, nor
     *              the agents' lines that a page's server has put there, too.
     * @param into  appears as a whole.
     */
    public synchronized void write(Path trace, Path into) throws IOException {
        boolean boards = Files.exists(trace);
        Queue<TraceEvent> own = new ArrayDeque<>(agents(boards ? clocks(trace) : new TreeMap<>()));
        Path part = into.resolveSibling(into.getFileName() + ".part");
        try (PrintWriter out = new PrintWriter(Files.newBufferedWriter(part))) {
            if (boards) {
                TraceReader.read(Files.newInputStream(trace), event -> {
                    if (event.name().startsWith("agent-")) {
                        return;
                    }
                    while (!own.isEmpty() && own.peek().seconds() < event.seconds()) {
                        out.println(own.remove().line());
                    }
                    out.println(event.line());
                }, none -> {});
            }
            own.forEach(event -> out.println(event.line()));
            if (out.checkError()) {
                throw new IOException(into + " cannot be written; is the disk full?");
            }
        }
        Files.move(part, into, StandardCopyOption.REPLACE_EXISTING);
    }

    /** The agents' lines, in the boards' time. */
    private List<TraceEvent> agents(NavigableMap<Double, Double> told) {
        List<TraceEvent> all = new ArrayList<>();
        List<String> texts = portions.stream().flatMap(List::stream).map(RunLog::text).toList();
        Stream.concat(kept.stream(), texts.stream().filter(text -> !text.isEmpty()))
                .map(text -> TraceEvent.parse(0, text))
                .map(event -> event.with("t", Math.round(seconds(event.seconds(), told) * MICROS) / MICROS))
                .forEach(all::add);
        int gone = leftOut + Collections.frequency(texts, "");
        if (gone > 0 && all.size() > kept.size()) {
            all.add(kept.size(), TraceEvent.parse(0, "{\"t\":%s,\"event\":\"%s\",\"lines\":%d}"
                    .formatted(all.get(kept.size()).seconds(), LEFT_OUT, gone)));
        }
        all.sort(Comparator.comparingDouble(TraceEvent::seconds));
        return all;
    }

    /**
     * The boards' time by what the agents' clock shows: not earlier than it was, as nobody believes what a board has
     * yet to tell. A busy emulator lags behind for moments, so the least lag nearby counts.
     */
    private double seconds(double shown, NavigableMap<Double, Double> told) {
        if (told.isEmpty()) {
            return shown - begin;
        }
        Map.Entry<Double, Double> before = told.floorEntry(shown);
        Map.Entry<Double, Double> after = told.ceilingEntry(shown);
        double ahead = told.subMap(shown - NEARBY, true, shown + NEARBY, true).entrySet().stream()
                .mapToDouble(each -> each.getKey() - each.getValue()).min()
                .orElseGet(() -> told.lastKey() - told.lastEntry().getValue());
        double earliest = before == null ? 0 : before.getValue();
        return Math.max(earliest, after == null ? shown - ahead : Math.min(shown - ahead, after.getValue()));
    }

    private NavigableMap<Double, Double> clocks(Path trace) throws IOException {
        NavigableMap<Double, Double> found = new TreeMap<>();
        try (Stream<String> all = Files.lines(trace, StandardCharsets.ISO_8859_1)) {
            all.filter(line -> line.contains("\"machine\":\"" + CLOCK + "\"")).forEach(line -> {
                try {
                    TraceEvent event = TraceEvent.parse(0, line);
                    found.put(clocks.getOrDefault(event.text("state"), event.real("state")), event.seconds());
                } catch (MalformedEventException cutOff) {
                    // The clocks before it will do.
                }
            });
        }
        return found;
    }
}
