package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;

import harness.Report;
import javino.protocol.Content;
import javino.protocol.Performative;
import javino.protocol.Outcome;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** An account of unicasts notices lost, wrong and repeated ones. */
class LedgerTest {

    private static final int LENGTH = 30;

    private final Ledger ledger = new Ledger(LENGTH);

    @BeforeEach
    void offerThree() {
        for (int number = 0; number < 3; number++) {
            assertEquals(number, ledger.next());
        }
    }

    @Test
    void sum_allWell_countsDelivered() {
        for (int number = 0; number < 3; number++) {
            ledger.received(ledger.content(number));
            ledger.ended(number, Outcome.DELIVERED);
        }
        assertEquals(new Ledger.Sum(3, 0, 3, 0, 0, 3, 0, 0, 0), ledger.sum());
        assertEquals(0, ledger.sum().open());
        assertEquals(List.of(), violations());
    }

    @Test
    void sum_noEndYet_isOpen() {
        ledger.refused();
        ledger.unknown();
        assertEquals(1, ledger.sum().open());
    }

    @Test
    void sum_deliveredButNotReceived_isLost() {
        ledger.ended(1, Outcome.DELIVERED);
        assertEquals(1, ledger.sum().lost());
        assertEquals(List.of("test: reported delivered, but not received: 1"), violations());
    }

    @Test
    void sum_undeliveredButReceived_isNoViolation() {
        ledger.received(ledger.content(1));
        ledger.ended(1, Outcome.UNDELIVERED);
        assertEquals(List.of(), violations());
    }

    @Test
    void received_again_isTwice() {
        ledger.received(ledger.content(1));
        ledger.received(ledger.content(1));
        assertEquals(List.of("test: delivered twice: 1"), violations());
    }

    @Test
    void received_whatWasNotSent_isWrong() {
        ledger.received(ledger.content(3));
        ledger.received(Contents.of(1, LENGTH + 1));
        ledger.received(new Content(Performative.TELL, "x"));
        ledger.strayed();
        assertEquals(List.of("test: delivered with another content than was sent: 4"), violations());
    }

    @Test
    void received_eachByteChanged_isWrong() {
        String text = ledger.content(1).term();
        for (int i = 0; i < text.length(); i++) {
            char other = text.charAt(i) == '9' ? '8' : '9';
            ledger.received(new Content(Performative.TELL, text.substring(0, i) + other + text.substring(i + 1)));
        }
        assertEquals(text.length(), ledger.sum().wrong());
        assertEquals(0, ledger.sum().received());
    }

    private List<String> violations() {
        Report report = new Report("test", System.err);
        ledger.sum().report(report);
        return report.violations();
    }
}
