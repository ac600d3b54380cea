package keyagreement;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.HostMessage;

/** The messages for a peer: one at a time is under way, and ends or is sent again; each ends within a minute. */
final class MessageQueue {

    /** Messages that wait, of agents; twice as many with those of the host. */
    static final int MOST_WAITING = 8;
    /** How long a message waits, or is under way, in ms: then it ends. */
    static final int MOST_MILLIS = 60_000;
    /** Agreements for one message: then it ends. */
    private static final int MOST_AGREEMENTS = 3;

    /** The states of a message, as SPEC 11.3 has them. */
    enum State {
        WAITING, UNDER_WAY, TOLD, OVER
    }

    enum Input {
        READY, END, AGAIN, LATE
    }

    enum Deed {
        NOTHING, SEND, TELL
    }

    static final Table<State, Input, Deed> TABLE = Table.of(State.class, Input.class, Deed.class, """
              WAITING        UNDER_WAY TOLD
        READY UNDER_WAY:SEND -n        -n
        END   OVER:TELL      OVER:TELL OVER
        AGAIN -n             WAITING   OVER
        LATE  OVER:TELL      TOLD:TELL -n
        """);

    private final Context context;
    private final Address to;
    /** Only the first one may be under way. */
    private final List<Item> items = new ArrayList<>();

    /** A message; an agent's has a ticket. */
    private final class Item {

        private final Optional<Object> ticket;
        private final HostMessage message;
        private final long end;
        private int agreements;
        private State state = State.WAITING;

        Item(Optional<Object> ticket, HostMessage message, long end) {
            this.ticket = ticket;
            this.message = message;
            this.end = end;
        }

        void step(Input input, Ending how) {
            Table.Cell<State, Deed> cell = TABLE.cell(state, input);
            state = cell.next();
            Optional<Effect> effect = switch (cell.deed()) {
                case NOTHING -> Optional.empty();
                case SEND -> Optional.of(new Effect.Unicast(to, message, ticket));
                case TELL -> ticket.map(each -> new Effect.End(each, how));
            };
            effect.ifPresent(context.effects()::add);
            if (state == State.OVER) {
                items.remove(this);
            }
        }
    }

    MessageQueue(Context context, Address to) {
        this.context = context;
        this.to = to;
    }

    /** Takes a message, unless too many wait. */
    boolean add(Optional<Object> ticket, HostMessage message, long now) {
        if (waiting().count() >= (ticket.isPresent() ? MOST_WAITING : 2 * MOST_WAITING)) {
            context.count(Event.LIMITED);
            return false;
        }
        items.add(new Item(ticket, message, now + MOST_MILLIS));
        return true;
    }

    boolean isEmpty() {
        return items.isEmpty();
    }

    /** Whether the same waits or is under way. */
    boolean holds(HostMessage message) {
        return items.stream().anyMatch(item -> item.message.equals(message));
    }

    boolean isWaiting() {
        return waiting().findAny().isPresent();
    }

    private Stream<Item> waiting() {
        return items.stream().filter(item -> item.state == State.WAITING);
    }

    boolean isUnderWay() {
        return !items.isEmpty() && items.get(0).state != State.WAITING;
    }

    /** The message under way. */
    HostMessage underWay() {
        return items.get(0).message;
    }

    /** Whether the first message needed no other agreement yet. */
    boolean isFirstTry() {
        return !items.isEmpty() && items.get(0).agreements == 0;
    }

    /** Sends the first message. */
    void send() {
        items.get(0).step(Input.READY, null);
    }

    /** The message under way has ended. */
    void end(Ending how) {
        items.get(0).step(Input.END, how);
    }

    /** The message under way has to be sent again, under another key. */
    void again(Ending why) {
        context.count(Event.RESENT);
        Item item = items.get(0);
        item.step(Input.AGAIN, why);
        if (item.state == State.WAITING) {
            agreementFailed(why);
        }
    }

    /** The first message that waits needs one more agreement. */
    void agreementFailed(Ending why) {
        waiting().findFirst().filter(item -> item.agreements++ == MOST_AGREEMENTS)
                .ifPresent(item -> item.step(Input.END, why));
    }

    /** All that waits ends. */
    void endWaiting(Ending why) {
        waiting().toList().forEach(item -> item.step(Input.END, why));
    }

    /** All ends: what is under way is undelivered. */
    void endAll(Ending why) {
        endWaiting(why);
        if (isUnderWay()) {
            items.get(0).step(Input.LATE, Ending.UNDELIVERED);
        }
    }

    /** @param why the ending of messages that wait; one under way is undelivered. */
    void tick(Ending why, long now) {
        List.copyOf(items).stream().filter(item -> now >= item.end && item.state != State.TOLD).forEach(
                item -> item.step(Input.LATE, item.state == State.WAITING ? why : Ending.UNDELIVERED));
    }

    long next() {
        return items.stream().filter(item -> item.state != State.TOLD).mapToLong(item -> item.end).min()
                .orElse(Context.NEVER);
    }
}
