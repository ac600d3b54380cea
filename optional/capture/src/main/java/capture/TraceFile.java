package capture;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javino.JavinoException;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import trace.MalformedEventException;
import trace.TraceEvent;
import trace.TraceReader;

/**
 * The packets of an emulator's trace (emulator/README.md), in the order in which their CRCs were there.
 *
 * @param ids     the last RF id of each board that has one, by the board's name.
 * @param packets those that boards sent and those that came to them, also damaged.
 */
record TraceFile(Map<String, String> ids, List<AirPacket> packets) {

    private static final double MICROS_A_SECOND = 1e6;
    /** The starts of one packet, as its sender and those that hear it tell them, differ by less. */
    private static final double SAME_START_SECONDS = 0.001;

    /** A packet that was sent, and when it began. */
    private record Sending(double start, AirPacket packet) {
    }

    /** A packet that did not come undamaged, and who sent it when. */
    private record Loss(String board, String from, double start, double end, String why) {
    }

    /** The part of a trace that was read so far. */
    private static final class Reading {
        private final Map<String, String> ids = new LinkedHashMap<>();
        private final List<AirPacket> packets = new ArrayList<>();
        private final Map<String, List<Sending>> sendings = new LinkedHashMap<>();
        private final List<Loss> losses = new ArrayList<>();

        void event(TraceEvent event) {
            switch (event.name()) {
                case "host-id" -> ids.put(event.board(), event.text("id"));
                case "rf-tx" -> sent(event);
                case "rf-rx" -> packets.add(packet(event, false, event.real("end")));
                case "rf-damaged" -> losses.add(new Loss(event.board(), event.text("from"), event.real("start"),
                        event.real("end"), event.text("why")));
                default -> {
                }
            }
        }

        private void sent(TraceEvent event) {
            double start = event.real("start");
            double end = event.real("end");
            int bits = event.number("bits");
            int trailer = bits - Airtime.bits(event.text("payload").length() / 2);
            // The first bit is silence, and not in the time.
            AirPacket packet = packet(event, true, end - Math.max(0, trailer) * (end - start) / (bits - 1));
            packets.add(packet);
            sendings.computeIfAbsent(packet.board(), board -> new ArrayList<>()).add(new Sending(start, packet));
        }

        private static AirPacket packet(TraceEvent event, boolean sent, double seconds) {
            AirPacket.Trailer trailer = event.has("trailer")
                    ? AirPacket.Trailer.valueOf(event.text("trailer").toUpperCase(Locale.ROOT))
                    : sent ? AirPacket.Trailer.NONE : AirPacket.Trailer.UNKNOWN;
            return new AirPacket(micros(seconds), event.board(), sent, AirPacket.How.INTACT, trailer,
                    event.path(), "", Bytes.copyOf(event.bytes("payload")));
        }

        TraceFile end() {
            losses.forEach(loss -> packets.add(damaged(loss)));
            packets.sort(Comparator.comparingLong(AirPacket::micros).thenComparing(packet -> !packet.sent()));
            return new TraceFile(ids, packets);
        }

        /** With the payload that was sent; or without any, where its sender was cut off, too. */
        private AirPacket damaged(Loss loss) {
            Optional<AirPacket> sent = sendings.getOrDefault(loss.from(), List.of()).stream()
                    .filter(sending -> Math.abs(sending.start() - loss.start()) < SAME_START_SECONDS)
                    .map(Sending::packet).findFirst();
            return new AirPacket(sent.map(AirPacket::micros).orElse(micros(loss.end())), loss.board(), false,
                    sent.isPresent() ? AirPacket.How.AS_SENT : AirPacket.How.DAMAGED, AirPacket.Trailer.UNKNOWN,
                    sent.map(AirPacket::path).orElse(AirPacket.UNKNOWN_PATH), loss.why(),
                    sent.map(AirPacket::payload).orElse(Bytes.EMPTY));
        }
    }

    private static long micros(double seconds) {
        return Math.round(seconds * MICROS_A_SECOND);
    }

    /**
     * Reads a file to its end.
     *
     * @throws JavinoException if it has a line that is no event.
     */
    static TraceFile read(Path file) throws IOException, JavinoException {
        Reading reading = new Reading();
        try {
            TraceReader.read(file, reading::event);
        } catch (MalformedEventException e) {
            throw new JavinoException(file + ":" + e.number()
                    + ": this is no event; name the trace of a run, such as build/trace.jsonl", e);
        }
        return reading.end();
    }
}
