package bench;

import java.util.List;

/** The share of a board's CPU that the radio's interrupts take. */
final class InterruptLoad implements Subject {

    private static final int BIT_RATE = 2000;
    private static final int PACKETS = 20;
    /** PCINT0, TIMER1_COMPA (of the reference) and TIMER1_COMPB (of ours) of the ATmega2560. */
    private static final List<Integer> RADIO_VECTORS = List.of(9, 17, 18);
    private static final String REFERENCE = "eight samples a bit";

    @Override
    public String name() {
        return "interrupts";
    }

    @Override
    public String method() {
        return """
            one emulated Mega sends packets of 77 bytes without a pause at 2000 bit/s, another receives them
            (`bench/sketches/Modem`). `bench/native/probe.c` adds up the cycles between entering and leaving the radio's
            interrupt handlers, entry and `RETI` included. The reference is `bench/sketches/SampledModem`, which does
            the same task in VirtualWire's way and was written anew from its description; VirtualWire itself took 23 %
            and 14 %.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        double seconds = PACKETS * Probe.PACKET_BITS / (double) BIT_RATE;
        Probe ours = Probe.run("Modem", BIT_RATE, 1, 1, seconds);
        Probe sampled = Probe.run("SampledModem", BIT_RATE, 1, 1, seconds);
        return List.of(
                Row.against("radio interrupts, receiving at 2000 bit/s", "%.1f %% of CPU",
                        ours.load("rx0", RADIO_VECTORS),
                        sampled.load("rx0", RADIO_VECTORS), REFERENCE).goal("≤ 8 %").claim(),
                Row.against("radio interrupts, sending at 2000 bit/s", "%.1f %% of CPU",
                        ours.load("tx0", RADIO_VECTORS),
                        sampled.load("tx0", RADIO_VECTORS), REFERENCE).goal("≤ 5 %"));
    }
}
