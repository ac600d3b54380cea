package diffuser;

import static org.junit.jupiter.api.Assertions.assertTrue;

import javino.fake.FakeBoard;
import javino.protocol.Status;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DiffuseTest {

    private final FakeBoard board = new FakeBoard("antenna");

    private static String program(String action) {
        return """
                !start.
                +!start <- .port(antenna); .setMyRFId("SUPO"); !do.
                +!do <- %s; diffuser.note(done).
                -!do[error(E),error_msg(M)] <- diffuser.note(E,":",M).
                """.formatted(action);
    }

    private RunningAgent run(String action) {
        RunningAgent agent = RunningAgent.run(program(action), board);
        RunningAgent.asked(board, "id SUPO");
        return agent;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0', value = {
            ".diffuse(broadcast,tell,help)              | //// tell;help",
            ".diffuse(\"////\",untell,help)             | //// untell;help",
            ".diffuse(\"//SU\",tell,help)               | //SU tell;help",
            ".diffuse(\"SU\\\\\",tell,help)             | //SU tell;help",
            ".diffuse(\"ROMA\",achieve,goTo(12,\"km\")) | ROMA achieve;goTo(12,\"km\")",
            ".diffuse(ROMA,unachieve,go)                | ROMA unachieve;go",
            ".diffuse(bus1,tell,[a,~b(\"x y\")])        | bus1 tell;[a,~b(\"x y\")]",
            "X = \"ROMA\"; .diffuse(X,tell,p(X))         | ROMA tell;p(\"ROMA\")",
            "X = \"a\\\"b\\nc\"; .diffuse(ROMA,tell,p(X)) | ROMA tell;p(\"a\\\"b\\nc\")",
            ".diffuse(ROMA,tell,p[cast(unicast,a),b])  | ROMA tell;p[b]",
            ".diffuse(ROMA,signal,help)                | ROMA signal;help",
            ".diffuse(ROMA,tellHow,{ +!go <- run })    | ROMA tellHow;{ +!go <- run }",
            ".diffuse(\"//SU\",untellHow,[go,stay])  | //SU untellHow;[go,stay]",
            ".send(\"ROMA\",tell,help)                  | ROMA tell;help",
            ".send(\"ROMA\",tell,help,mid1)             | ROMA tell;help",
            ".send(\"//SU\",achieve,go(1))              | //SU achieve;go(1)",
    })
    void diffuse_anyDestination_boardIsAsked(String action, String expected) {
        RunningAgent agent = run(action);
        RunningAgent.asked(board, expected);
        agent.notes("done");
    }

    @ParameterizedTest
    @CsvSource({"NO_KEY,no_key", "QUEUE_FULL,queue_full", "NO_RF_ID,no_rf_id", "BAD_DESTINATION,bad_destination",
            "NONCE_EXHAUSTED,nonce_exhausted"})
    void diffuse_boardRefuses_failsWithItsError(Status status, String error) {
        board.refuse("ROMA tell;help", status);
        RunningAgent agent = run(".diffuse(\"ROMA\",tell,help)");
        agent.notes(error + " : transmit to ROMA: tell;help failed: " + status + ", " + status.explanation());
    }

    @Test
    void diffuse_tooLongForTheBoard_saysBothLengths() {
        board.refuse("ROMA tell;help", Status.TOO_LONG);
        RunningAgent agent = run(".diffuse(\"ROMA\",tell,help)");
        agent.notes("too_long : transmit to ROMA: tell;help failed: TOO_LONG, " + Status.TOO_LONG.explanation()
                + "; this one has 9");
    }

    @Test
    void diffuse_noRfIdSet_fails() {
        String program = "!start. +!start <- .port(antenna); .diffuse(broadcast,tell,help)."
                + "-!start[error(E)] <- diffuser.note(E).";
        RunningAgent agent = RunningAgent.run(program, new FakeBoard("antenna"));
        agent.notes("no_rf_id");
    }

    @Test
    void diffuse_boardIsAway_failsWithPortOff() {
        board.unplug();
        RunningAgent agent = RunningAgent.run(program(".diffuse(broadcast,tell,help)"), board);
        agent.notes("port_off : transmit to ////: tell;help was not performed: antenna: there is no such port");
    }

    @Test
    void diffuse_deviceThatLooksLikeAGroup_goesToTheDeviceAndWarnsOnce() {
        RunningAgent agent = run(".diffuse(\"SU//\",tell,a); .diffuse(\"SU//\",tell,b)");
        RunningAgent.asked(board, "SU// tell;a");
        RunningAgent.asked(board, "SU// tell;b");
        agent.notes("done");
        agent.warns("SU// is the device // of group SU; for the whole group write \"//SU\"");
        assertTrue(agent.warnings.isEmpty());
    }

    @Test
    void diffuse_contentHasNoTextThatReadsBack_fails() {
        RunningAgent agent = run(".substring(\"\\\\\",X,0,1); .diffuse(broadcast,tell,p(X))");
        String note = agent.nextNote();
        assertTrue(note.startsWith("bad_content : this cannot be sent:"), note);
    }

    @Test
    void send_boardRefuses_warns() {
        board.refuse("ROMA tell;help", Status.NO_KEY);
        RunningAgent agent = run(".send(\"ROMA\",tell,help)");
        agent.notes("done");
        agent.warns("transmit to ROMA: tell;help failed: NO_KEY");
    }

    @Test
    void send_otherPerformativeToRfAddress_fails() {
        RunningAgent agent = run(".send(\"ROMA\",sorry,help)");
        agent.notes(
                "wrong_arguments : the radio takes only tell, untell, achieve, unachieve, signal, askOne, "
                        + "askAll, askHow,"
                        + " tellHow, untellHow, not sorry");
    }

    @Test
    void send_noRfAddressAndNoAgent_failsAsEver() {
        RunningAgent agent = run(".send(nobody,tell,help)");
        String note = agent.nextNote();
        assertTrue(note.contains("Receiver 'nobody' does not exist"), note);
    }

    @Test
    void send_localAgentOfThatName_getsIt() {
        RunningAgent bob = RunningAgent.named("bob1", "+help[source(S)] <- diffuser.note(help,S).");
        RunningAgent agent = run(".send(bob1,tell,help)");
        agent.notes("done");
        bob.notes("help " + agent.name());
    }
}
