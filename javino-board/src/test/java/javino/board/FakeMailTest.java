package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Test;

class FakeMailTest {

    /** A host says what it has taken with each poll, whether it has said so before or not. */
    @Test
    void taken_sameNumberAgainWithMoreWaitingThanNumbers_forgetsNoMore() {
        FakeMail mail = new FakeMail();
        for (int i = 0; i < 300; i++) {
            mail.receive("SUPO", "ROMA", i, Bytes.ofText("tell;x"));
        }
        FakeMail.Poll poll = new FakeMail.Poll(false, false, 0, 0);
        mail.answer(poll, List.of(), true);
        mail.taken(3);
        Bytes left = mail.answer(poll, List.of(), true);
        mail.taken(3);
        assertEquals(left, mail.answer(poll, List.of(), true));
    }
}
