package bench;

import java.util.List;

/** The highest bit rate at which a board that has nothing else to do loses nothing. */
final class BitRates implements Subject {

    private static final int STEP = 500;
    /** The highest that {@code AskRadio} takes. */
    private static final int HIGHEST = 10_000;
    private static final int PACKETS = 40;

    @Override
    public String name() {
        return "bitrates";
    }

    @Override
    public String method() {
        return """
            the same two boards at rates from 10 000 bit/s downwards in steps of 500, until none of 40 packets of 77
            bytes is lost. 10 000 bit/s is the highest rate that `AskRadio` takes.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        return List.of(
                Row.against("highest bit rate without loss", "%.0f bit/s", highest("Modem"), highest("SampledModem"),
                        "eight samples a bit").goal("≥ 8000"));
    }

    private static int highest(String sketch) throws Exception {
        int rate = HIGHEST;
        while (rate > 0 && loses(sketch, rate)) {
            rate -= STEP;
        }
        return rate;
    }

    private static boolean loses(String sketch, int rate) throws Exception {
        Probe probe = Probe.run(sketch, rate, 1, 1, PACKETS * Probe.PACKET_BITS / (double) rate + 0.1);
        return probe.sent() < PACKETS / 2 || probe.received() < probe.sent();
    }
}
