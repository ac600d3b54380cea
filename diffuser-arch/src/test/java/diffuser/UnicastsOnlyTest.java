package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import javino.fake.FakeBoard;
import javino.protocol.Capability;

/** An agent whose board has sealed unicasts only. */
class UnicastsOnlyTest {

    @ParameterizedTest
    @ValueSource(strings = {"\"//SU\"", "broadcast"})
    void diffuse_toMany_failsAndTheBoardIsNotAsked(String to) {
        FakeBoard board = new FakeBoard("plain").setCapabilities(Capability.RADIO, Capability.UNICASTS_ONLY,
                Capability.SAYS_TAKEN);
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- .port(plain); .setMyRFId("ROMA"); diffuser.note(ready).
                +!do <- .diffuse(%s,tell,help); diffuser.note(done).
                -!do[error(E),error_msg(M)] <- diffuser.note(E,M).
                """.formatted(to), board);
        agent.notes("ready");
        board.requests.clear();
        agent.achieve("do");
        String note = agent.nextNote();
        assertTrue(note.startsWith("unicasts_only ") && note.contains("neither groups, broadcasts"), note);
        assertEquals(List.of(), List.copyOf(board.requests));
    }
}
