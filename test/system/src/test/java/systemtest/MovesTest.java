package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AgentProcess;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.MovingAgents;
import harness.TestKeys;
import harness.WalkerLog;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import trace.TraceEvent;

/** An agent that moves by emulated radio between two MAS, of which one may be killed: it is awake in one place only. */
@InEmulatedTime
class MovesTest {

    private static final List<String> BOARDS = List.of("home", "away");
    private static final List<Address> IDS = List.of(Address.parse("SUSS"), Address.parse("SUBB"));
    private static final List<String> DRIVERS = List.of("police", "driver");
    private static final int EVERY = 10;
    private static final int ENOUGH = 15;

    @TempDir
    private Path folder;
    private Emulator emulator;
    private MovingAgents travels;

    private void begin(int legs, boolean admitted) throws Exception {
        emulator = new Emulator.Scenario().board("home", "Station").board("away", "Station").start(folder);
        travels = new MovingAgents(emulator, folder.resolve("mas"), BOARDS, IDS, List.of(true, admitted),
                MovingAgents.counter(legs, EVERY), line -> {});
        travels.start(MovingAgents.AWAY);
        travels.start(MovingAgents.HOME);
        travels.await("tick", 1, line -> line.contains("] tick 0 "));
    }

    @AfterEach
    void end() {
        try {
            if (travels != null) {
                travels.close();
            }
        } finally {
            emulator.close();
        }
    }

    private void assertSides(Integer... sides) {
        WalkerLog.Verdict verdict = travels.walk().verdict();
        assertEquals(new WalkerLog.Verdict(List.of(), List.of(), List.of(sides)), verdict, this::told);
    }

    private String told() {
        return String.join("\n", travels.lines());
    }

    @Test
    @Tag("verify")
    void moveOut_thereAndBack_isAwakeInOnePlaceAtATime() throws Exception {
        begin(2, true);
        travels.await("arrivals", 2, line -> line.contains("arrived mutualism"));
        travels.awaitTicks(ENOUGH);

        assertSides(MovingAgents.HOME, MovingAgents.AWAY, MovingAgents.HOME);
        List<String> marks = travels.lines().stream().filter(line -> line.contains("arrived"))
                .map(line -> line.substring(line.indexOf("arrived"))).toList();
        assertEquals(List.of("arrived mutualism mark(9,\"SUSS\") kept a b c",
                "arrived mutualism mark(19,\"SUBB\") kept a b c"), marks);
    }

    @Test
    void moveOut_noPlanAdmits_failsAndTheAgentGoesOnHere() throws Exception {
        begin(1, false);
        travels.await("end of the move", 1, line -> line.contains("stayed "));
        travels.awaitTicks(ENOUGH);

        assertSides(MovingAgents.HOME);
        assertTrue(travels.lines().stream().anyMatch(line -> line.endsWith("stayed refused")), this::told);
    }

    @Test
    void moveOut_senderKilledWhenGone_isAwakeThereAlone() throws Exception {
        killAt(MovingAgents.HOME, "the agent has gone", event -> said(event, "host-transmit", MovingAgents.HOME, "go"));
    }

    @Test
    @Tag("soak")
    void moveOut_senderKilledWhileOffered_isAwakeOnce() throws Exception {
        killAt(MovingAgents.HOME, "the offer", event -> said(event, "host-transmit", MovingAgents.HOME, "offer"));
    }

    @Test
    @Tag("soak")
    void moveOut_receiverKilledWhilePartsCome_isAwakeOnce() throws Exception {
        killAt(MovingAgents.AWAY, "the first part", event -> said(event, "host-handed", MovingAgents.AWAY, "data"));
    }

    @Test
    @Tag("soak")
    void moveOut_receiverKilledWhenReady_isAwakeOnce() throws Exception {
        killAt(MovingAgents.AWAY, "that all is there",
                event -> said(event, "host-transmit", MovingAgents.AWAY, "ready"));
    }

    @Test
    void moveOut_receiverKilledWhenHere_isAwakeThereAlone() throws Exception {
        killAt(MovingAgents.AWAY, "that it is awake",
                event -> said(event, "host-transmit", MovingAgents.AWAY, "awake"));
    }

    /** Two MAS of one agent each, which has the board itself, and a nurse's program. */
    private List<AgentProcess> doors(String mover, String host, String... others) throws Exception {
        emulator = new Emulator.Scenario().board("home", "Station").board("away", "Station").board("forger", "Station")
                .start(folder);
        List<AgentProcess> processes = new ArrayList<>();
        for (int side : List.of(MovingAgents.HOME, MovingAgents.AWAY)) {
            Path place = Files.createDirectories(folder.resolve(BOARDS.get(side)));
            String there = IDS.get(1 - side).toString();
            try (Host board = Host.of(emulator, BOARDS.get(side))) {
                board.as(IDS.get(side).toString(), Map.of(there, TestKeys.PAIR, "SUHO", TestKeys.PAIR));
            }
            Files.writeString(place.resolve("mas.mas2j"), "MAS mas { agents: " + DRIVERS.get(side)
                    + " [moves=\"" + place.resolve("moves") + "\"] agentArchClass diffuser.Diffuser; "
                    + (side == MovingAgents.AWAY ? String.join("", others) : "")
                    + " }");
            Files.writeString(place.resolve("nurse.asl"), "+!care.");
            Files.writeString(place.resolve(DRIVERS.get(side) + ".asl"), """
                    !start.
                    +!start <- .port("%s"); .setMyRFId("%s"); .getRFMessages(open); .print("Ready"); !go.
                    """.formatted(emulator.port(BOARDS.get(side)), IDS.get(side))
                    + (side == MovingAgents.HOME ? mover : host));
            processes.add(AgentProcess.run("mas", place, line -> {}));
        }
        return processes;
    }

    /** The police drives alone, and so has the board itself. */
    @Test
    void moveOut_agentWithTheBoard_goesAndComesBack() throws Exception {
        List<AgentProcess> both = doors("""
                +!go <- .wait(openness(closed)); .wait(3000); X = 7; .moveOut("SUBB", mutualism);
                    .my_name(Me); .print("I am here as ", Me, X); .moveOut("SUSS", mutualism);
                    ?port(_, Port); .print("back ", X, Port).
                +openness(S) <- .print("openness ", S).
                -!go[error(E)] <- .print("failed ", E).
                """, "+!go. +!moveIn(_, mutualism)[cast(unicast, From)].");
        try {
            both.get(MovingAgents.AWAY).await("I am here as police7");
            both.get(MovingAgents.HOME).await("back 7on");
            both.get(MovingAgents.HOME).await("openness closed", 2);
        } finally {
            both.forEach(AgentProcess::close);
        }
    }

    /** The messages for a nurse of the program are for no other one. */
    @Test
    void moveOut_toWhereOneOfItsNameIsAway_getsAnotherName() throws Exception {
        List<AgentProcess> both = doors("""
                +!go <- .create_agent(nurse, "nurse.asl", [agentArchClass("mobility.Mobile")]).
                +!moveIn(_, mutualism)[cast(unicast, _)].
                +movedIn(A, _) <- .print("came ", A); .moveOut("SUBB", mutualism, [nurse]).
                """, """
                +!go <- .wait(3000); .moveOut("SUSS", mutualism, [nurse]); .print("went").
                +!moveIn(_, mutualism)[cast(unicast, _)].
                +movedIn(A, _) <- .print("came ", A, "!").
                """, "nurse agentArchClass mobility.Mobile;");
        try {
            both.get(MovingAgents.HOME).await("came nurse_1");
            both.get(MovingAgents.AWAY).await("came nurse_1!");
        } finally {
            both.forEach(AgentProcess::close);
        }
    }

    /** A device that both know, with all that anybody can know of the agent but its return token. */
    @ParameterizedTest
    @ValueSource(strings = {"m", "i", "c", "p"})
    void offer_asTheAgentThatIsAway_isRefusedThoughNobodyIsThereToAsk(String protocol) throws Exception {
        List<AgentProcess> both = doors("""
                +!go <- .wait(openness(closed)); .wait(3000); .moveOut("SUBB", mutualism); .print("I am here");
                    .wait({ +come_home }); .moveOut("SUSS", mutualism); .print("back").
                -!go[error(E)] <- .print("failed ", E).
                """, """
                +!go. +!moveIn(_, mutualism)[cast(unicast, From)].
                +openness(_). +movedIn(A, _) <- +guest(A). +enough[cast(unicast, _)] : guest(A) <-
                    .send(A, tell, come_home).
                """);
        try (Host forger = Host.of(emulator, "forger")) {
            forger.as("SUHO", Map.of("SUSS", TestKeys.PAIR, "SUBB", TestKeys.PAIR));
            both.get(MovingAgents.AWAY).await("I am here");
            Bytes offer = Bytes.join(Bytes.ofNumber(7, 4), Bytes.ofText(protocol),
                    Bytes.of(1), Bytes.ofNumber(0, 8), Bytes.ofNumber(9, 3), Bytes.ofNumber(9, 3),
                    Bytes.ofNumber(0, 8), Bytes.ofText("SUSSpolice"));
            Host.get(forger.board
                    .transmit(IDS.get(MovingAgents.HOME), new HostMessage(HostMessage.Kind.MOVE_OFFER, offer))
                    .end());
            HostMessage answer = forger.hostMessage();
            assertEquals(HostMessage.Kind.MOVE_REFUSED, answer.kind());
            assertTrue(answer.body().from(4).text().startsWith("refused it is at home"), answer.body()::hex);
            forger.send("SUBB", "tell;enough");
            both.get(MovingAgents.HOME).await("back");
        } finally {
            both.forEach(AgentProcess::close);
        }
    }

    @Test
    void moveOut_predation_isLetInByAPlanThatNamesItAlone() throws Exception {
        List<AgentProcess> both = doors("""
                +!go <- .wait(openness(_)); .wait(3000); .moveOut("SUBB", predation); .my_name(Me);
                    .print("I rule ", Me).
                -!go[error(E)] <- .print("failed ", E).
                """, "+!go. +!moveIn(_, _)[cast(unicast, From)].");
        try {
            both.get(MovingAgents.HOME).await("failed refused");
        } finally {
            both.forEach(AgentProcess::close);
            emulator.close();
        }
        both = doors("""
                +!go <- .wait(openness(_)); .wait(3000); .moveOut("SUBB", predation); .my_name(Me);
                    .print("I rule ", Me).
                -!go[error(E)] <- .print("failed ", E).
                """, "+!go. +!moveIn(_, predation)[cast(unicast, From)].");
        try {
            both.get(MovingAgents.AWAY).await("I rule driver");
        } finally {
            both.forEach(AgentProcess::close);
        }
    }

    /** Jason would have called it walker_1, as a shell of that name is there; and then started another walker. */
    @Test
    @Tag("soak")
    void moveOut_homeStartedAgainWhileItIsAwayAndWhenItIsBack_isAwakeOnceUnderItsName() throws Exception {
        begin(2, true);
        travels.await("arrival", 1, line -> line.contains("arrived"));
        restart(MovingAgents.HOME);
        travels.await("return", 2, line -> line.contains("arrived"));
        restart(MovingAgents.HOME);
        travels.awaitTicks(ENOUGH);

        assertSides(MovingAgents.HOME, MovingAgents.AWAY, MovingAgents.HOME);
        assertTrue(travels.lines().stream().noneMatch(line -> line.contains("[walker_1]")), this::told);
    }

    private void restart(int side) throws Exception {
        travels.kill(side);
        travels.start(side);
    }

    private static boolean said(TraceEvent event, String name, int side, String what) {
        return event.is(name, BOARDS.get(side)) && MovingAgents.said(event).equals(what);
    }

    /** Wherever it goes on: it does so once, and with the number that follows. */
    private void killAt(int side, String what, Predicate<TraceEvent> moment) throws Exception {
        begin(1, true);
        emulator.await(what, moment);
        restart(side);
        travels.await("end of the move", 1, line -> line.contains("arrived") || line.contains("stayed"));
        travels.awaitTicks(ENOUGH);

        if (told().contains("arrived")) {
            assertSides(MovingAgents.HOME, MovingAgents.AWAY);
        } else {
            assertSides(MovingAgents.HOME);
        }
    }
}
