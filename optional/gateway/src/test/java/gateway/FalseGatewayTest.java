package gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;

import gateway.Router.Whom;
import java.util.Comparator;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.function.Consumer;
import javino.Counts;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Two cells and their gateways in emulated time, and a false gateway with a name and a password of its own. */
class FalseGatewayTest implements PlayedCell.Clock {

    private static final int MESSAGES = 8;
    private static final int CELLS = 2;
    private static final long DELAY_MILLIS = 30;
    private static final int JUNK_BYTES = 60;
    /** More attempts than a sender makes. */
    private static final int ENOUGH = 9;
    private static final String FALSE = "false";
    private static final Address SENDER = PlayedCell.device(0, 1);
    private static final Address RECEIVER = PlayedCell.device(1, 2);

    private final PriorityQueue<Event> events =
            new PriorityQueue<>(Comparator.comparingLong(Event::at).thenComparing(Event::order));
    private final Node[] nodes = new Node[CELLS];
    private boolean attacks;
    private long now = 1_000_000;
    private int order;
    private int junk;
    private Bytes copied = Bytes.EMPTY;
    private int attempt;

    private record Event(long at, int order, Runnable what) {
    }

    @Override
    public long now() {
        return now;
    }

    @Override
    public void schedule(Runnable what, long millis) {
        events.add(new Event(now + millis, order++, what));
    }

    private void run(long until) {
        while (!events.isEmpty() && events.peek().at <= until) {
            Event next = events.poll();
            now = next.at;
            next.what.run();
        }
        now = until;
    }

    /** A cell and the router of its gateway. */
    private final class Node implements Radio.Listener {
        private final String name;
        private final PlayedCell cell;
        private final Radio radio;
        private final Router router;

        Node(int number) {
            name = "c" + number;
            cell = new PlayedCell(number, CELLS, FalseGatewayTest.this, 1, () -> RECEIVER);
            radio = cell.open(this);
            router = new Router(name, false, Set.of(), new Counts<>(), now);
        }

        @Override
        public void online(String firmware) {
            // It is from the start.
        }

        @Override
        public void offline(String why) {
            // It never is.
        }

        @Override
        public void damaged() {
            // Nothing is.
        }

        @Override
        public void heard(Bytes packet) {
            step(new RouterEvent.Heard(packet));
        }

        void arrives(String from, Whom whom, int attempt, Bytes packet, long left) {
            schedule(() -> step(new RouterEvent.Arrived(from, whom, attempt, packet, now + left, true)), DELAY_MILLIS);
        }

        void step(RouterEvent event) {
            for (RouterEffect effect : router.step(event, now)) {
                if (effect instanceof RouterEffect.Relay relay) {
                    radio.relay(relay.frame()).thenAccept(sent -> step(new RouterEvent.Relayed(sent)));
                } else if (effect instanceof RouterEffect.Publish publish) {
                    publish(publish);
                } else if (effect instanceof RouterEffect.Ask ask) {
                    each(node -> node.step(new RouterEvent.Asked(name, ask.device())));
                } else if (effect instanceof RouterEffect.Tell tell) {
                    each(node -> {
                        if (node.name.equals(tell.cell())) {
                            node.step(new RouterEvent.Told(name, tell.device(), tell.age()));
                        }
                    });
                }
            }
        }

        private void publish(RouterEffect.Publish publish) {
            boolean isForAll = publish.whom() == Whom.SEARCH;
            each(node -> {
                if (isForAll || node.name.equals(publish.name())) {
                    node.arrives(name, publish.whom(), publish.attempt(), publish.packet(), Router.LIFE_MILLIS);
                }
            });
            if (attacks && (isForAll || publish.name().equals(FALSE))) {
                attack(publish.packet());
            }
        }

        private void each(Consumer<Node> what) {
            for (Node node : nodes) {
                if (node != this) {
                    schedule(() -> what.accept(node), DELAY_MILLIS);
                }
            }
        }
    }

    /** Within its share of the air: something to wait for, and copies that have no time to wait. */
    private void attack(Bytes packet) {
        nodes[1].arrives(FALSE, Whom.CELL, 1, junk(JUNK_BYTES), Router.LIFE_MILLIS);
        int last = copied.equals(packet) ? attempt + 1 : ENOUGH;
        for (attempt = copied.equals(packet) ? last : 1; attempt < last; attempt++) {
            nodes[1].arrives(FALSE, Whom.CELL, attempt, packet, DELAY_MILLIS);
        }
        nodes[1].arrives(FALSE, Whom.CELL, attempt, packet, DELAY_MILLIS);
        copied = packet;
    }

    private Bytes junk(int bytes) {
        return new Frame(PlayedCell.device(1, PlayedCell.DEVICES), PlayedCell.device(5, 1),
                Bytes.ofNumber(junk++, bytes))
                .encode();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void unicasts_thatAFalseGatewayCopiesInVain_areDelivered(boolean attacked) {
        attacks = attacked;
        for (int i = 0; i < CELLS; i++) {
            nodes[i] = new Node(i);
        }
        nodes[1].heard(new Frame(Address.BROADCAST, RECEIVER, Bytes.ofText("tell;here")).encode());
        for (int i = 0; i < MESSAGES; i++) {
            if (attacks) {
                Bytes claim = new Frame(SENDER, RECEIVER, Bytes.ofNumber(junk++, 20)).encode();
                nodes[0].arrives(FALSE, Whom.CELL, 1, claim, Router.LIFE_MILLIS);
            }
            run(now + 10 * DELAY_MILLIS);
            nodes[0].cell.send(SENDER, RECEIVER);
            run(now + 60_000);
        }
        assertEquals("0 0 " + MESSAGES + " " + MESSAGES + " 0 0 0 0", nodes[0].cell.count().toString());
    }
}
