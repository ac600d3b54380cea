package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import javino.protocol.Payload;
import trace.TraceEvent;

/**
 * The air: each packet has its declared send and the reverse, takes the time that its bits need, reaches others as it
 * was sent, and was sent when its board heard nobody; what boards declare to hear is there.
 */
final class AirCheck implements Check {
    /** Points at which a board's radio takes a packet. */
    static final Set<String> SENDS = Set.of("SEND", "SEND_PART", "ANSWER", "RELAY_COPY", "RELAY_ANSWER");
    /** SPEC 6: a carrier is heard from this bit on, and never for so long without an edge. */
    private static final int HEARD_BITS = 12;
    private static final int SILENT_BITS = 10;
    /** Hosts have given up a board by then, also one whose loop() takes long. */
    private static final double HANGS_SECONDS = 10;
    /** The part of a packet's end that a reset may take (emulator/README.md, rf-tx). */
    private static final int LOST_BITS = 12;

    /** A board's side of the air. */
    private static final class Station {
        final BoardAir air;
        /** Whether it runs our firmware: it declares points, or greets a host of ours. Others may send anything. */
        boolean isOurs;
        boolean isRelay;
        boolean hasRadio;
        /** When it has told something last, or begun anew. */
        double toldAt;
        /** The send that it has declared, and that is not yet on the air. */
        Point declared;
        /** Its last packet, if that lacks bits that only a reset may have taken. */
        Transmission lacking;
        /** When a reset or a cut of its power came last: perhaps before the end of a packet that it broke. */
        double brokenAt = Double.NEGATIVE_INFINITY;
        /** When its power comes back; negative while it has power. */
        double offUntil = -1;

        Station(BoardAir air) {
            this.air = air;
        }
    }

    private final Map<String, Station> stations = new HashMap<>();
    private final Header header;
    private final Air air;
    private final double bit;

    AirCheck(Header header) {
        this.header = header;
        bit = header.bit();
        air = new Air(header);
    }

    private Station station(String board) {
        return stations.computeIfAbsent(board, added -> new Station(new BoardAir(header, board)));
    }

    @Override
    public void point(Point point) throws RefusedException {
        checkRun(point.seconds());
        Station station = station(point.board());
        station.hasRadio |= point.is("MEMORY");
        station.toldAt = point.seconds();
        point.require(station.offUntil < 0, "nothing before a reset, as its power was cut");
        station.isOurs = true;
        station.isRelay = point.is("RELAY_ON") ? point.operand("on") == 1 : station.isRelay;
        if (station.lacking != null) {
            throw lacks(station.lacking);
        }
        if (SENDS.contains(point.name())) {
            if (station.declared != null) {
                throw unsent(station.declared);
            }
            station.declared = point;
        } else if (point.is("BUSY") && !station.air.isBusy() && isQuietFor(point)) {
            throw new RefusedException(point.board() + " declares that it hears a carrier", "silence: nobody sends");
        }
        station.air.changes(point);
    }

    /** A board that hears nothing declares that at its next run(). */
    private void checkRun(double now) throws RefusedException {
        double since = now - HANGS_SECONDS;
        if (air.isKnownSince(since) && air.isSilent(since, now)) {
            for (Map.Entry<String, Station> each : stations.entrySet()) {
                Station station = each.getValue();
                require(!station.hasRadio || station.offUntil >= 0 || !station.air.isBusy() || station.toldAt > since,
                        String.format(Locale.ROOT, "%s has declared nothing since %.6f s", each.getKey(),
                                station.toldAt),
                        "QUIET, as nobody sends");
            }
        }
    }

    private static RefusedException unsent(Point declared) {
        return new RefusedException(String.format(Locale.ROOT, "%s has declared %s at %.6f s, and nothing was on the "
                + "air", declared.board(), declared.name(), declared.seconds()), "a packet of its own");
    }

    /**
     * Whether nobody was on the air since the run() before, nor in the time before in which a board hears on. What was
     * declared may be there, but for a reset or the trace's end.
     */
    private boolean isQuietFor(Point busy) {
        double from = busy.runBefore() - (SILENT_BITS + PhysicalLimits.ARRIVAL_BITS) * bit;
        return air.isKnownSince(from) && air.isSilent(from, busy.seconds())
                && stations.values().stream().allMatch(other -> other.declared == null);
    }

    @Override
    public void begins(Transmission packet) throws RefusedException {
        air.begins(packet);
        Station station = station(packet.board());
        if (!station.isOurs) {
            return;
        }
        require(packet.declared() != null, packet.board() + " sends " + packet + " that it has not declared",
                "one of " + String.join(", ", new TreeSet<>(SENDS)) + " before");
        checkDeclared(packet, station.isRelay);
        station.declared = null;
    }

    private void checkDeclared(Transmission packet, boolean isRelay) throws RefusedException {
        Point declared = packet.declared();
        Payload payload = packet.payload();
        boolean isRelays = declared.name().startsWith("RELAY_");
        boolean mayTell = isRelay && declared.is("SEND") && payload.kind() == Payload.Kind.UNICAST;
        int path = isRelays ? declared.operand("path") : mayTell ? packet.path() - packet.hops() : 0;
        boolean isExpected = !declared.name().endsWith("ANSWER") || payload.isAcknowledgement();
        require(isExpected && packet.path() == path, packet.board() + " sends " + packet + " of path " + packet.path(),
                declared.name() + ", as it has declared, of path " + path);
        double late = packet.start() - declared.seconds();
        if (!packet.isOfModule() && (late < 0 || late > 2 * bit)) {
            throw new RefusedException(String.format(Locale.ROOT, "%s sends %s %.6f s behind its %s", packet.board(),
                    packet, late, declared.name()), "at once");
        }
        require(packet.trailer().isEmpty() || packet.mayHaveTrailer(), packet.board() + " sends " + packet +
                " with a trailer", "none");
    }

    @Override
    public void ends(Transmission packet) throws RefusedException {
        Station station = station(packet.board());
        if (!station.isOurs) {
            return;
        }
        int bits = packet.bits();
        if (bits != packet.expectedBits() && !packet.isCut()) {
            if (bits < packet.wholeBits() - LOST_BITS || bits > packet.expectedBits()) {
                throw lacks(packet);
            }
            station.lacking = station.brokenAt > packet.start() ? null : packet;
        }
        double seconds = packet.end() - packet.start();
        double expected = (bits - 1) * bit * header.second(packet.board());
        if (!packet.isOfModule() && Math.abs(seconds - expected) > bit) {
            throw new RefusedException(
                    String.format(Locale.ROOT, "%s sends %d bits in %.6f s", packet.board(), bits, seconds),
                    String.format(Locale.ROOT, "%.6f s", expected));
        }
    }

    private static RefusedException lacks(Transmission packet) {
        return new RefusedException(packet.board() + " sends " + packet.bits() + " bits", packet.expectedBits()
                + " for these bytes" + (packet.trailer().isEmpty() ? "" : " and this trailer"));
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        air.event(event);
        checkRun(event.seconds());
        Station station = station(event.board());
        if (event.is("host-id")) {
            station.isOurs = true;
        } else if (Air.isBoot(event)) {
            double lost = (LOST_BITS + PhysicalLimits.ARRIVAL_BITS) * bit;
            if (station.lacking != null && event.seconds() > station.lacking.end() + lost) {
                throw lacks(station.lacking);
            }
            station.lacking = null;
            station.declared = null;
            station.isRelay = false;
            station.brokenAt = event.seconds();
            station.toldAt = event.seconds();
            require(!event.is("reset") || event.seconds() >= station.offUntil, event.board() + " begins anew",
                    String.format(Locale.ROOT, "that its power is back at %.6f s", station.offUntil));
            station.offUntil = event.textOrEmpty("do").equals("power-cut") ? event.real("until") : -1;
            station.air.reset();
        }
    }

    @Override
    public void hears(Reception reception) throws RefusedException {
        TraceEvent event = reception.event();
        Transmission packet = reception.packet();
        double whole = packet.start() + (packet.wholeBits() - 2) * bit * header.second(packet.board());
        double last = packet.end() + 2 * PhysicalLimits.ARRIVAL_BITS * bit;
        double end = event.real("end");
        if (!packet.isOfModule() && (end < Math.min(whole, packet.end()) || end > last || event.seconds() > last
                || event.seconds() < whole)) {
            throw new RefusedException(event.board() + " hears " + packet + " end at another time than it was sent",
                    String.format(Locale.ROOT, "%.6f to %.6f s", whole, last));
        }
        if (reception.isIntact()) {
            checkSame(event, packet);
        }
        checkHeard(event, packet);
    }

    private static void checkSame(TraceEvent event, Transmission packet) throws RefusedException {
        Payload payload = Payload.of(javino.protocol.Bytes.copyOf(event.bytes("payload")));
        require(payload.equals(packet.payload()) && event.path() == packet.path(), event.board() +
                " hears a packet of " + packet.board() + " other than it was sent",
                packet.payload().hex() + " of path " + packet.path());
    }

    /** The part of a packet that a board has heard, and when. */
    private void checkHeard(TraceEvent event, Transmission packet) throws RefusedException {
        BoardAir board = station(event.board()).air;
        double from = event.real("start") + HEARD_BITS * bit;
        double to = packet.start() + packet.wholeBits() * bit * header.second(packet.board());
        if (packet.isOfModule() || !air.isKnownSince(packet.start())
                || !air.isAlone(packet, packet.start(), packet.start())) {
            return;
        }
        Optional<Double> into = board.sends().filter(run -> run > from + 2 * bit && run < to).findFirst();
        if (into.isPresent()) {
            throw new RefusedException(String.format(Locale.ROOT, "%s has sent at %.6f s into %s, which it has heard "
                    + "since %.6f s", event.board(), into.get(), packet, from), "silence");
        }
        if (event.is("rf-rx")) {
            double since = board.busySince(to);
            if (since > from + (Air.UNTRAINED_BITS - HEARD_BITS) * bit) {
                throw new RefusedException(
                        String.format(Locale.ROOT, "%s declares no carrier at %.6f s, while it hears "
                                + "%s", event.board(), from, packet),
                        "BUSY at its first run() behind that");
            }
        }
    }

    @Override
    public void end() throws RefusedException {
        for (Station station : stations.values()) {
            if (station.declared != null && station.declared.seconds() < air.now() - header.longest()) {
                throw unsent(station.declared);
            }
        }
    }
}
