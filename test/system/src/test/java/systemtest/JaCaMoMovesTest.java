package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Platform;
import harness.MovingAgents;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import javino.protocol.Address;
import org.junit.jupiter.api.io.TempDir;

/** An agent that moves by emulated radio between a MAS of JaCaMo and one of Jason. */
class JaCaMoMovesTest {

    private static final List<Address> IDS = List.of(Address.parse("SUSS"), Address.parse("SUBB"));

    private static final String MAS = """
            mas house {
                agent door : door.asl {
                    ag-arch: diffuser.Diffuser
                    moves: "moves"
                    newcomers: "jaca.CAgentArch"
                }
                agent walker : walker.asl {
                    ag-arch: mobility.Mobile
                    @AGENT@
                }
                workspace room {
                    artifact board : cartago.tools.TupleSpace()
                }
                organisation house : house.xml {
                    group family : household
                }
                asl-path: "."
                org-path: "."
            }
            """;

    private static final String ORGANISATION = """
            <?xml version="1.0" encoding="UTF-8"?>
            <organisational-specification id="house" os-version="1.0" xmlns="http://moise.sourceforge.net/os">
              <structural-specification>
                <role-definitions><role id="watcher"/></role-definitions>
                <group-specification id="household">
                  <roles><role id="watcher" min="0" max="1"/></roles>
                </group-specification>
              </structural-specification>
            </organisational-specification>
            """;

    @TempDir
    private Path folder;

    /** The words of the agent that begins as the walker of one of the two, until it says that it is done. */
    private List<String> said(Platform home, Platform away, String agent, String program) throws Exception {
        try (Emulator emulator =
                new Emulator.Scenario().board("home", "Station").board("away", "Station").start(folder);
                MovingAgents travels = new MovingAgents(emulator, folder.resolve("mas"), List.of("home", "away"), IDS,
                        List.of(true, true), program, line -> {})) {
            for (int side : List.of(MovingAgents.HOME, MovingAgents.AWAY)) {
                Path place = travels.place(side);
                // An agent of the other MAS must not have the name.
                String mas = side == MovingAgents.HOME ? MAS.replace("@AGENT@", agent)
                        : MAS.replace("@AGENT@", "").replace("agent walker : walker.asl", "agent other : other.asl");
                Files.writeString(place.resolve("mas.jcm"), mas);
                Files.writeString(place.resolve("house.xml"), ORGANISATION);
                Files.writeString(place.resolve("other.asl"), "none.\n");
            }
            Files.writeString(travels.place(MovingAgents.AWAY).resolve("door.asl"),
                    "+!moveIn(_, inquilinism)[cast(unicast, _)].\n", StandardOpenOption.APPEND);
            travels.start(MovingAgents.AWAY, away);
            travels.start(MovingAgents.HOME, home);
            travels.await("end", 1, line -> line.endsWith("] I am done"));
            List<String> said = travels.lines().stream().filter(line -> line.contains("[walker] I "))
                    .map(line -> line.substring(line.indexOf("I "))).toList();
            assertEquals(said.stream().anyMatch(line -> line.startsWith("I came")),
                    emulator.trace().stream().anyMatch(event -> !MovingAgents.said(event).isEmpty()),
                    "moves on the air");
            return said;
        }
    }

    @JaCaMo.EachVersion
    void moveOut_toJasonAndBack_focusesAtHomeAgainOnWhatItsProgramSays(String version) throws Exception {
        List<String> said = said(JaCaMo.platform(version), Platform.USUAL, "focus: room.board", """
                +!begin : not begun <- +begun; .wait(focused(_, board[artifact_type(_)], _)); !visit;
                    .print("I am done").
                +!begin.
                +!visit <- ?focused(_, board[artifact_type(_)], B); +have(B); !try; -have(_); !go(3).
                +!go(X) <- .moveOut("@THERE@", mutualism); .print("I came to Jason"); !write(X);
                    .moveOut("@HERE@", mutualism); .print("I came home");
                    .wait(focused(_, board[artifact_type(_)], _)); !write(X); in(hello, Y); .print("I read ", Y).
                +!try <- .moveOut("@THERE@", mutualism).
                -!try[error(E), error_msg(Why)] <- .print("I stay: ", E, " ", Why).
                +!write(X) <- out(hello, X); .print("I wrote ", X).
                -!write(X)[error(E)] <- .print("I could not write: ", E).
                """ + JaCaMo.TEMPLATES);

        assertTrue(said.get(0).matches("I stay: cannot_travel .* holds an artifact's handle, cobj_\\d+"),
                said::toString);
        assertEquals(List.of("I came to Jason", "I could not write: action_failed", "I came home", "I wrote 3",
                "I read 3", "I am done"), said.subList(1, said.size()));
    }

    @JaCaMo.EachVersion
    void moveOut_playsARole_staysBeforeAnythingIsSent(String version) throws Exception {
        assertEquals(List.of(
                "I stay: cannot_travel walker cannot travel: it plays the role watcher in the group family of an "
                        + "organisation; let it call leaveRole first",
                "I am done"), said(JaCaMo.platform(version), Platform.USUAL, "roles: watcher in family", """
                        +!begin : not begun <- +begun; .wait(play(_, watcher, family)); !try; .print("I am done").
                        +!begin.
                        +!try <- .moveOut("@THERE@", mutualism); .print("I came there").
                        -!try[error(E), error_msg(Why)] <- .print("I stay: ", E, " ", Why).
                        """ + JaCaMo.TEMPLATES));
    }

    /** Newcomers have artifacts as the receiver's list says; a guest has none, whatever the list says. */
    @JaCaMo.EachVersion
    void moveIn_newcomersAndGuests_haveArtifactsAsTheReceiverSays(String version) throws Exception {
        assertEquals(List.of("I came", "I joined", "I came home", "I came again", "I could not join: action_failed",
                "I am done"), said(Platform.USUAL, JaCaMo.platform(version), "", """
                        +!begin : not begun <- +begun; .moveOut("@THERE@", mutualism); .print("I came"); !join;
                            .moveOut("@HERE@", mutualism); .print("I came home");
                            .moveOut("@THERE@", inquilinism); .print("I came again"); !join; .print("I am done").
                        +!begin.
                        +!join <- joinWorkspace("/main/room", W); .print("I joined").
                        -!join[error(E)] <- .print("I could not join: ", E).
                        """));
    }
}
