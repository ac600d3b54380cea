package features;

import com.google.gson.JsonObject;
import features.Seen.Kind;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.LongSupplier;
import java.util.function.LongUnaryOperator;
import java.util.function.Supplier;
import java.util.stream.Stream;
import lockstep.AgentProgram;
import trace.TraceEvent;
import trace.why.RunLog;

/** What was seen of the boards and agents of a scenario, in the order in which it happened. */
final class Account implements AgentProgram.Observer {

    private static final int HUNDRED = 100;

    private final LongSupplier clock;
    private final List<Seen> all = new ArrayList<>();
    /** The pins that were ever driven, and how they are. */
    private final Map<String, String> pins = new TreeMap<>();
    private final Map<String, Servo> servos = new TreeMap<>();
    /** The last packet of each board, in hexadecimal digits. */
    private final Map<String, String> payloads = new TreeMap<>();
    /** What came after the last when begins here. */
    private int mark;
    private final RunLog log = new RunLog(0);
    private long whenNanos;

    /** @param clock tells the time of the run. */
    Account(LongSupplier clock) {
        this.clock = clock;
    }

    /** A when: what is expected is to come after it. */
    void mark() {
        mark = all.size();
        whenNanos = clock.getAsLong();
    }

    /** Now the when is done, which by hand takes time. */
    void done() {
        whenNanos = clock.getAsLong();
    }

    /** The time of the last when. */
    long when() {
        return whenNanos;
    }

    /** What was seen since the last when. */
    List<Seen> since() {
        return since(mark);
    }

    List<Seen> since(int from) {
        return all.subList(from, all.size());
    }

    int size() {
        return all.size();
    }

    /** The last packet of a board; null if it has sent none. */
    String payload(String board) {
        return payloads.get(board);
    }

    /** The state of a pin that is high for so many percent of the time. */
    static String state(long percent) {
        return percent == 0 ? "off" : percent == HUNDRED ? "on" : "at " + percent + " %";
    }

    /** How a pin goes that is so then. */
    static String going(String state) {
        return state.replace("at ", "to ");
    }

    /** Takes a line of the emulator's trace. @param seen gives when it was seen from the board's own time. */
    void traced(String line, LongUnaryOperator seen) {
        TraceEvent event = TraceEvent.parse(0, line);
        long own = Math.round(event.seconds() * Window.SECOND);
        long nanos = seen.applyAsLong(own);
        String board = event.board();
        switch (event.name()) {
            case "pin", "pwm" -> {
                double high = Double.parseDouble(event.textOrEmpty("level") + event.textOrEmpty("duty"));
                String state = state(Math.round(HUNDRED * high));
                if (!state.equals(state(board, event.textOrEmpty("name")))) {
                    pins.put(board + "'s " + event.textOrEmpty("name"), state);
                    see(nanos, Kind.PIN, board, event.textOrEmpty("name"), going(state));
                    Servo servo = servo(board, event.textOrEmpty("name"));
                    if (servo.turns(own, high == 1)) {
                        see(nanos, Kind.SERVO, board, event.textOrEmpty("name"), "" + servo);
                    }
                }
            }
            case "rf-tx" -> {
                payloads.put(board, event.textOrEmpty("payload"));
                see(nanos, Kind.PACKET, board, event.textOrEmpty("kind"),
                        "to " + event.textOrEmpty("destination")
                                + (event.textOrEmpty("sealed").equals("true") ? ", sealed"
                                        : " " + event.textOrEmpty("content")));
            }
            case "fault", "crash", "uart", "reset", "port" -> see(nanos, Kind.BOARD, board, event.name(),
                    Stream.of("do", "line", "why", "state").map(event::textOrEmpty)
                            .filter(text -> !text.isEmpty()).findFirst().orElse(""));
            default -> {
                // The trace has it.
            }
        }
    }

    private void see(long nanos, Kind kind, String who, String what, String more) {
        all.add(new Seen(nanos, kind, who, what, more));
    }

    /** Now. */
    void see(Kind kind, String who, String what, String more) {
        see(clock.getAsLong(), kind, who, what, more);
    }

    @Override
    public void printed(String agent, String line) {
        JsonObject printed = new JsonObject();
        printed.addProperty("t", clock.getAsLong() / (double) Window.SECOND);
        printed.addProperty("event", "agent-prints");
        printed.addProperty("agent", agent);
        printed.addProperty("text", line);
        log.add(printed::toString);
        see(Kind.PRINTS, agent, line, "");
    }

    @Override
    public void believes(String agent, String belief, boolean added) {
        see(added ? Kind.BELIEVES : Kind.FORGETS, agent, belief, "");
    }

    @Override
    public void asksFor(String agent, String action) {
        see(Kind.ASKS, agent, action, "");
    }

    @Override
    public void performed(String agent, String action, String error) {
        see(error.isEmpty() ? Kind.PERFORMED : Kind.FAILED, agent, action, error);
    }

    @Override
    public void recorded(Supplier<String> line) {
        log.add(line);
    }

    /** In real time agents do not know the run's. */
    void recordedNow(String line) {
        String now = line.replaceFirst("\"t\":[^,]*", "\"t\":" + clock.getAsLong() / (double) Window.SECOND);
        log.add(() -> now);
    }

    @Override
    public boolean records() {
        return true;
    }

    /** What the agents decided. */
    RunLog log() {
        return log;
    }

    /** What an agent believes now. */
    List<String> beliefs(String agent) {
        Map<String, Boolean> now = new TreeMap<>();
        all.stream().filter(each -> each.is(Kind.BELIEVES, agent) || each.is(Kind.FORGETS, agent))
                .forEach(each -> now.put(each.what(), each.kind() == Kind.BELIEVES));
        return now.keySet().stream().filter(now::get).toList();
    }

    /** How a pin is now. */
    String state(String board, String pin) {
        return pins.getOrDefault(board + "'s " + pin, state(0));
    }

    /** What is at a pin, if it is a servo. */
    Servo servo(String board, String pin) {
        return servos.computeIfAbsent(board + "'s " + pin, none -> new Servo());
    }

    /** The pins that are not off now. */
    List<String> on() {
        return pins.entrySet().stream().filter(each -> !each.getValue().equals(state(0)))
                .map(each -> each.getKey() + (each.getValue().equals(state(HUNDRED)) ? "" : " " + each.getValue()))
                .toList();
    }

    /** Whether an agent has ever come to believe something of that name. */
    boolean everBelieved(String agent, String functor) {
        return all.stream().anyMatch(each -> each.is(Kind.BELIEVES, agent)
                && each.what().split("[(\\[]")[0].equals(functor));
    }
}
