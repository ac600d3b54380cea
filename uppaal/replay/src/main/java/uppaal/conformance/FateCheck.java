package uppaal.conformance;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Counter;
import javino.protocol.Payload;
import trace.TraceEvent;

/**
 * Each undamaged packet that comes to a board has a fate, such as QUEUED or a counter:
 * <ol>
 * <li>The board tells it by the end of its first run() behind the packet, but for fragments that it ignores.
 * <li>The fate is one that this packet can have: no broadcast is counted as replayed.
 * </ol>
 */
final class FateCheck implements Check {
    /** Fates, of which each packet has one at most, and no counter but behind a fragment. */
    static final Set<String> READ =
            Set.of("QUEUED", "FRAGMENT", "DELIVERED", "FRAGMENTS_NEW", "FRAGMENTS_KNOWN", "STALE_HEARD");
    /** Counted beside another fate, or of a host. */
    private static final Set<Counter> BESIDE = Set.of(Counter.RADIO_ANSWERS_TOLERATED, Counter.MEMORY_DAMAGED);
    private static final Set<Counter> COUNTED = Set.of(Counter.RADIO_BAD_FRAMES, Counter.RADIO_RESERVED,
            Counter.RADIO_NOT_FOR_US, Counter.RADIO_OWN, Counter.RADIO_NO_KEY, Counter.RADIO_BAD_TAG,
            Counter.RADIO_REPLAYED, Counter.RADIO_REPLAY_FULL, Counter.RADIO_QUEUE_FULL, Counter.RADIO_REPEATS,
            Counter.RADIO_FRAGMENTS_DROPPED, Counter.RADIO_BAD_PROOFS, Counter.RADIO_STALE, Counter.RADIO_BLOCKED,
            Counter.RADIO_DOUBTFUL, Counter.RADIO_ANSWERS_TOLERATED, Counter.MEMORY_DAMAGED);
    /** The fates of messages to many, all of which a board with sealed unicasts only drops. */
    private static final Set<String> TO_MANY =
            Set.of("radioNotForUs", "radioBadFrames", "radioReserved", "radioBlocked");

    private static final int LOW_BYTE = 0xFF;
    private static final int NUMBERS = 256;

    /** A board with a host or a relay, since its last reset. */
    private static final class Receiver {
        private final String board;
        private String id = "";
        /** Whether it has sealed unicasts only, as it says at hello. */
        private boolean hasUnicastsOnly;
        private boolean isOpen;
        /** Packets that it has counted as blocked since then; of one the host may be told later that it is blocked. */
        private int blocked;
        /** When a fragment of each message came to it last, and one that may have been any's. */
        final Map<String, Double> begun = new HashMap<>();
        boolean isRunning;
        /** Whether it counts packets: not where a sketch is a bare relay. */
        boolean isCounting;
        /** The packet of which it has not told; null where it may have missed that. */
        Reception waits;
        /** The number of the last packet that it has told of. */
        int told;
        double fragmentAt;
        /** The messages of which it has told a fragment and dropped none since: what it ignores it does not tell. */
        final Set<String> assembled = new HashSet<>();
        /** The last bytes of the nonces in its inbox, and the number of the first. */
        final Deque<Integer> inbox = new ArrayDeque<>();
        int first;
        /** Whether it is to acknowledge again what its host has taken. */
        boolean owes;

        Receiver(String board) {
            this.board = board;
        }

        /** The board after a reset: as far as is known, with the same sketch. */
        private Receiver again() {
            Receiver again = new Receiver(board);
            again.hasUnicastsOnly = hasUnicastsOnly;
            return again;
        }

        private void greet(TraceEvent event) {
            id = event.text("id");
            hasUnicastsOnly = event.has("unicastsOnly");
        }

        /** Whether it drops a packet as it is of a message to many, as far as that shows. */
        private boolean dropsAsToMany(Payload packet) {
            Payload.Kind kind = packet.whole().kind();
            return hasUnicastsOnly && (kind == Payload.Kind.MULTICAST || kind == Payload.Kind.BROADCAST);
        }

        /** Whether a whole message goes to it, its group or all, and it takes such. */
        private boolean isAddressed(Payload packet) {
            return !dropsAsToMany(packet) && switch (packet.kind()) {
                case BROADCAST -> true;
                case MULTICAST -> id.startsWith(packet.destination().substring(2));
                default -> packet.destination().equals(id);
            };
        }

        /** Whether what it waits for must have a fate. */
        private boolean isDemanded() {
            Payload packet = waits.packet().payload();
            return isCounting && (!packet.isFragment() || assembled.contains(message(packet))
                    || packet.index() == 0 && packet.whole().kind() != Payload.Kind.BROADCAST);
        }

        /** Takes note of a fate. */
        private void told(Point fate) {
            if (fate.is("QUEUED") || fate.is("COUNT")) {
                assembled.clear();
            } else if (fate.is("FRAGMENT") && waits != null) {
                assembled.add(message(waits.packet().payload()));
            }
            waits = null;
        }

        /** Whether nothing else is in its memory: another message in fragments is forgotten a second before this. */
        private boolean hasRoom(Payload fragment, double now) {
            begun.values().removeIf(came -> came < now - CountCheck.FORGOTTEN_SECONDS - 1);
            return inbox.isEmpty() && Set.of(message(fragment)).containsAll(begun.keySet());
        }

        private static String message(Payload fragment) {
            return fragment.origin() + fragment.fragmentId();
        }

        private boolean isTakenAgain(Optional<Counter> counter) {
            return counter.equals(Optional.of(Counter.RADIO_REPEATS)) && waits != null
                    && waits.packet().payload().kind() == Payload.Kind.UNICAST
                    && !inbox.contains(waits.packet().payload().lastBits() & LOW_BYTE);
        }

        private void queue(Point point) {
            if (point.is("QUEUED")) {
                inbox.add(point.operand("nonce"));
            } else if (point.is("TAKEN")) {
                int next = (point.operand("message") + 1) % NUMBERS;
                for (; first != next; first = (first + 1) % NUMBERS) {
                    inbox.poll();
                }
            }
        }
    }

    private final Map<String, Receiver> receivers = new HashMap<>();
    /**
     * The times at which packets began that a board heard first, for boards that have lost no memory since their first
     * epoch; also the origins of damaged ones, which may have been mended.
     */
    private final Map<String, Map<String, Double>> histories = new HashMap<>();
    private final Header header;
    private final Air air;
    private final double arrival;

    FateCheck(Header header) {
        this.header = header;
        air = new Air(header);
        arrival = PhysicalLimits.ARRIVAL_BITS * header.bit();
    }

    @Override
    public void begins(Transmission packet) {
        air.begins(packet);
    }

    @Override
    public void point(Point point) throws RefusedException {
        if (point.is("EPOCH_STORED") && point.operand("low") == 1) {
            histories.put(point.board(), new BoundedMap<>());
        }
        if (point.is("RELAY_ON")) {
            receivers.computeIfAbsent(point.board(), Receiver::new);
        }
        Receiver receiver = receivers.get(point.board());
        if (receiver == null || !point.event().has("run")) {
            return;
        }
        receiver.isRunning = true;
        receiver.queue(point);
        Optional<Counter> counter = point.counter();
        point.require(!receiver.owes || point.is("COUNT") || point.is("OWE_DELIVERED"),
                "OWE_DELIVERED, as what its host has taken has come again");
        receiver.owes = receiver.isTakenAgain(counter) || receiver.owes && point.is("COUNT");
        boolean isCounted = counter.filter(COUNTED::contains).isPresent();
        // A message that a fragment completes is queued, or counted as wrong, behind that.
        boolean isOne = READ.contains(point.name()) || isCounted && !BESIDE.contains(counter.get());
        boolean isRead = isOne && receiver.fragmentAt != point.run();
        receiver.isCounting |= isCounted || !receiver.id.isEmpty();
        receiver.fragmentAt = point.is("FRAGMENT") ? point.run() : receiver.fragmentAt;
        if (isRead) {
            read(receiver, point, counter);
        }
        if (READ.contains(point.name()) || isCounted) {
            receiver.told(point);
        } else if (receiver.waits != null
                && point.runBefore() > receiver.waits.event().seconds() + arrival) {
                    RefusedException.require(!receiver.isDemanded(), point.board() + " has not told what became of "
                            + receiver.waits.packet(), "a point or COUNT for it");
                    receiver.waits = null;
                }
    }

    /** A fate is of the first packet that it can be of: the board has missed or ignored those before. */
    private void read(Receiver receiver, Point point, Optional<Counter> counter) throws RefusedException {
        String told = counter.map(Counter::toString).orElse(point.name());
        String who = point.board() + (counter.isEmpty() ? " tells " : " counts ") + told + " of ";
        RefusedException first = new RefusedException(who + "no packet that came", "each once");
        for (Reception each : point.packets().stream().filter(each -> each.packet().number() > receiver.told)
                .toList()) {
            String wrong = each.isIntact() ? wrong(receiver, point, told, each.packet()) : "";
            if (wrong.isEmpty()) {
                receiver.told = each.packet().number();
                receiver.blocked += counter.equals(Optional.of(Counter.RADIO_BLOCKED)) ? 1 : 0;
                return;
            }
            first = new RefusedException(who + each.packet(), wrong);
        }
        if (header.slot() > 0) {
            throw first;
        }
    }

    /** The kind of packet that has such a fate, if this one is of another kind; else nothing. */
    private String wrong(Receiver receiver, Point point, String told, Transmission packet) {
        Payload payload = packet.payload();
        boolean isAnswer = payload.isAcknowledgement();
        if (receiver.dropsAsToMany(payload)
                && (payload.isFragment() ? told.equals("FRAGMENT") : !TO_MANY.contains(told))) {
            return "radioNotForUs, as it has sealed unicasts only";
        }
        return switch (told) {
            case "QUEUED" -> isAnswer || payload.isFragment() ? "a whole message"
                    : payload.hasNonce() && (payload.lastBits() & LOW_BYTE) != point.operand("nonce") ? "its nonce"
                            : "";
            case "FRAGMENT" -> payload.isFragment() ? "" : "a fragment";
            case "DELIVERED", "FRAGMENTS_NEW", "FRAGMENTS_KNOWN", "STALE_HEARD", "radioBadProofs" ->
                isAnswer ? "" : "an acknowledgement";
            case "radioBlocked" ->
                isAnswer || receiver.isOpen && receiver.blocked > 0 ? "a radio that its host has not opened" : "";
            case "radioOwn" -> isAnswer || !isOwn(receiver, payload) ? "a packet of its own address" : "";
            case "radioNotForUs" -> receiver.isAddressed(payload) ? "a packet for another device" : "";
            case "radioBadFrames", "radioReserved" ->
                isGenuine(packet) ? "a packet that is none of our firmware's" : "";
            case "radioReplayed" ->
                isAnswer || isNews(receiver, packet) ? "a packet that has come to it before" : "";
            case "radioFragmentsDropped" -> !payload.isFragment() || header.isLarge(receiver.board) && isGenuine(packet)
                    && receiver.hasRoom(payload, point.seconds()) ? "that it has no room" : "";
            default -> isAnswer ? "a message" : "";
        };
    }

    /** Whether a board may take it for a packet of its own; the address of one without a host is not known. */
    private boolean isOwn(Receiver receiver, Payload payload) {
        return receiver.id.isEmpty()
                ? receivers.values().stream().noneMatch(other -> other.id.equals(payload.origin()))
                : receiver.id.equals(payload.origin())
                        && (payload.kind() != Payload.Kind.UNICAST || payload.destination().equals(receiver.id));
    }

    @Override
    public void event(TraceEvent event) {
        air.event(event);
        if (Air.isBoot(event)) {
            reset(event);
        } else if (event.is("host-id")) {
            receivers.computeIfAbsent(event.board(), Receiver::new).greet(event);
        } else if (event.is("host-radio")) {
            open(event);
        }
    }

    private void reset(TraceEvent event) {
        receivers.computeIfPresent(event.board(), (board, before) -> before.again());
        if (!event.textOrEmpty("why").equals("port opened")) {
            histories.remove(event.board());
        }
    }

    private void open(TraceEvent event) {
        Receiver receiver = receivers.computeIfAbsent(event.board(), Receiver::new);
        receiver.isOpen = event.text("radio").equals("open");
        receiver.blocked = 0;
    }

    @Override
    public void hears(Reception reception) {
        Receiver receiver = receivers.get(reception.board());
        if (receiver == null || !receiver.isRunning) {
            return;
        }
        Transmission packet = reception.packet();
        boolean isIntact = reception.isIntact();
        Map<String, Double> history = histories.get(reception.board());
        if (history != null) {
            history.putIfAbsent(isIntact ? packet.payload().bytes().hex() : packet.payload().origin(), packet.start());
        }
        if (packet.payload().isFragment()) {
            receiver.begun.put(isIntact && isGenuine(packet) ? Receiver.message(packet.payload()) : "",
                    reception.event().seconds());
        }
        // It keeps few: the first of two it may have had no place for.
        receiver.waits = receiver.waits == null && isIntact && isSure(packet, reception.board()) ? reception : null;
    }

    /** Whether a board has not had this packet before, nor any that may be it. */
    private boolean isNews(Receiver receiver, Transmission packet) {
        Map<String, Double> history = histories.getOrDefault(receiver.board, Map.of());
        return isGenuine(packet) && !packet.payload().isFragment()
                && history.getOrDefault(packet.payload().bytes().hex(), 0.0) >= packet.start()
                && !history.containsKey(packet.payload().origin());
    }

    /** Whether a board with our firmware and a host sends it as its own. */
    private boolean isGenuine(Transmission packet) {
        return receivers.containsKey(packet.board())
                && receivers.get(packet.board()).id.equals(packet.payload().origin());
    }

    /** Small boards do not take copies. */
    private boolean isSure(Transmission packet, String receiver) {
        return (packet.path() == 0 || header.isLarge(receiver)) && !packet.isOfModule()
                && air.isKnownSince(packet.start())
                && air.isAlone(packet, packet.start(), packet.end());
    }
}
