package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import harness.AgentProcess;
import harness.Emulator;
import harness.Platform;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.io.TempDir;

/** A robot with an emulated board in a house of JaCaMo: artifacts, another agent, an organisation. */
class JaCaMoTest {

    private static final int OPERATIONS = 40;

    private static final String MAS = """
            mas house {
                agent robot : robot.asl {
                    ag-arch: diffuser.Diffuser
                    focus: attic.notes
                    roles: driver in family
                }
                agent watcher : watcher.asl {
                    focus: attic.notes
                    roles: watcher in family
                }
                workspace attic {
                    artifact notes : Notes()
                }
                workspace cellar {
                    artifact notes : Notes()
                }
                organisation house : house.xml {
                    group family : household {
                        responsible-for: tonight
                    }
                    scheme tonight : night
                }
                asl-path: "."
                org-path: "."
            }
            """;

    private static final String ORGANISATION = """
            <?xml version="1.0" encoding="UTF-8"?>
            <organisational-specification id="house" os-version="1.0" xmlns="http://moise.sourceforge.net/os">
              <structural-specification>
                <role-definitions><role id="driver"/><role id="watcher"/></role-definitions>
                <group-specification id="household">
                  <roles><role id="driver" min="1" max="1"/><role id="watcher" min="1" max="1"/></roles>
                </group-specification>
              </structural-specification>
              <functional-specification>
                <scheme id="night">
                  <goal id="arrived">
                    <plan operator="sequence"><goal id="lit"/><goal id="seen"/></plan>
                  </goal>
                  <mission id="driving" min="1" max="1"><goal id="lit"/></mission>
                  <mission id="watching" min="1" max="1"><goal id="seen"/></mission>
                </scheme>
              </functional-specification>
              <normative-specification>
                <norm id="drive" type="obligation" role="driver" mission="driving"/>
                <norm id="watch" type="obligation" role="watcher" mission="watching"/>
              </normative-specification>
            </organisational-specification>
            """;

    /** Counts how often its operations n1, n2, … are called. */
    private static final String NOTES = """
            import cartago.*;
            public class Notes extends Artifact {
                private int count;
                void init() { defineObsProperty("level", 1000); }
                @OPERATION void measured(int level) { getObsProperty("level").updateValue(level); }
                @OPERATION void count(OpFeedbackParam<Integer> total) { total.set(count); }
            """ + IntStream.rangeClosed(1, OPERATIONS)
            .mapToObj(number -> "@OPERATION void n%d() { count++; }\n".formatted(number)).collect(Collectors.joining())
            + "}";

    @TempDir
    private Path folder;

    private AgentProcess start(String version, String robot, String watcher) throws Exception {
        Platform jacamo = JaCaMo.platform(version);
        Map<String, String> files =
                Map.of("house.jcm", MAS, "house.xml", ORGANISATION, "Notes.java", NOTES, "robot.asl",
                        robot + JaCaMo.TEMPLATES, "watcher.asl", watcher + JaCaMo.TEMPLATES);
        for (String file : files.keySet()) {
            Files.writeString(folder.resolve(file), files.get(file));
        }
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, "--release", "17", "-cp",
                jacamo.classPath(), folder.resolve("Notes.java").toString()));
        return AgentProcess.run(jacamo, "house", folder, line -> {});
    }

    /** A vehicle in the dark. */
    private Emulator board() throws Exception {
        return new Emulator.Scenario().board("robot", "Vehicle",
                Map.of("watch", List.of(Map.of("pin", 30, "name", "headlights")), "sensors",
                        List.of(Map.of("type", "ldr", "pin", "A0", "light", List.of(List.of(0, 100))))))
                .start(folder);
    }

    private static void awaitHeadlights(Emulator emulator) throws InterruptedException {
        emulator.await("headlights", event -> event.is("pin", "robot"));
    }

    @JaCaMo.EachVersion
    void plainActions_boardAndTwoWorkspaces_eachGoesToItsOwn(String version) throws Exception {
        String uses = IntStream.rangeClosed(1, OPERATIONS).mapToObj(number -> "n" + number + "; ")
                .collect(Collectors.joining());
        try (Emulator emulator = board(); AgentProcess house = start(version, """
                !start. !blink.
                +!start <- .port("ports/robot"); !!use("/main/attic"); !!use("/main/cellar").
                +!blink <- headlightsOn; headlightsOff; !!blink.
                +!use(Where) <- joinWorkspace(Where, _); %s count(N); .print(N, " notes in ", Where).
                -!use(Where)[error_msg(Why)] <- .print("no notes in ", Where, ": ", Why).
                +!lit.
                """.formatted(uses), "+!seen.\n")) {
            house.await("notes in /main/attic");
            house.await("notes in /main/cellar");
            assertEquals(2, house.lines().stream().filter(line -> line.contains("] 40 notes in ")).count(),
                    () -> String.join("\n", house.lines()));
            awaitHeadlights(emulator);
        }
    }

    @JaCaMo.EachVersion
    void percept_feedsAnArtifact_anotherAgentSeesIt(String version) throws Exception {
        try (Emulator emulator = board(); AgentProcess house = start(version, """
                !start.
                +!start <- .port("ports/robot"); .percepts(open).
                +light(L) <- measured(L).
                +!shine <- headlightsOn; .print("I shine").
                +!lit.
                """, """
                +level(100) <- .send(robot, achieve, shine).
                +!seen.
                """)) {
            house.await("[robot] I shine");
            awaitHeadlights(emulator);
        }
    }

    @JaCaMo.EachVersion
    void goalOfAMission_isABoardsAction_isAchievedAndTheMasEndsQuietly(String version) throws Exception {
        try (Emulator emulator = board(); AgentProcess house = start(version, """
                !start.
                +!start <- .port("ports/robot").
                +!lit <- headlightsOn.
                """, "+!seen <- .stopMAS.\n")) {
            house.awaitEnd();
            awaitHeadlights(emulator);
            assertFalse(house.lines().stream().anyMatch(line -> line.contains("Exception")),
                    () -> String.join("\n", house.lines()));
        }
    }

    @JaCaMo.EachVersion
    void goalOfAMission_boardIsMissing_failureNamesThePort(String version) throws Exception {
        try (AgentProcess house = start(version, """
                !start.
                +!start <- .port("ports/robot").
                +!lit <- headlightsOn.
                -!lit[error_msg(Why)] <- .print("not lit: ", Why).
                """, "")) {
            house.await("; no board has answered on ports/robot yet");
        }
    }

    @JaCaMo.EachVersion
    void twoAgentsOfOneMas_talkByRadioAndWithoutAndHaveOnlyTheirOwnBoards(String version, @TempDir Path folder)
            throws Exception {
        SeveralBoardsTest.run(JaCaMo.platform(version), folder);
    }
}
