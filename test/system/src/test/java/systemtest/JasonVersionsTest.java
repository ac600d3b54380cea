package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AgentProcess;
import harness.Emulator;
import harness.Platform;
import harness.MovingAgents;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javino.protocol.Address;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceReader;
import trace.why.Why;

/** An agent that moves by emulated radio from Jason 3.2 to 3.3 and back: it does there what it does at home. */
@Tag("verify")
class JasonVersionsTest {

    private static final List<Address> IDS = List.of(Address.parse("SUSS"), Address.parse("SUBB"));

    /** Says "I …" of all that it has and does, before, between and behind two moves; at home if it does not travel. */
    private static final String LEARNED = """
            place("@HERE@", "@THERE@"). travels(@TRAVELS@).
            seen(rock, 11.5)[at(road(7, _)), sure(0.9)]. seen("a \\"b\\"", -3)[sure(0.2), of([x, "Y" | Z])].
            ~seen(tree, 0).
            near(What, D) :- seen(What, D)[sure(S)] & S > 0.5 & not ~seen(What, _).

            +!begin : not begun <-
                +begun;
                .add_plan({ @taught[learnt(today)] +!sing(Who) : near(Who, D) & .count(seen(_, _), N) <-
                    if (N > 2) { .print("I sing of ", Who, " at ", D, " of ", N); } else { .fail };
                    +sung(Who)[at(D)] });
                !!errand;
                !!guard;
                .wait(500);
                !journey(legs(2, Rest), Rest).
            +!begin.

            +!journey(legs(N, Rest), Rest) <-
                Said = said(N, Open, [Rest, _]);
                !leg(1, A, Open);
                .print("I was told ", A, " with ", Said);
                for (.member(X, [p(1), p(2), p(3)])) {
                    if (X == p(2)) { !go; };
                    .print("I count ", X);
                    +counted(X);
                };
                Rest = over;
                .findall(X, counted(X), All);
                .print("I end with ", Said, " and ", All);
                .resume(errand).

            +!leg(K, told(K, V), V) <- !go; +seen(house, K + 1)[sure(1), by(leg)]; !sing(house); V = K * 2.5.

            +!errand <- !pause(N); .print("I go on with my errand at ", N); !sing(nobody).
            +!pause(M) <- .suspend; ?seen("a \\"b\\"", M)[of([x | More])]; .print("I saw ", More).
            -!errand[error(E)] <- .print("I could not: ", E); ?sung(Who)[at(D)]; .print("I sang of ", Who, " at ", D);
                .relevant_plans({ +!sing(_) }, _, Labels); .print("I know ", Labels);
                .print("I am done").

            +!guard <- .wait({ +sung(house) }); .print("I heard it").

            +!go : travels(true) & place(Here, There) <- .moveOut(There, mutualism); -+place(There, Here).
            +!go.
            """;

    @TempDir
    private Path folder;

    @Test
    void moveOut_toTheOtherJasonAndBack_doesWhatItDoesAtHome() throws Exception {
        Platform newer = NewerJava.withNewerJason();
        List<String> atHome = said("home", false, Platform.USUAL, Platform.USUAL);

        assertEquals(atHome, said("out", true, Platform.USUAL, newer));
        assertEquals(atHome, said("in", true, newer, Platform.USUAL));
    }

    /** Jason 3.3 has its libraries of plans in other classes. */
    @Test
    void recordedRun_ofTheOtherJason_saysWhy() throws Exception {
        Platform newer = NewerJava.withNewerJason();
        Files.writeString(folder.resolve("robot.mas2j"),
                "MAS robot { agents: robot agentArchClass diffuser.Diffuser; }");
        Files.writeString(folder.resolve("robot.asl"), """
                n(0). n(1). !start.
                +!start <- .port("ports/robot"); !shine(1).
                +!shine(N) : n(M) & M > N <- .print(never).
                +!shine(N) : n(N) <- .act(headlightsOn); .print(shines). { +!within : N > 1 <- .print(never). }
                """);
        Path log = folder.resolve("run.jsonl");
        try (Emulator emulator = new Emulator.Scenario().board("robot", "Vehicle").start(folder);
                AgentProcess agent = AgentProcess.run(newer, "robot", folder, List.of("-Djavino.record=" + log),
                        line -> {})) {
            emulator.await("the agent's opening of the port", event -> event.is("port", "robot"));
            agent.await("[robot] shines");
        }
        List<String> answer = new Why(TraceReader.all(log)).answer("headlightsOn", "");
        for (String part : List.of("robot asks its board for headlightsOn",
                "not (robot.asl:3): M > N is false with M = 0, N = 1; M = 1, N = 1",
                "first cause: !start is a goal of the program")) {
            assertTrue(answer.stream().anyMatch(line -> line.contains(part)), String.join("\n", answer));
        }
    }

    private List<String> said(String name, boolean travelling, Platform home, Platform away) throws Exception {
        Path place = folder.resolve(name);
        try (Emulator emulator = new Emulator.Scenario().board("home", "Station").board("away", "Station").start(place);
                MovingAgents travels = new MovingAgents(emulator, place.resolve("mas"), List.of("home", "away"), IDS,
                        List.of(true, true), LEARNED.replace("@TRAVELS@", "" + travelling), line -> {})) {
            travels.start(MovingAgents.AWAY, away);
            travels.start(MovingAgents.HOME, home);
            travels.await("end", 1, line -> line.contains("I am done"));
            // Variables without a name have other numbers in each run.
            return travels.lines().stream().filter(line -> line.contains("] I "))
                    .map(line -> line.substring(line.indexOf("I ")).replaceAll("_\\d+", "_")).toList();
        }
    }
}
