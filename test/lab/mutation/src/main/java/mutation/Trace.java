package mutation;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import trace.TraceEvent;

/** The events of a trace of the emulator, in which some can be changed. */
final class Trace {

    private static final int MICROSECONDS = 6;

    private final List<TraceEvent> events;

    /**
     * A transmission.
     *
     * @param sent  its {@code rf-tx}
     * @param heard the events of other boards that had it
     */
    record Packet(TraceEvent sent, List<TraceEvent> heard) {
        List<TraceEvent> all() {
            List<TraceEvent> all = new ArrayList<>(List.of(sent));
            all.addAll(heard);
            return all;
        }

        double start() {
            return sent.real("start");
        }

        double end() {
            return sent.real("end");
        }

        double middle() {
            return (start() + end()) / 2;
        }

        String board() {
            return sent.board();
        }

        String payload() {
            return sent.text("payload");
        }

        boolean isHeardBy(String board) {
            return heard.stream().anyMatch(event -> event.board().equals(board));
        }
    }

    Trace(List<TraceEvent> events) {
        this.events = new ArrayList<>(events);
    }

    List<TraceEvent> events() {
        return events;
    }

    List<String> lines() {
        return events.stream().map(TraceEvent::line).toList();
    }

    /** All transmissions, in the order of the trace. */
    List<Packet> packets() {
        return events.stream().filter(event -> event.is("rf-tx")).map(sent -> new Packet(sent, events.stream()
                .filter(event -> event.has("from") && event.number("packet") == sent.number("packet")).toList()))
                .toList();
    }

    /** Gives an event's field another value; it stays where it is. */
    void change(TraceEvent event, String field, Object value) {
        replace(event, event.with(field, value));
    }

    /** Puts another event in the place of one. */
    void replace(TraceEvent event, TraceEvent other) {
        events.set(events.indexOf(event), other);
    }

    /** Has an event, with all its times, happen so many seconds later; where that is puts it among the others. */
    void move(TraceEvent event, double seconds) {
        events.remove(event);
        place(moved(event, seconds));
    }

    /** Adds an event where its time says; those of its time stay before it. */
    void place(TraceEvent event) {
        int at = IntStream.range(0, events.size()).filter(i -> events.get(i).seconds() > event.seconds()).findFirst()
                .orElse(events.size());
        events.add(at, event);
    }

    /** It with all its times so many seconds later. */
    static TraceEvent moved(TraceEvent event, double seconds, String... times) {
        TraceEvent moved = event;
        for (String time : times.length > 0 ? times : new String[] {"t", "start", "end", "asked"}) {
            if (event.has(time)) {
                // Times have microseconds, as the emulator writes them.
                moved = moved.with(time, BigDecimal.valueOf(event.real(time) + seconds).setScale(MICROSECONDS,
                        RoundingMode.HALF_UP));
            }
        }
        return moved;
    }
}
