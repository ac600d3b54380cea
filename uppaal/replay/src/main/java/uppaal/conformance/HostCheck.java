package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import trace.TraceEvent;

/**
 * The rules between hosts and boards, beside those that {@link ModelReplay} checks of a message: delivered means taken;
 * each id comes once, in order; outcomes are told, for one device in order; hosts take only what they were handed. A
 * board that has said that it has sealed unicasts only accepts and hands over nothing else.
 */
final class HostCheck implements Check {
    private static final int NUMBERS = 256;
    private static final int COUNTERS = 0x10000;
    private static final String TO_MANY = "//";

    /** A message as a board hands it over: its origin and destination, and its id. */
    private record Identity(String board, String link, String id) {
        /** The last byte is all that is known of two epochs. */
        boolean isAfter(Identity before) {
            int further = Math.floorMod(number() - before.number(), COUNTERS);
            return !board.equals(before.board) || !link.equals(before.link)
                    || number() / COUNTERS != before.number() / COUNTERS || further > 0 && further < COUNTERS / 2;
        }

        private int number() {
            return Integer.parseInt(id, 16);
        }

        @Override
        public String toString() {
            return link + id;
        }
    }

    /** A board and its host. */
    private static final class Side {
        /** By number, the device that a message under way is for, or empty for many: they count as one more device. */
        final Map<Integer, String> devices = new LinkedHashMap<>();
        /** By number, what was on the air: origin, destination and id. */
        final Map<Integer, String> sent = new HashMap<>();
        /** Its inbox, as its host was handed it; null until that. */
        final List<Identity> inbox = new ArrayList<>();
        /** The number of the next that it accepts; negative if that is not known. */
        int next = -1;
        /** The number of the first in the inbox. */
        int first;
        /** The messages that its host has taken, and was not told yet to have. */
        final List<Identity> unconfirmed = new ArrayList<>();
        /** The outcomes that its host was not told yet. */
        final List<String> outcomes = new ArrayList<>();
        /** How many of the first of each the last reply has left out. */
        int messagesLeftOut;
        int unconfirmedLeftOut;
        int outcomesLeftOut;

        /** A message of its inbox, behind those before it. */
        List<Identity> upTo(int number, String what) throws RefusedException {
            int index = Math.floorMod(number - first, NUMBERS);
            require(index < inbox.size(), what, "one that is in its inbox");
            return inbox.subList(0, index + 1);
        }

        boolean wasTakenLast(int number) {
            return number == Math.floorMod(first - 1, NUMBERS);
        }
    }

    private final Map<String, Side> sides = new HashMap<>();
    /** By board with a host, empty until it said hello: another's sketch sends what it likes. */
    private final Map<String, String> addresses = new HashMap<>();
    private final Set<String> unicastBoards = new HashSet<>();
    /** The messages that hosts have taken, and whether they know that their boards remember it over resets, too. */
    private final Map<Identity, Boolean> taken = new BoundedMap<>();

    HostCheck(Header header) {}

    private Side side(String board) {
        return sides.computeIfAbsent(board, added -> new Side());
    }

    @Override
    public void point(Point point) throws RefusedException {
        Side side = side(point.board());
        switch (point.name()) {
            case "QUEUED" -> side.inbox.add(null);
            case "TAKEN" -> take(side, point);
            case "SENT", "DELIVERED", "UNDELIVERED" -> {
                if (addresses.containsKey(point.board())) {
                    end(side, point);
                }
            }
            default -> {}
        }
    }

    /** The host has taken a message and all before it. */
    private void take(Side side, Point point) throws RefusedException {
        int number = point.operand("message");
        String what = point.board() + " declares message " + number + " taken";
        List<Identity> messages = side.upTo(number, what);
        require(!messages.contains(null), what, "one that its host was handed");
        require(side.unconfirmed.isEmpty(), what, "that it confirms what was taken before");
        messages.forEach(message -> taken.put(message, false));
        side.unconfirmed.addAll(messages);
        side.messagesLeftOut = Math.max(0, side.messagesLeftOut - messages.size());
        messages.clear();
        side.first = (number + 1) % NUMBERS;
    }

    /** A message has its outcome: the oldest one to this device that had none. */
    private void end(Side side, Point point) throws RefusedException {
        int number = point.number();
        String what = point.board() + " declares message " + number + " " + point.name();
        String device = side.devices.get(number);
        require(device != null, what, "a message under way");
        int oldest = side.devices.keySet().stream().filter(other -> side.devices.get(other).equals(device)).findFirst()
                .get();
        require(oldest == number, what, "the outcome of message " + oldest
                + " first, which is older and for the same device");
        require(!point.is("DELIVERED") || !addresses.containsValue(device)
                || taken.keySet().stream().anyMatch(one -> one.toString().equals(side.sent.get(number))),
                what, "that a host of " + device + " has taken it");
        side.devices.remove(number);
        side.outcomes.add("message " + number + " " + point.name().toLowerCase(Locale.ROOT));
    }

    @Override
    public void begins(Transmission packet) {
        if (packet.isDeclared("SEND") && packet.payload().isData() && packet.payload().index() == 0) {
            Frame frame = new Frame(packet.payload());
            side(packet.board()).sent.put(packet.declared().number(), frame.origin + frame.destination + frame.id());
        }
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        Side side = side(event.board());
        if (event.name().startsWith("host-")) {
            addresses.putIfAbsent(event.board(), "");
        }
        require(!unicastBoards.contains(event.board()) || !needsWholeRadio(event),
                event.board() + " does what '" + event.name() + "' tells", "UNICASTS_ONLY, as it has said");
        switch (event.name()) {
            case "reset" -> sides.remove(event.board());
            case "host-id" -> greet(event);
            case "host-transmit", "host-relay" -> transmit(side, event);
            case "host-handed" -> hand(side, event);
            case "host-taking" -> taking(side, event);
            case "host-taken" -> confirm(side, event);
            case "host-outcome" -> outcome(side, event);
            case "host-nothing", "percepts" -> reply(side, event);
            default -> {}
        }
    }

    private void greet(TraceEvent event) {
        addresses.put(event.board(), event.text("id"));
        if (event.has("unicastsOnly")) {
            unicastBoards.add(event.board());
        } else {
            unicastBoards.remove(event.board());
        }
    }

    private static boolean needsWholeRadio(TraceEvent event) {
        return switch (event.name()) {
            case "host-relay" -> true;
            case "host-transmit", "host-handed" -> event.textOrEmpty("destination").startsWith(TO_MANY);
            case "host-key" -> Set.of("renew", "use", "finish").contains(event.textOrEmpty("step"))
                    || event.textOrEmpty("step").equals("set") && event.textOrEmpty("address").startsWith(TO_MANY);
            default -> false;
        };
    }

    private static void transmit(Side side, TraceEvent event) throws RefusedException {
        int number = event.number("number");
        String destination = event.textOrEmpty("destination");
        require(side.next < 0 || side.next == number, event.board() + " gives a message the number " + number,
                "" + side.next);
        side.next = (number + 1) % NUMBERS;
        side.devices.put(number, destination.startsWith(TO_MANY) ? "" : destination);
    }

    private void hand(Side side, TraceEvent event) throws RefusedException {
        String destination = event.text("destination");
        String what =
                event.board() + " hands its host message " + event.number("number") + " of " + event.text("origin");
        Identity handed = new Identity(event.board(), event.text("origin") + destination, event.text("id"));
        if (side.unconfirmed.contains(handed)) {
            return; // the reply to a poll before the one that has told that it is taken
        }
        List<Identity> messages = side.upTo(event.number("number"), what);
        Identity before = messages.get(messages.size() - 1);
        require(before == null || before.equals(handed), what, "the same as before: " + before);
        if (before == null && !destination.equals(Frame.ALL)) {
            Stream<Identity> known = Stream.concat(messages.stream(), taken.keySet().stream().filter(taken::get));
            require(known.allMatch(other -> other == null || handed.isAfter(other)), what,
                    "a higher id than before, not " + handed.id);
        }
        messages.set(messages.size() - 1, handed);
    }

    private static void taking(Side side, TraceEvent event) throws RefusedException {
        int number = event.number("number");
        if (!side.wasTakenLast(number)) {
            String what = event.board() + "'s host takes message " + number;
            require(!side.upTo(number, what).contains(null), what, "one that it was handed");
        }
    }

    private void confirm(Side side, TraceEvent event) throws RefusedException {
        require(side.wasTakenLast(event.number("number")),
                event.board() + " confirms that message " + event.number("number") + " is taken",
                "that it declares so before");
        side.unconfirmed.forEach(message -> taken.put(message, true));
        side.unconfirmed.clear();
        side.unconfirmedLeftOut = 0;
    }

    private static void outcome(Side side, TraceEvent event) throws RefusedException {
        String told = "message " + event.number("number") + " " + event.text("outcome");
        String what = event.board() + " reports " + told;
        require(!side.outcomes.isEmpty(), what, "that it declares an outcome before");
        String first = side.outcomes.remove(0);
        side.outcomesLeftOut = Math.max(0, side.outcomesLeftOut - 1);
        require(first.equals(told), what, first + " first, as it has declared");
    }

    /** A reply to a poll has told all that there was. What came while it was on its way is in the next one. */
    private static void reply(Side side, TraceEvent event) throws RefusedException {
        String what = event.board() + " replies with '" + event.name() + "' alone";
        require(side.outcomesLeftOut == 0, what, "the outcome: " + String.join(", ", side.outcomes));
        require(side.unconfirmedLeftOut == 0, what, "that it confirms what its host has taken");
        side.outcomesLeftOut = side.outcomes.size();
        side.unconfirmedLeftOut = side.unconfirmed.size();
        if (event.is("host-nothing")) {
            require(side.messagesLeftOut == 0, what, "a message that waits for its host");
            side.messagesLeftOut = side.inbox.size();
        }
    }
}
