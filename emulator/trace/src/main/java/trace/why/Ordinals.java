package trace.why;

import com.google.gson.JsonObject;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import trace.TraceEvent;

/**
 * Numbers what both an agent and its board tell: the n-th request of one kind is the same for both, and the n-th
 * message that a board has queued is the n-th that it hands over. Older lines may be forgotten then.
 */
final class Ordinals {

    /** The field with the number, from 0. */
    static final String NTH = "nth";
    /** Of these the board never hears. */
    private static final Set<String> UNREACHED = Set.of("port_off", "queue_full", "too_long");
    private static final int MOST_COUNTS = 10_000;

    private List<JsonObject> boards = List.of();
    private final Map<String, String> ports = new HashMap<>();
    private final Map<String, Integer> counts = new HashMap<>();
    /** What agents' requests that go on have asked for. */
    private final Map<String, String> requests = new HashMap<>();

    /** It with its number, if it is of a kind that has one. All events of a run, in their order. */
    TraceEvent number(TraceEvent event) {
        String board = event.board();
        switch (event.name()) {
            case "scenario" -> boards = History.boards(event);
            case "reset" -> counts.remove(board + " queued");
            case "agent-settings" -> settings(event.text("agent"), event.text("port"));
            case "agent-performed" -> {
                String key = requests.remove(request(event));
                if (key != null && isUnreached(event)) {
                    counts.merge(key, -1, Integer::sum);
                }
            }
            case "agent-action", "agent-sends" -> {
                String key = key("of " + event.text("agent"), event);
                requests.put(request(event), key);
                return numbered(event, key);
            }
            case "host-action", "host-transmit" -> {
                return numbered(event, key("at " + board, event));
            }
            case "point" -> {
                return event.text("name").equals("QUEUED") ? numbered(event, board + " queued") : event;
            }
            default -> {
                // It is no request.
            }
        }
        return event;
    }

    static boolean isUnreached(TraceEvent performed) {
        return UNREACHED.contains(performed.text("error"));
    }

    private static String request(TraceEvent event) {
        return event.text("agent") + " " + event.text("request");
    }

    private static String key(String who, TraceEvent request) {
        return who + "\n" + request.textOrEmpty("action") + request.textOrEmpty("content");
    }

    private TraceEvent numbered(TraceEvent event, String key) {
        if (event.has(NTH)) {
            return event;
        }
        if (counts.size() > MOST_COUNTS) {
            counts.clear();
        }
        return event.with(NTH, counts.merge(key, 1, Integer::sum) - 1);
    }

    /** An agent that comes to a board counts on from there. */
    private void settings(String agent, String port) {
        if (!port.equals(ports.put(agent, port))) {
            String own = "of " + agent + "\n";
            String its = "at " + History.board(port, boards) + "\n";
            counts.keySet().removeIf(each -> each.startsWith(own));
            Map.copyOf(counts).forEach((key, count) -> {
                if (key.startsWith(its)) {
                    counts.put(own + key.substring(its.length()), count);
                }
            });
        }
    }

    /** Agents that are recorded anew count anew. */
    void forget(Predicate<String> agents) {
        ports.keySet().removeIf(agents);
        requests.clear();
    }
}
