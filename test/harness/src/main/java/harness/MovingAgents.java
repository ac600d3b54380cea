package harness;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.ProtocolException;
import trace.TraceEvent;

/**
 * Two MAS with a board each, and an agent that moves between them: the {@code walker}. Each MAS is a process of its own
 * that can be killed, and has a folder of its own.
 */
public final class MovingAgents implements AutoCloseable {

    /** The side at home, where the agent is first. */
    public static final int HOME = 0;
    public static final int AWAY = 1;

    private static final String MOVE = "MOVE_";

    private static final String DOOR = """
            !start.
            +!start <- .port("@PORT@"); .setMyRFId("@HERE@"); .getRFMessages(open).
            +openness(open)[source(percept)] <- .send(walker, achieve, begin).
            """;
    private static final String ADMIT = """
            +!moveIn(Agent, mutualism)[cast(unicast, From)] : .term2string(From, "@THERE@").
            """;
    /**
     * Counts, moves before each so-manieth number, and goes on counting. Each fifth time it asks to be cloned, which no
     * plan admits. Before a move it binds a variable, whose value it has to find again where it arrives.
     */
    private static final String COUNTER = """
            n(0). legs(@LEGS@). every(@EVERY@). place("@HERE@", "@THERE@"). note(kept)[of(a, "b c")].
            way(N, cloning) :- every(E) & N mod (5 * E) == 4 * E - 1.
            way(N, mutualism) :- not way(N, cloning).
            +!begin : not begun <- +begun; !!live.
            +!begin.
            +!live : n(N) <- -+n(N + 1); .print("tick ", N, " ", system.time); .wait(200); !!next(N).
            +!next(N) : every(E) & N mod E == E - 1 & legs(L) & L > 0 & place(Here, There) & way(N, Way) <-
                -+legs(L - 1);
                Mark = mark(N, Here);
                .print("leaves ", N);
                .moveOut(There, Way);
                -+place(There, Here);
                ?note(Kept)[of(A, B)];
                .print("arrived ", Way, " ", Mark, " ", Kept, " ", A, " ", B);
                !!live.
            -!next(N)[error(E)] <- .print("stayed ", E); !!live.
            +!next(N) <- !!live.
            """;

    private final Path folder;
    private final List<String> ports;
    private final List<AgentProcess> processes = new ArrayList<>();
    private final int[] lives = new int[2];
    private final WalkerLog walk = new WalkerLog();
    private final Lines lines = new Lines();
    private final Consumer<String> listener;

    /**
     * Writes the programs; nothing runs before {@link #start}.
     *
     * @param folder   which is made.
     * @param boards   names of the two boards.
     * @param ids      their addresses.
     * @param admits   which of the two MAS lets the agent in.
     * @param walker   the agent's plans once it is told to {@code begin}; @HERE@ is its home, @THERE@ the other.
     * @param listener is told each line that a MAS prints.
     */
    public MovingAgents(Emulator emulator, Path folder, List<String> boards, List<Address> ids, List<Boolean> admits,
            String walker, Consumer<String> listener) throws IOException {
        this.folder = folder;
        this.listener = listener;
        ports = boards.stream().map(emulator::port).toList();
        for (int side : List.of(HOME, AWAY)) {
            Files.createDirectories(place(side));
            processes.add(null);
            Map<String, String> words = Map.of("@PORT@", ports.get(side), "@HERE@", ids.get(side).toString(),
                    "@THERE@", ids.get(1 - side).toString());
            String door = "door [moves=\"" + place(side).resolve("moves") + "\"] agentArchClass diffuser.Diffuser;";
            write(side, "door.asl", admits.get(side) ? DOOR + ADMIT : DOOR, words);
            write(side, "mas.mas2j", "MAS mas { agents: " + door
                    + (side == HOME ? " walker agentArchClass mobility.Mobile;" : "") + " }", words);
            if (side == HOME) {
                write(side, "walker.asl", walker, words);
            }
            try (Host host = Host.of(emulator, boards.get(side))) {
                host.as(ids.get(side).toString(), Map.of(ids.get(1 - side).toString(), TestKeys.PAIR));
            }
        }
    }

    /**
     * An agent for {@link WalkerLog}.
     *
     * @param legs  how often it moves.
     * @param every before each move it says so often that it is awake.
     */
    public static String counter(int legs, int every) {
        return COUNTER.replace("@LEGS@", "" + legs).replace("@EVERY@", "" + every);
    }

    private void write(int side, String file, String text, Map<String, String> words) throws IOException {
        String filled = text;
        for (Map.Entry<String, String> word : words.entrySet()) {
            filled = filled.replace(word.getKey(), word.getValue());
        }
        Files.writeString(place(side).resolve(file), filled);
    }

    /** The folder of one MAS. */
    public Path place(int side) {
        return folder.resolve(side == HOME ? "home" : "away");
    }

    /** Starts one MAS, or starts it again. */
    public void start(int side) throws IOException {
        start(side, Platform.USUAL);
    }

    /** Starts one MAS on a platform; what is not Jason needs a program {@code mas} of its own in the MAS's folder. */
    public void start(int side, Platform platform) throws IOException {
        int life = ++lives[side];
        processes.set(side, AgentProcess.run(platform, "mas", place(side), line -> printed(side, life, line)));
    }

    private void printed(int side, int life, String line) {
        walk.see(side, life, line);
        listener.accept(line);
        lines.add((side == HOME ? "home" : "away") + life + " " + line);
    }

    /** Ends one MAS by SIGKILL. */
    public void kill(int side) throws InterruptedException {
        processes.get(side).kill();
    }

    /** The log of the agent's walk. */
    public WalkerLog walk() {
        return walk;
    }

    /** All that both have printed, each line behind which of the two has and in which of its lives. */
    public List<String> lines() {
        return lines.all();
    }

    /** Waits for the n-th line, since the beginning, that is as wanted. */
    public void await(String what, int nth, Predicate<String> wanted) throws InterruptedException {
        lines.await(what, nth, wanted);
    }

    /** Waits until the agent has shown so often from now on that it is awake. */
    public void awaitTicks(int more) throws InterruptedException {
        Predicate<String> ticks = line -> line.contains("] tick ");
        await("ticks", (int) lines.count(ticks) + more, ticks);
    }

    /** The word of a host about a move (SPEC 9.1), such as "offer"; "" if the event is none of these. */
    public static String said(TraceEvent event) {
        try {
            String kind = HostMessage.decode(Bytes.copyOf(event.said().orElse(new byte[0]))).kind().name();
            return kind.startsWith(MOVE) ? kind.substring(MOVE.length()).toLowerCase(Locale.ROOT) : "";
        } catch (ProtocolException e) {
            return "";
        }
    }

    @Override
    public void close() {
        processes.stream().filter(process -> process != null).forEach(AgentProcess::close);
    }
}
