package bench;

import diffuser.Diffuser;
import harness.Emulator;
import harness.Table;
import jason.asSemantics.Message;
import jason.infra.local.LocalAgArch;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.atomic.AtomicLong;
import trace.TraceEvent;

/** How soon an agent knows what has changed at its board, and how soon what it says is on the air. */
final class Reaction implements Subject {

    /** The latencies of serial bridges, in ms. */
    static final List<Integer> BRIDGES = List.of(0, 4, 16);

    private static final int CHANGES = 40;
    /** Messages that are not counted: Java has compiled little before them. */
    private static final int WARM_UP = 30;
    private static final int MESSAGES = 30;
    /** Longer than it takes until the packet is on the air, shorter than the packet. */
    private static final int OUT_OF_THE_WAY_MILLIS = 60;
    /** More than 15 slots of 8 ms (SPEC 7.4). */
    private static final int LONG_QUIET_MILLIS = 150;
    /** Emulated seconds of the first change; by then the messages have been sent. */
    private static final double FIRST = 30;
    /** No multiple of the sampling interval, so that the changes come at all moments between two readings. */
    private static final double DISTANCE = 0.3037;
    private static final double STEP_SECONDS = 1e-6;
    private static final int BRIGHTER = 20;

    private static final String PROGRAM = """
        !start.
        +!start <- .port("%s"); .percepts(open); .setMyRFId(ROMA); bench.note(started).
        +light(L) <- bench.note(light(L)).
        +!say <- bench.note(say); .diffuse(broadcast, tell, x).
        """;

    @Override
    public String name() {
        return "reaction";
    }

    @Override
    public String method() {
        return """
            an agent with the Diffuser's default settings and an emulated board (Vehicle, which reads its sensors every
            5 ms) at real time; without a USB bridge, as on boards with USB of their own, and with bridges that hold
            bytes back for up to 4 ms (ATmega16U2) and 16 ms (FTDI by default). Percept: 40 steps of the voltage on A0,
            at all moments between two readings, each to the first action of the plan for `+light(L)`. Radio: 30 times,
            after 30 that are not counted, from the action before `.diffuse` to the TX pin's first change, into air
            that has been quiet for 15 slots (SPEC 7.4). The emulator's clock is tied to the host's by the earliest
            arrival of a line of its trace.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        List<Row> rows = new ArrayList<>();
        for (int latency : BRIDGES) {
            rows.addAll(measure(latency));
        }
        return rows;
    }

    private static List<Row> measure(int latency) throws Exception {
        Map<String, Object> wiring = Map.of(
                "bridge", Map.of("latency", latency),
                "sensors", List.of(Map.of("type", "ldr", "pin", "A0", "light", steps())),
                "watch", List.of(Map.of("pin", 12, "name", "transmitter")));
        // The host's time at emulated time 0, and the delay of the trace that was delayed least.
        AtomicLong clock = new AtomicLong(Long.MAX_VALUE);
        try (Emulator emulator = new Emulator.Scenario().board("board", "Vehicle", wiring)
                .listener(event -> clock.accumulateAndGet(System.nanoTime() - nanos(event.seconds()), Math::min))
                .start(Files.createTempDirectory("javino-bench"))) {
            LocalAgArch agent = Agents.start("reaction", PROGRAM.formatted(emulator.port("board")), Diffuser.class);
            try {
                return measure(emulator, agent, latency, clock);
            } finally {
                agent.stopAg();
            }
        }
    }

    private static List<Row> measure(Emulator emulator, LocalAgArch agent, int latency, AtomicLong clock)
            throws Exception {
        await("started");
        clock.set(Long.MAX_VALUE);
        List<Long> said = new ArrayList<>();
        List<TraceEvent> begun = new ArrayList<>();
        double silentSince = 0;
        for (int i = 0; i < WARM_UP + MESSAGES; i++) {
            agent.receiveMsg(new Message("achieve", "bench", "reaction", "say"));
            // This thread shall not take the CPU from those that are measured.
            Thread.sleep(OUT_OF_THE_WAY_MILLIS);
            said.add(await("say"));
            double before = silentSince;
            TraceEvent rise =
                    emulator.await("a carrier", event -> event.is("pin", "board") && event.number("level") == 1
                            && event.seconds() > before);
            begun.add(rise);
            silentSince = emulator.await("the packet's end", i + 1, event -> event.is("rf-tx", "board"))
                    .real("end");
            Thread.sleep(LONG_QUIET_MILLIS + ThreadLocalRandom.current().nextInt(40));
        }
        Samples spoken = new Samples();
        for (int i = WARM_UP; i < WARM_UP + MESSAGES; i++) {
            spoken.add((nanos(begun.get(i).seconds()) + clock.get() - said.get(i)) / 1e6);
        }
        Samples perceived = new Samples();
        for (int i = 0; i < CHANGES; i++) {
            perceived.add((await("light(" + light(i) + ")") - nanos(changeOf(i)) - clock.get()) / 1e6);
        }
        String bridge = latency == 0 ? "" : ", bridge of " + latency + " ms";
        Row percept = Row.of("percept: pin to belief event" + bridge + ", median (longest)", both(perceived));
        Row diffuse = Row.of(".diffuse to first bit on air" + bridge + ", median (longest)", both(spoken));
        return latency == 0 ? List.of(percept.goal("≤ 10 (25) ms").claim(), diffuse.goal("≤ 5 ms").claim())
                : List.of(percept, diffuse);
    }

    private static String both(Samples milliseconds) {
        return Table.text("%.1f ms (%.1f)", milliseconds.median(), milliseconds.greatest());
    }

    private static long nanos(double seconds) {
        return Math.round(seconds * 1e9);
    }

    /** When the agent told this; what it told before that is forgotten. */
    private static long await(String what) throws InterruptedException {
        while (true) {
            note.Note next = note.next();
            if (next.what().equals(what)) {
                return next.nanos();
            }
        }
    }

    private static double changeOf(int change) {
        return FIRST + change * DISTANCE;
    }

    private static int light(int change) {
        return BRIGHTER * (change + 1);
    }

    /** The light's course: a step at each change. */
    private static List<List<Double>> steps() {
        List<List<Double>> points = new ArrayList<>();
        for (int i = 0; i < CHANGES; i++) {
            points.add(List.of(changeOf(i), (double) light(i - 1)));
            points.add(List.of(changeOf(i) + STEP_SECONDS, (double) light(i)));
        }
        return points;
    }
}
