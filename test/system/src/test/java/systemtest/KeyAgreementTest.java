package systemtest;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AgentProcess;
import harness.Certificates;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TimeZone;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import lockstep.Simulation;
import keyagreement.BoardKeyAgreement;

/** Agents on devices that have never met: a bus (ROMA) has a message for the police (SUPO). No board has a key. */
@InEmulatedTime
class KeyAgreementTest {

    private static final String BUS = """
            !start.
            +!start <- .port("@PORT@"); .setMyRFId("ROMA"); .getRFMessages(open); .print("ready"); @THEN@.
            -!start[error(outcome_unknown)] <- !start.
            +!reach(X) <- .deliver("SUPO", tell, hello(X)); .print("delivered ", X).
            -!reach(X) <- !reach(X).            // on a busy machine, an answer may come late by the clock on the wall
            +!call(X) <- .deliver("SUPO", tell, hello(X)); .print("delivered ", X).
            -!call(X)[error(E)] <- .print("failed ", E).
            +!ask <- .send("SUPO", askOne, speed(_), speed(S)); .print("speed is ", S).
            +!teach <- .send("SUPO", tellHow, "+!learnt.").
            +welcome(X)[cast(unicast, S), peer(certified, S)] <- .print(S, " welcomes me ", X).
            +peer(S, K)[source(percept)] <- .print("key with ", S, " ", K).
            """;

    private static final String POLICE = """
            speed(80).
            !start.
            +!start <- .port("@PORT@"); .setMyRFId("SUPO"); .getRFMessages(open); .print("ready"); @THEN@.
            -!start[error(outcome_unknown)] <- !start.
            +hello(X)[cast(unicast, S), peer(provisioned, S)] <- .print("known ", S, " says ", X).
            +hello(X)[cast(unicast, S), peer(certified, S)] <- .print("certified ", S, " says ", X);
                .diffuse(S, tell, welcome(X)).
            """;

    /** The agents' days begin 26 hours earlier than those of {@link #WEST}. */
    private static final String EAST = "Pacific/Kiritimati";
    private static final String WEST = "Etc/GMT+12";

    private static final String HELLO = HexFormat.of().formatHex("hello".getBytes(StandardCharsets.US_ASCII));

    @TempDir
    private Path folder;

    private Emulator emulator;
    private Certificates authority;
    private Path identities;
    private final TimeZone usual = TimeZone.getDefault();

    @BeforeEach
    void switchOn() throws Exception {
        TimeZone.setDefault(TimeZone.getTimeZone(WEST));
        emulator = new Emulator.Scenario().board("bus", "Station").board("police", "Station").board("twin", "Station")
                .start(folder);
        authority = new Certificates(folder, "authority");
        identities = folder.resolve("identities");
        authority.enroll("ROMA", identities);
    }

    @AfterEach
    void switchOff() {
        TimeZone.setDefault(usual);
        emulator.close();
    }

    private AgentProcess start(String board, String program, String then, Path where) throws IOException {
        Files.writeString(folder.resolve(board + ".asl"),
                program.replace("@PORT@", emulator.port(board)).replace("@THEN@", then));
        TimeZone.setDefault(TimeZone.getTimeZone(EAST));  // of agents in this process
        return AgentProcess.run(board, folder, List.of("-D" + BoardKeyAgreement.FOLDER_PROPERTY + "=" + where,
                "-Duser.timezone=" + EAST));
    }

    private AgentProcess police(String then) throws Exception {
        AgentProcess police = start("police", POLICE, then, identities);
        police.await("ready");
        return police;
    }

    private AgentProcess bus(String then) throws IOException {
        return start("bus", BUS, then, identities);
    }

    @Test
    @Tag("verify")
    void agents_thatNeverMet_talkAskAndMeetAgainAfterAReset() throws Exception {
        authority.enroll("SUPO", identities);
        try (AgentProcess police = police("true");
                AgentProcess bus = bus("!reach(1); !ask; !teach; !reach(2); .wait(4000); !reach(3)")) {
            police.await("certified ROMA says 1");
            bus.await("delivered 1");
            bus.await("SUPO welcomes me 1");
            bus.await("key with SUPO certified");
            bus.await("speed is 80");
            bus.await("delivered 2");
            emulator.command(Map.of("do", "reset", "board", "police"));
            bus.await("delivered 3");
            police.await("certified ROMA says 3");
            assertTrue(police.lines().stream().anyMatch(line -> line.contains("dropped tellHow from ROMA")
                    && line.contains("[peer(certified,S)]")), "certified devices do not teach: " + police.lines());
        }
        try (AgentProcess police = police("true"); AgentProcess bus = bus("!reach(4)")) {
            bus.await("delivered 4");
            police.await("certified ROMA says 4");
        }
        for (String board : new String[] {"bus", "police"}) {
            assertFalse(emulator.sentBy(board).stream().anyMatch(packet -> packet.text("payload").contains(HELLO)));
        }
    }

    @Test
    void agents_betweenWhomARelayIs_talk() throws Exception {
        authority.enroll("SUPO", identities);
        emulator.command(Map.of("do", "move", "board", "bus", "position", List.of(-90, 0)));
        emulator.command(Map.of("do", "move", "board", "police", "position", List.of(90, 0)));
        try (Host relay = Host.of(emulator, "twin")) {
            Host.get(relay.board.relaying(true));
            try (AgentProcess police = police("true"); AgentProcess bus = bus("!reach(1)")) {
                bus.await("delivered 1");
                police.await("certified ROMA says 1");
                bus.await("SUPO welcomes me 1");
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"revoked", "expired", "no_answer"})
    void certifiedDevice_whoseCertificateDoesNotCount_getsNothing(String error) throws Exception {
        switch (error) {
            case "revoked" -> {
                authority.enroll("SUPO", identities);
                authority.revoke("SUPO", "ROMA", identities);
            }
            // This day ends later for the authority than for the agents.
            case "expired" -> authority.enroll("SUPO", identities, "--until",
                    LocalDate.ofInstant(Simulation.here().instant(), ZoneId.systemDefault()).toString());
            default -> new Certificates(folder, "other").enroll("SUPO", identities);
        }
        try (AgentProcess police = police("true"); AgentProcess bus = bus("!call(1)")) {
            bus.await("failed " + error);
            assertTrue(police.lines().stream().noneMatch(line -> line.contains("says")));
        }
    }

    @Test
    @Tag("soak")
    void certifiedDevice_whoseHostIsAwayOrRefuses_doesNotAnswer() throws Exception {
        authority.enroll("SUPO", identities);
        try (AgentProcess bus = bus("!call(1); .keyAgreement(refuse); !call(2)")) {
            bus.await("failed no_answer");
            bus.await("failed no_key");
        }
        try (AgentProcess police = police(".keyAgreement(refuse)"); AgentProcess bus = bus("!call(1)")) {
            bus.await("failed no_answer");
            assertTrue(police.lines().stream().noneMatch(line -> line.contains("says")));
        }
    }

    @Test
    void agent_withoutACertificate_hasNoKey() throws Exception {
        Path none = folder.resolve("none");
        try (AgentProcess bus = start("bus", BUS + "-!start[error(E)] <- .print(\"start \", E).",
                "!call(1); .keyAgreement(certified)", none)) {
            bus.await("failed no_key");
            bus.await("start no_certificate");
        }
    }

    /** A bus on an Uno, for which the sketch was built with a place for one key, or as usual with none. */
    private void takeAnUno(String built) throws Exception {
        emulator.close();
        emulator = new Emulator.Scenario().board("bus", "Station",
                Map.of("model", "uno", "firmware", Emulator.firmware("Station", built).toString()))
                .board("police", "Station").start(folder.resolve(built));
        authority.enroll("SUPO", identities);
    }

    @Test
    void agentOnAnUno_withAPlaceForAKey_agreesOnAKey() throws Exception {
        takeAnUno("unowithsessionkey");
        try (AgentProcess police = police("true"); AgentProcess bus = bus("!reach(1); !ask")) {
            police.await("certified ROMA says 1");
            bus.await("SUPO welcomes me 1");
            bus.await("speed is 80");
        }
    }

    @Test
    void agentOnAnUno_withoutAPlace_isToldWhatToDo() throws Exception {
        takeAnUno("uno");
        try (AgentProcess police = police("true"); AgentProcess bus = bus("!call(1)")) {
            bus.await("build its sketch with JAVINO_SESSION_KEYS of 1 or more");
            bus.await("failed no_place");
            assertTrue(police.lines().stream().noneMatch(line -> line.contains("says")));
        }
    }

    @Test
    @Tag("soak")
    void twin_withTheSameAddress_getsNothing() throws Exception {
        authority.enroll("SUPO", identities);
        Path others = folder.resolve("others");
        new Certificates(folder, "other").enroll("SUPO", others);
        try (AgentProcess twin = start("twin", POLICE, "true", others)) {
            twin.await("ready");
            try (AgentProcess police = police("true"); AgentProcess bus = bus("!reach(1)")) {
                bus.await("delivered 1");
                police.await("certified ROMA says 1");
                assertTrue(twin.lines().stream().noneMatch(line -> line.contains("says")), twin.lines().toString());
            }
        }
    }

    @Test
    void provisionedPartner_isMarkedSo() throws Exception {
        Host.of(emulator, "bus").as("ROMA", Map.of("SUPO", TestKeys.PAIR)).close();
        Host.of(emulator, "police").as("SUPO", Map.of("ROMA", TestKeys.PAIR)).close();
        authority.enroll("SUPO", identities);
        try (AgentProcess police = police("true"); AgentProcess bus = bus("!reach(1)")) {
            police.await("known ROMA says 1");
            bus.await("key with SUPO provisioned");
        }
    }
}
