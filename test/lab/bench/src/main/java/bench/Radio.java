package bench;

import harness.Emulator;
import harness.Host;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Semaphore;
import java.util.concurrent.ThreadLocalRandom;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.Transmission;
import javino.link.SerialLink;
import javino.protocol.Address;
import javino.protocol.Content;
import trace.TraceEvent;

/**
 * From host to host over two emulated boards: how long a message takes, how long its packet is, how much gets through.
 */
final class Radio implements Subject {

    private static final double BIT_RATE = 2000;
    private static final String SIXTEEN_BYTES = "tell;x(12345678)";
    private static final String LONG = "tell;x(" + "1".repeat(192) + ")";
    /** Messages that are not counted: Java has compiled little before them. */
    private static final int WARM_UP = 15;
    private static final int MESSAGES = 25;
    private static final int LONG_MESSAGES = 10;
    private static final int WAITING_ON_BOARD = 2;
    /**
     * The time of the request on its way to the board: sequence, frame of 26 bytes, CRC, COBS, zeros before and behind;
     * 115200 baud.
     */
    private static final double REQUEST_MILLISECONDS = 1000.0 * 10 * (1 + 26 + 2 + 1 + 2) / 115_200;

    @Override
    public String name() {
        return "radio";
    }

    @Override
    public String method() {
        return """
            two emulated Megas with the sketches Vehicle and Station at real time, each with a host over its pty.
            Unicast: 25 sealed contents of 16 bytes into quiet air, after 15 that are not counted, from the request's
            last byte on the serial line (the call and 2.8 ms) to the call that hands over the message at the other
            host; this includes sealing and the whole reply of the receiver's board. The ratio is that of the median to
            the packet's time on the air.
            With a bridge, both ports hold bytes back so long. Goodput: 10 contents of 200 bytes, which travel in
            fragments, with two of them always waiting at the board; content bits from the first packet's start to the
            last one's end, waits for the air between messages and, of unicasts, acknowledgements included. The limit
            is what line code (8 of 12 bits), training, headers, nonce and tag leave: content bits of the bits of the
            fragments. Of the 40 bytes of payload for a content of 16, ten are the paper's header (to whom, from whom,
            two digits of length), six the nonce, which must not come again in a board's life, and eight the tag, which
            leaves a forger one chance in 2^64; a receiver cannot know them beforehand, since it may have been switched
            off.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        List<Row> rows = new ArrayList<>();
        for (int latency : Reaction.BRIDGES) {
            rows.addAll(measure(latency));
        }
        return rows;
    }

    private static List<Row> measure(int latency) throws Exception {
        Path folder = Files.createTempDirectory("javino-bench");
        Map<String, Object> wiring = Map.of("bridge", Map.of("latency", latency));
        try (Emulator emulator = new Emulator.Scenario().board("sender", "Vehicle", wiring)
                .board("receiver", "Station", wiring).start(folder)) {
            byte[] key = new byte[16];
            ThreadLocalRandom.current().nextBytes(key);
            Samples took = new Samples();
            TraceEvent packet;
            List<Row> goodput = new ArrayList<>();
            try (Host receiver = Host.of(emulator, "receiver").as("SUPP", Map.of("SUPO", key))) {
                try (Host sender = Host.of(emulator, "sender").as("SUPO", Map.of("SUPP", key))) {
                    for (int i = 0; i < WARM_UP; i++) {
                        sendOne(sender, receiver);
                    }
                    for (int i = 0; i < MESSAGES; i++) {
                        took.add(sendOne(sender, receiver));
                    }
                    packet = emulator.sentBy("sender").get(0);
                }
                if (latency == 0) {
                    goodput.add(goodput(emulator, "broadcast", "////"));
                    goodput.add(goodput(emulator, "unicast", "SUPP"));
                }
            }
            double airtime = 1000 * packet.number("bits") / BIT_RATE;
            double payload = packet.text("payload").length() / 2.0;
            Row unicast = Row.against("sealed unicast of 16 bytes, host to host, median"
                    + (latency == 0 ? "" : ", bridges of " + latency + " ms"), "%.0f ms", took.median(), airtime,
                    "on the air");
            if (latency != 0) {
                return List.of(unicast);
            }
            return List.of(unicast.goal("≤ 1.04").claim(),
                    Row.cited("the same beside the public stack", "%.0f ms", took.median(), 877,
                            "the paper's software").claim(),
                    Row.cited("payload on the air for 16 sealed bytes", "%.0f bytes", payload, 54,
                            "the paper's software").goal("≤ 40"),
                    goodput.get(0), goodput.get(1).claim());
        }
    }

    /** Milliseconds that a message takes, counted from its request's last byte on the serial line. */
    private static double sendOne(Host sender, Host receiver) throws Exception {
        long begun = System.nanoTime();
        var sent = sender.board.transmit(Address.parse("SUPP"), Content.parse(SIXTEEN_BYTES));
        receiver.message();
        long ended = System.nanoTime();
        sent.taken().join();
        // A pause for the acknowledgement and a long quiet, and so that the next one comes elsewhere between two polls.
        Thread.sleep(ThreadLocalRandom.current().nextInt(400, 440));
        return (ended - begun) / 1e6 - REQUEST_MILLISECONDS;
    }

    private static Row goodput(Emulator emulator, String how, String to) throws Exception {
        Semaphore room = new Semaphore(WAITING_ON_BOARD);
        int before = emulator.sentBy("sender").size();
        try (Board board =
                Board.open(SerialLink.opener(emulator.port("sender")), BoardConfig.create(), new BoardListener() {})) {
            for (int i = 0; i < LONG_MESSAGES; i++) {
                room.acquire();
                Transmission transmission = board.transmit(Address.parse(to), Content.parse(LONG));
                transmission.end().thenRun(room::release);
                transmission.taken().join();
            }
            room.acquire(WAITING_ON_BOARD);
        }
        List<TraceEvent> packets = emulator.sentBy("sender");
        List<TraceEvent> sent = packets.subList(before, packets.size());
        double seconds = sent.get(sent.size() - 1).real("end")
                - sent.get(0).real("start");
        double bits = 8.0 * LONG_MESSAGES * LONG.length();
        double share = bits / seconds / BIT_RATE;
        double limit = bits / sent.stream().mapToInt(packet -> packet.number("bits")).sum();
        return Row
                .against("goodput of one sender, %s contents of 200 bytes".formatted(how), "%.1f %% of the bit rate",
                        100 * share, 100 * limit, "limit")
                .goal("≥ 0.85");
    }
}
