package mutation;

import harness.Emulator;
import harness.Host;
import harness.TestKeys;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import javino.board.ReceivedMessage;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Outcome;
import lockstep.Simulation;
import trace.TraceEvent;

/**
 * Three boards that go all ways of the delivery: unicasts, multicasts and broadcasts, contents in fragments, partners
 * that are there and one that is not, bits that are wrong on the air, a reset, a loss of power, and an attacker who
 * repeats what was on the air, as it was or with a wrong bit, and later what was there before the power was lost. Their
 * hosts never wait. If the seed is odd, no bits are wrong, and one board is away for long; some of these runs are
 * jammed. In half of the runs they stand in a line, and the one in the middle is a relay for the others.
 */
final class DeliveryRun {

    /** Emulated seconds in which messages are offered, and until which all must have ended; from when all are ready. */
    private static final double SECONDS = 35;
    private static final double END = 95;
    private static final double RESET_AT = 9;
    private static final double CUT_AT = 19;
    /** The cut in every other run: in the others all that arrives is undamaged, and a partner is away for long. */
    private static final double CUT_SECONDS = 0.2;
    private static final double AWAY_SECONDS = 30;
    private static final double BIT_ERRORS = 0.001;
    /** The number of runs of which one is jammed: packets are lost now and then that are not damaged else. */
    private static final long JAMMED = 3;
    private static final double JAMS_FROM = 2.2;
    private static final double JAMS_APART = 1.5;
    private static final double JAM_SECONDS = 0.06;
    private static final int WINDOW = 3;
    private static final long LOOK_NANOS = 20_000_000;
    /** The attacker takes up each packet that is so many behind the one before. */
    private static final int OVERHEARD = 12;
    /** The packets to the board that loses its power that the attacker repeats some seconds after that. */
    private static final int EARLY = 8;
    private static final double AFTER_CUT = 3;
    /** The distance between neighbours of a line, of which each hears the next one only. */
    private static final int APART = 90;
    /** The first bit behind a header. */
    private static final int CONTENT_BIT = 80;
    private static final String GROUP = "//SU";
    private static final String ALL = "////";
    private static final String ABSENT = "SUDD";
    private static final List<String> IDS = List.of("SUAA", "SUBB", "SUCC");
    private static final int SHORT = 16;
    /** Bytes of contents in three fragments, the last of one byte, and in four full ones; the most of SPEC. */
    private static final int FRAGMENTS = 111;
    private static final int MORE_FRAGMENTS = 244;
    private static final int MOST = 494;
    /** The number of a broadcast in fragments. */
    private static final int LONG_BROADCAST = 11;

    private final List<Talker> talkers = new ArrayList<>();
    private final Deque<String> overheard = new ArrayDeque<>();
    private final Deque<String> early = new ArrayDeque<>();
    private final NavigableMap<Double, Map<String, Object>> faults = new TreeMap<>();
    private final Random random;
    private final int apart;
    private int packets;
    private Simulation time;
    private double begun = Double.POSITIVE_INFINITY;

    private DeliveryRun(long seed) {
        random = new Random(seed);
        apart = seed / 2 % 2 == 0 ? 0 : APART;
    }

    /**
     * Lets boards run a program.
     *
     * @param seed   that of the air
     * @param folder for all that the run writes
     * @param trace  takes each line of the trace
     * @return the lack of a host that misses a message, or that a program crashed; empty if all was fine
     */
    static String run(Path program, long seed, Path folder, Consumer<String> trace)
            throws IOException, InterruptedException {
        return new DeliveryRun(seed).runs(program, seed, folder, trace);
    }

    private String runs(Path program, long seed, Path folder, Consumer<String> trace)
            throws IOException, InterruptedException {
        boolean damaged = seed % 2 == 0;
        faults.put(RESET_AT, Map.of("do", "reset", "board", IDS.get(1)));
        faults.put(CUT_AT, Map.of("do", "power-cut", "board", IDS.get(2), "duration",
                damaged ? CUT_SECONDS : AWAY_SECONDS));
        for (double at = JAMS_FROM; seed % JAMMED == 0 && at < SECONDS; at += JAMS_APART) {
            faults.put(at, Map.of("do", "jam", "duration", JAM_SECONDS));
        }
        Emulator.Scenario scenario =
                new Emulator.Scenario().seed(seed).inEmulatedTime().radio("bitErrorRate", damaged ? BIT_ERRORS : 0)
                        .unmodelled().discardEvents().listener(event -> {
                            trace.accept(event.line());
                            hear(event);
                        });
        for (String id : IDS) {
            scenario.board(id, "Station", Map.of("firmware", program.toString(),
                    "position", List.of(apart * IDS.indexOf(id), 0)));
        }
        try {
            Emulator emulator = scenario.start(folder);
            try {
                time = (Simulation) Simulation.here();
                return talk(emulator);
            } catch (AssertionError | RuntimeException failed) {
                return "hosts: " + failed.getMessage();
            } finally {
                emulator.close();
            }
        } catch (AssertionError | RuntimeException failed) {
            return String.valueOf(failed.getMessage()).lines().findFirst().orElse("");
        }
    }

    private void hear(TraceEvent event) {
        if (!event.name().equals("rf-tx") || !IDS.contains(event.board()) || event.text("kind").equals("broadcast")) {
            return;
        }
        if (++packets % OVERHEARD == 0) {
            overheard.add(event.text("payload"));
        }
        boolean toMany = event.text("kind").equals("multicast");
        if (early.size() < EARLY && event.seconds() - begun < CUT_AT
                && (toMany || event.text("kind").equals("unicast")
                        && event.text("destination").equals(IDS.get(2)))) {
            early.add(event.text("payload"));
        }
    }

    /** Emulated seconds since all were ready. */
    private double now() {
        return time.nanos() / 1e9 - begun;
    }

    /** Has the hosts talk; what they did not get, in one line. */
    private String talk(Emulator emulator) throws InterruptedException {
        for (String id : IDS) {
            Map<String, byte[]> keys = new LinkedHashMap<>();
            IDS.stream().filter(other -> !other.equals(id)).forEach(other -> keys.put(other, TestKeys.PAIR));
            keys.put(ABSENT, TestKeys.PAIR);
            keys.put(GROUP, TestKeys.GROUP);
            talkers.add(new Talker(id, Host.of(emulator, id).as(id, keys)));
        }
        if (apart != 0) {
            Host.get(talkers.get(1).host.board.relaying(true));
        }
        begun = time.nanos() / 1e9;
        talkers.forEach(Talker::go);
        while (true) {
            if (now() > SECONDS && talkers.stream().allMatch(Talker::ended)) {
                return Optional.of(talkers.stream().map(this::wrong).filter(wrong -> !wrong.isEmpty()).toList())
                        .filter(wrong -> !wrong.isEmpty()).map(List::toString).orElse("");
            }
            if (now() > END) {
                return "messages without an end";
            }
            attack(emulator);
            while (!faults.isEmpty() && now() > faults.firstKey()) {
                emulator.command(faults.pollFirstEntry().getValue());
            }
            time.pause(LOOK_NANOS);
        }
    }

    private String heard() {
        return now() > CUT_AT + AFTER_CUT && !early.isEmpty() ? early.poll() : overheard.poll();
    }

    /** A packet that was on the air comes again, some time later; half of them with a wrong bit behind the header. */
    private void attack(Emulator emulator) {
        String payload = heard();
        if (payload != null) {
            Map<String, Object> command =
                    new HashMap<>(Map.of("do", "send", "position", List.of(apart, 0), "payload", payload));
            if (random.nextBoolean()) {
                command.put("flip", CONTENT_BIT + random.nextInt(payload.length() * 4 - CONTENT_BIT));
            }
            emulator.command(command);
        }
    }

    /** The messages of a talker that the other hosts have and must not have, or lack. */
    private String wrong(Talker from) {
        for (Talker to : talkers) {
            Set<String> seen = new HashSet<>();
            for (ReceivedMessage message : to.host.messages()) {
                String content = message.content().toString();
                if (!message.from().toString().equals(from.id) || message.to().toString().equals(ALL)) {
                    continue; // nothing proves a broadcast: a fragment of it may be the attacker's
                }
                if (!content.equals(from.sent.get(content.replaceAll("x*\"\\)", "")))) {
                    return from.id + " never sent " + content;
                }
                if (!seen.add(content)) {
                    return to.id + " has twice " + content;
                }
            }
            if (from.delivered.getOrDefault(to.id, Set.of()).stream().anyMatch(content -> !seen.contains(content))) {
                return to.id + " lacks what is reported delivered";
            }
        }
        // The board whose power is cut may be away for nearly all of the time in which the others talk.
        return from.delivered.isEmpty() && !from.id.equals(IDS.get(2)) ? from.id + " got nothing delivered" : "";
    }

    /** A host that sends as soon as an earlier message has ended. */
    private final class Talker {
        private final String id;
        private final Host host;
        /** Whole contents, by their beginnings. */
        private final Map<String, String> sent = new HashMap<>();
        private final Map<String, Set<String>> delivered = new HashMap<>();
        private int open;
        private int number;

        Talker(String id, Host host) {
            this.id = id;
            this.host = host;
        }

        void go() {
            while (open < WINDOW && now() < SECONDS) {
                open++;
                send(number++);
            }
        }

        boolean ended() {
            return open == 0;
        }

        private void send(int which) {
            String next = IDS.get((IDS.indexOf(id) + 1) % IDS.size());
            String other = IDS.get((IDS.indexOf(id) + 2) % IDS.size());
            List<String> to = List.of(next, ALL, GROUP, ALL, other, ALL, next, ALL, next,
                    id.equals(IDS.get(0)) ? ABSENT : other);
            String destination = to.get(which % to.size());
            int longer = id.equals(IDS.get(0)) ? MOST : MORE_FRAGMENTS;
            boolean inFragments = which == LONG_BROADCAST || which % to.size() == 4;
            int length = inFragments ? FRAGMENTS : which % to.size() == 8 ? longer : SHORT;
            String begin = "tell;m(\"" + id + " " + which + " ";
            String end = "\")";
            String content = begin + "x".repeat(Math.max(0, length - begin.length() - end.length())) + end;
            sent.put(begin, content);
            host.board.transmit(Address.parse(destination), Content.parse(content)).end()
                    .whenComplete((outcome, failure) -> end(destination, content, outcome));
        }

        private void end(String destination, String content, Outcome outcome) {
            if (outcome == Outcome.DELIVERED) {
                delivered.computeIfAbsent(destination, any -> new HashSet<>()).add(content);
            }
            open--;
            go();
        }
    }
}
