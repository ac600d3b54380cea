package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import javino.protocol.Bytes;
import trace.TraceEvent;

/**
 * What passes between hosts and boards: delivered means taken; each id comes once, in order; outcomes are told, for one
 * device in order; hosts take only what they were handed. Behind it, the machines of hosts.
 */
final class HostCheck implements Check {
    private static final int NUMBERS = 256;
    private static final int COUNTERS = 0x10000;
    private static final int ID = 3;
    private static final Set<String> OUTCOMES = Set.of("SENT", "DELIVERED", "UNDELIVERED");

    /** A message that a board has accepted from its host. */
    private static final class Outgoing {
        /** One device, or empty for many: multicasts and broadcasts count as messages to one more device. */
        final String device;
        /** Null until it was on the air. */
        Frame frame;
        String outcome = "";
        /** Whether a reply has left it out. */
        boolean wasLeftOut;

        Outgoing(String destination) {
            device = destination.startsWith("//") ? "" : destination;
        }
    }

    /** A message in a board's inbox. */
    private static final class Incoming {
        boolean isDeclared;
        /** As its host was handed it: origin, destination, id; empty until that. */
        String handed = "";
        boolean mayBeTaken;
        boolean wasLeftOut;
    }

    /** A board and its host. */
    private static final class Side {
        final Map<Integer, Outgoing> outgoing = new LinkedHashMap<>();
        /** Those with outcomes that its host was not told, in this order. */
        final List<Outgoing> untold = new ArrayList<>();
        final List<Incoming> inbox = new ArrayList<>();
        /** The number of the first in the inbox. */
        int first;
        Point declared;
        /** Whether the board declares what it does. */
        boolean declares;
        /** What its host took and was not told yet to be taken, as it was handed; and whether a reply left that out. */
        final List<String> unconfirmed = new ArrayList<>();
        boolean wasLeftOut;

        int indexOf(int number) {
            int index = Math.floorMod(number - first, NUMBERS);
            return index < inbox.size() ? index : -1;
        }
    }

    /** Boards with hosts: another's sketch sends what it likes. */
    private final Set<String> hosts = new HashSet<>();
    private final Map<String, Side> sides = new HashMap<>();
    private final Map<String, String> addresses = new HashMap<>();
    /** By receiver, origin and destination, which id was taken last; and all, and whether that is confirmed. */
    private final Map<String, Bytes> last = new BoundedMap<>();
    private final Map<String, Boolean> taken = new BoundedMap<>();
    private final HostMachines machines = new HostMachines();

    HostCheck(Header header) {}

    @Override
    public String checked() {
        return machines.checked();
    }

    @Override
    public Set<String> covered() {
        return machines.covered();
    }

    private Side side(String board) {
        return sides.computeIfAbsent(board, added -> new Side());
    }

    @Override
    public void point(Point point) throws RefusedException {
        Side side = side(point.board());
        side.declares = true;
        switch (point.name()) {
            case "QUEUED" -> side.inbox.add(new Incoming());
            case "HANDED" -> {
                int index = side.indexOf(point.operand("message"));
                require(index >= 0, point.board() + " declares HANDED of message " + point.operand("message"),
                        "one that is in its inbox");
                side.inbox.get(index).isDeclared = true;
            }
            case "TAKEN" -> take(side, point);
            case "SENT", "DELIVERED", "UNDELIVERED" -> {
                if (hosts.contains(point.board())) {
                    end(side, point);
                }
            }
            default -> side.declared = AirCheck.SENDS.contains(point.name()) ? point : side.declared;
        }
    }

    /** The host has taken a message and all before it. */
    private void take(Side side, Point point) throws RefusedException {
        int number = point.operand("message");
        int index = side.indexOf(number);
        require(index >= 0 && side.inbox.get(index).mayBeTaken, point.board() + " declares message " + number
                + " taken", "that its host takes it before");
        require(side.unconfirmed.isEmpty(), point.board() + " declares message " + number + " taken",
                "that it confirms what was taken before");
        List<Incoming> all = side.inbox.subList(0, index + 1);
        for (Incoming message : all) {
            taken.put(point.board() + message.handed, false);
            side.unconfirmed.add(message.handed);
        }
        all.clear();
        side.first = (number + 1) % NUMBERS;
    }

    /** From now on it is remembered over resets, too. */
    private void confirm(Side side, String board) {
        for (String handed : side.unconfirmed) {
            int id = Math.max(0, handed.length() - 2 * ID);
            taken.put(board + handed, true);
            last.put(board + handed.substring(0, id), Bytes.ofHex(handed.substring(id)));
        }
        side.unconfirmed.clear();
    }

    /** A message has its outcome: the oldest one to this device that had none. */
    private void end(Side side, Point point) throws RefusedException {
        int number = point.number();
        Outgoing message = side.outgoing.get(number);
        String what = point.board() + " declares message " + number + " " + point.name();
        require(message != null && message.outcome.isEmpty(), what, "a message under way");
        Optional<Integer> oldest = side.outgoing.entrySet().stream().filter(other -> other.getValue().outcome.isEmpty()
                && other.getValue().device.equals(message.device)).map(Map.Entry::getKey).findFirst();
        require(oldest.get() == number, what, "the outcome of message " + oldest.get()
                + " first, which is older and for the same device");
        require(point.is("SENT") == message.device.isEmpty() || point.is("UNDELIVERED"), what,
                message.device.isEmpty() ? "SENT, as it is for many" : "DELIVERED or UNDELIVERED");
        if (point.is("DELIVERED")) {
            List<String> receivers = addresses.keySet().stream()
                    .filter(board -> addresses.get(board).equals(message.device)).toList();
            require(receivers.isEmpty() || message.frame != null && receivers.stream()
                    .anyMatch(board -> taken.containsKey(board + link(message.frame) + message.frame.id())),
                    what, "that a host of " + message.device + " has taken it");
        }
        message.outcome = point.name().toLowerCase(Locale.ROOT);
        side.untold.add(message);
    }

    private static String link(Frame frame) {
        return " " + frame.origin + frame.destination;
    }

    @Override
    public void begins(Transmission packet) {
        Side side = side(packet.board());
        Point declared = side.declared;
        side.declared = null;
        if (declared != null && declared.name().startsWith("SEND") && packet.payload().isData()
                && packet.payload().index() == 0) {
            Outgoing message = side.outgoing.get(declared.number());
            if (message != null) {
                message.frame = new Frame(packet.payload());
            }
        }
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        Side side = side(event.board());
        if (event.name().startsWith("host-")) {
            hosts.add(event.board());
        }
        switch (event.name()) {
            case "reset" -> sides.remove(event.board());
            case "host-id" -> {
                addresses.put(event.board(), event.text("id"));
                machines.greet(event);
            }
            case "host-key" -> machines.give(event);
            case "transition" -> machines.tell(event);
            case "host-transmit", "host-relay" -> {
                side.outgoing.remove(event.number("number"));
                boolean isRelayed = event.is("host-relay");
                side.outgoing.put(event.number("number"),
                        new Outgoing(isRelayed ? Frame.ALL : event.text("destination")));
                if (!isRelayed) {
                    machines.say(event);
                }
            }
            case "host-handed" -> {
                hand(side, event);
                machines.hear(event);
            }
            case "host-taking" -> taking(side, event);
            case "host-taken" -> {
                require(!side.declares || event.number("number") == Math.floorMod(side.first - 1, NUMBERS),
                        event.board() + " confirms that message " + event.number("number") + " is taken",
                        "that it declares so before");
                confirm(side, event.board());
            }
            case "host-outcome" -> outcome(side, event);
            case "host-nothing", "percepts" -> reply(side, event);
            default -> {}
        }
    }

    private void hand(Side side, TraceEvent event) throws RefusedException {
        if (!side.declares) {
            return;
        }
        int number = event.number("number");
        String what = event.board() + " hands its host message " + number + " of " + event.text("origin");
        int index = side.indexOf(number);
        require(index >= 0 && side.inbox.get(index).isDeclared, what, "one that it declares as handed");
        Incoming message = side.inbox.get(index);
        String link = " " + event.text("origin") + event.text("destination");
        String handed = link + event.text("id");
        require(message.handed.isEmpty() || message.handed.equals(handed), what,
                "the same as before:" + message.handed);
        if (message.handed.isEmpty() && !event.text("destination").equals(Frame.ALL)) {
            require(!taken.getOrDefault(event.board() + handed, false), what, "another id than " + event.text("id")
                    + ", which a host of it has taken");
            Bytes id = Bytes.ofHex(event.text("id"));
            List<Bytes> before = new ArrayList<>(IntStream.range(0, index).mapToObj(side.inbox::get)
                    .filter(other -> other.handed.startsWith(link))
                    .map(other -> Bytes.ofHex(other.handed.substring(link.length()))).toList());
            Optional.ofNullable(last.get(event.board() + link)).ifPresent(before::add);
            require(before.stream().allMatch(other -> isAfter(id, other)), what, "a higher id than before, not "
                    + event.text("id"));
        }
        message.handed = handed;
    }

    /** Of two epochs only the last byte is known. */
    private static boolean isAfter(Bytes id, Bytes before) {
        long further = Math.floorMod(id.number(1, ID) - before.number(1, ID), COUNTERS);
        return id.at(0) != before.at(0) || further > 0 && further < COUNTERS / 2;
    }

    private static void taking(Side side, TraceEvent event) throws RefusedException {
        int number = event.number("number");
        int index = side.indexOf(number);
        require(!side.declares || number == Math.floorMod(side.first - 1, NUMBERS)
                || index >= 0 && !side.inbox.get(index).handed.isEmpty(),
                event.board() + "'s host takes message " + number, "one that it was handed");
        side.inbox.subList(0, index + 1).forEach(message -> message.mayBeTaken = true);
    }

    private static void outcome(Side side, TraceEvent event) throws RefusedException {
        if (!side.declares) {
            return;
        }
        Outgoing message = side.outgoing.get(event.number("number"));
        String what = event.board() + " reports message " + event.number("number") + " " + event.text("outcome");
        require(message != null && message.outcome.equals(event.text("outcome")), what,
                message == null || message.outcome.isEmpty() ? "that it declares an outcome before"
                        : message.outcome + ", as it has declared");
        require(side.untold.indexOf(message) <= 0, what, "outcomes in the order in which they were");
        side.untold.remove(message);
    }

    /** A reply to a poll has told all that there was. What came while it was on its way is in the next one. */
    private static void reply(Side side, TraceEvent event) throws RefusedException {
        String what = event.board() + " replies with '" + event.name() + "' alone";
        for (Outgoing message : side.untold) {
            require(!message.wasLeftOut, what, "an outcome: " + message.outcome);
            message.wasLeftOut = true;
        }
        require(side.unconfirmed.isEmpty() || !side.wasLeftOut, what, "that it confirms what its host has taken");
        side.wasLeftOut = !side.unconfirmed.isEmpty();
        for (Incoming message : event.is("host-nothing") ? side.inbox : List.<Incoming>of()) {
            require(!message.wasLeftOut, what, "a message that waits for its host");
            message.wasLeftOut = true;
        }
    }
}
