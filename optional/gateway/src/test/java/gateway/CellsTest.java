package gateway;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javino.Counts;
import javino.protocol.Bytes;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Routers of three cells, two of them in one, over a broker that delays. */
class CellsTest {

    private static final String[][] GATEWAYS = {{"a", "a1"}, {"b", "b1"}, {"b", "b2"}, {"c", "c1"}};
    private static final int REPEATS = 5;

    private final PriorityQueue<Event> events = new PriorityQueue<>(Comparator.comparingLong(Event::at));
    private final Map<String, Integer> sent = new HashMap<>();
    private final Map<String, Integer> onAir = new HashMap<>();
    private final List<Node> nodes = new ArrayList<>();
    private Random random;
    private long now = 100_000;
    private int slowest;
    private double hears;

    private record Event(long at, Runnable what) {
    }

    /** A gateway whose board hears its cell, all but itself. */
    private final class Node {
        private final String cell;
        private final String name;
        private final Router router;
        private final Map<Node, Long> last = new HashMap<>();
        private final Set<String> served = new HashSet<>();

        Node(String cell, String name) {
            this.cell = cell;
            this.name = name;
            router = new Router(cell, true, Set.of(), new Counts<>(), now);
        }

        void hears(Bytes frame) {
            if (random.nextDouble() < hears) {
                step(new RouterEvent.Heard(frame));
            }
        }

        /** Has the broker deliver something to the gateways that want it: in order, and one in ten twice. */
        private void send(Predicate<Node> wanted, Consumer<Node> what) {
            nodes.stream().filter(node -> node != this && wanted.test(node)).forEach(node -> {
                long at = Math.max(last.getOrDefault(node, 0L), now + 5 + random.nextInt(slowest));
                last.put(node, at);
                events.add(new Event(at, () -> what.accept(node)));
                if (random.nextInt(10) == 0) {
                    events.add(new Event(at, () -> what.accept(node)));
                }
            });
        }

        private void step(RouterEvent event) {
            for (RouterEffect effect : router.step(event, now)) {
                if (effect instanceof RouterEffect.Publish publish) {
                    send(node -> switch (publish.whom()) {
                        case CELL -> node.cell.equals(publish.name());
                        case GROUP -> node.served.contains("//" + publish.name());
                        case SEARCH, BROADCAST -> true;
                    }, node -> node.step(new RouterEvent.Arrived(cell, publish.whom(), publish.attempt(),
                            publish.packet(), now + Router.LIFE_MILLIS, !node.name.equals("b2"))));
                } else if (effect instanceof RouterEffect.Ask ask) {
                    send(node -> node.served.contains(ask.device().toString()),
                            node -> node.step(new RouterEvent.Asked(cell, ask.device())));
                } else if (effect instanceof RouterEffect.Tell tell) {
                    send(node -> node.cell.equals(tell.cell()),
                            node -> node.step(new RouterEvent.Told(cell, tell.device(), tell.age())));
                } else if (effect instanceof RouterEffect.Serve serve && serve.wanted()) {
                    served.add(serve.address().toString());
                } else if (effect instanceof RouterEffect.Serve serve) {
                    served.remove(serve.address().toString());
                } else if (effect instanceof RouterEffect.Relay relay) {
                    events.add(new Event(now + 200 + random.nextInt(500),
                            () -> {
                                air(cell, relay.frame().encode(), this);
                                step(new RouterEvent.Relayed(true));
                            }));
                }
            }
        }
    }

    private void air(String cell, Bytes frame, Node by) {
        (by == null ? sent : onAir).merge(cell + frame, 1, Integer::sum);
        nodes.stream().filter(node -> node != by && node.cell.equals(cell)).forEach(node -> node.hears(frame));
    }

    private void run(int slowestMillis, double share, int frames) {
        random = new Random(slowestMillis);
        slowest = slowestMillis;
        hears = share;
        for (String[] gateway : GATEWAYS) {
            nodes.add(new Node(gateway[0], gateway[1]));
        }
        for (int i = 0; i < frames; i++) {
            String cell = GATEWAYS[random.nextInt(GATEWAYS.length)][0];
            String from = cell.toUpperCase() + "AA" + (char) ('A' + random.nextInt(4));
            String to = GATEWAYS[random.nextInt(GATEWAYS.length)][0].toUpperCase() + "AA"
                    + (char) ('A' + random.nextInt(4));
            Bytes frame = switch (random.nextInt(4)) {
                case 0 -> Frames.of("////", from, Bytes.ofNumber(i, 6));
                case 1 -> Frames.sealed("//" + to.substring(0, 2), from, i);
                default -> Frames.sealed(to, from, i);
            };
            int repeats = 1 + random.nextInt(REPEATS);
            for (int k = 0; k < repeats; k++) {
                events.add(new Event(now + i * 1000L + k * 600L, () -> air(cell, frame, null)));
            }
        }
        while (!events.isEmpty()) {
            Event next = events.poll();
            now = next.at;
            next.what.run();
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 30, 300, 1000})
    void frame_isOnTheAirOfAnotherCellAtMostAsOftenAsItsOriginSentIt(int slowestMillis) {
        run(slowestMillis, 0.8, 2000);
        assertTrue(onAir.size() > 1000, "" + onAir.size());
        Map<String, Integer> byOrigin = new HashMap<>();
        sent.forEach((key, count) -> byOrigin.put(key.substring(1), count));
        onAir.forEach((key, count) -> assertTrue(count <= byOrigin.get(key.substring(1)), key + ": " + count));
        assertTrue(onAir.keySet().stream().noneMatch(sent::containsKey), "relayed in its own cell");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 30})
    void broadcast_whereAllIsHeard_isOnTheAirOfEachCellAndNoMoreOftenThanItsOriginSentIt(int slowestMillis) {
        run(slowestMillis, 1, 1000);
        sent.forEach((key, count) -> {
            if (key.startsWith(Bytes.ofText("////").hex(), 1)) {
                for (String other : List.of("a", "b", "c")) {
                    if (!key.startsWith(other)) {
                        int there = onAir.getOrDefault(other + key.substring(1), 0);
                        assertTrue(there >= 1 && there <= count, other + key + ": " + there + " of " + count);
                    }
                }
            }
        });
    }
}
