package bench;

import java.util.List;

/** How much emulation a core of this machine does. */
final class EmulatorSpeed implements Subject {

    private static final int BIT_RATE = 2000;
    private static final double SECONDS = 10;
    /** The most that a scenario takes. */
    private static final int MOST_BOARDS = 32;

    @Override
    public String name() {
        return "emulator";
    }

    @Override
    public String method() {
        return """
            10 emulated seconds at full speed, divided by the CPU seconds that the process took. Six boards: one sends
            packets of 77 bytes without a pause, five receive them; the sender counts too. Quiet air: 32 boards, the
            most that a scenario takes, receive nothing; their speed gives the number of boards that one core would run
            in real time. The reference has the same boards with `bench/sketches/SampledModem` in the same emulator,
            which then spends its time on the interrupt for each sample.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        double ours = Probe.run("Modem", BIT_RATE, 1, 5, SECONDS).timesRealTime();
        double sampled = Probe.run("SampledModem", BIT_RATE, 1, 5, SECONDS).timesRealTime();
        double quiet = Probe.run("Modem", BIT_RATE, 0, MOST_BOARDS, SECONDS).timesRealTime();
        double sampledQuiet = Probe.run("SampledModem", BIT_RATE, 0, MOST_BOARDS, SECONDS).timesRealTime();
        return List.of(
                Row.against("five boards receiving, emulated on one core", "%.1f × real time", ours, sampled,
                        "eight samples a bit").goal("≥ 4"),
                Row.against("32 boards listening to quiet air, on one core", "%.1f × real time", quiet, sampledQuiet,
                        "eight samples a bit").goal("≥ 1"),
                Row.against("boards that follow from it, in real time on one core", "%.0f", quiet * MOST_BOARDS,
                        sampledQuiet * MOST_BOARDS,
                        "eight samples a bit").goal("≥ 30"));
    }
}
