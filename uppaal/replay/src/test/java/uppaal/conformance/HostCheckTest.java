package uppaal.conformance;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The rules between hosts and boards, by scripts of {@link TestTrace}. */
class HostCheckTest {
    private static final String SENT = "police asks SUPP help; police seals 0; police sends 0 s:SUPP:0:help; ";
    private static final String HANDED = SENT + "support queues 0; support hands 0 SUPP 010000 help; ";
    private static final String TAKEN = HANDED + "support does host-taking number=0; support TAKEN message=0; "
            + "support does host-taken number=0; ";
    private static final String TWO = "police asks SUPP one; police asks SUPP two; ";

    private static final String UNICASTS = "police does host-id id=SUPO epoch=000001 unicastsOnly=true; ";

    private static String verdict(String script) {
        return new TestTrace(script.replace("SENT; ", SENT).replace("HANDED; ", HANDED).replace("TAKEN; ", TAKEN)
                .replace("TWO; ", TWO).replace("UNICASTS; ", UNICASTS)).verdict(HostCheck::new);
    }

    @ParameterizedTest
    @ValueSource(strings = {
            "TAKEN; police DELIVERED number=0; police does host-outcome number=0 outcome=delivered; "
                    + "police does host-nothing; police does host-nothing",
            "TAKEN; police DELIVERED number=0; police does host-nothing; "
                    + "police does host-outcome number=0 outcome=delivered",
            "SENT; police UNDELIVERED number=0; police does host-outcome number=0 outcome=undelivered",
            "police asks //SU help; police SENT number=0",
            "police asks CAFE help; police DELIVERED number=0", // of another run
            "bus SENT number=0", // no host's
            "bus asks //SU help; bus SENT number=0; bus does host-outcome number=0 outcome=sent", // without hello
            "HANDED; support hands 0 SUPP 010000 help; support does host-nothing",
            // A reply to a poll that the host has repeated is on its way.
            "HANDED; support does host-taking number=0; support hands 0 SUPP 010000 help; support TAKEN message=0; "
                    + "support hands 0 SUPP 010000 help; support does host-taken number=0",
            "TAKEN; support does host-taking number=0; support does host-nothing; support does host-nothing",
            "TAKEN; support queues 1; support queues 2; support hands 1 SUPP 010001 a; support hands 2 SUPP 010002 b; "
                    + "support does host-taking number=2; support TAKEN message=2; support does host-taken number=2",
            // A message that was not taken comes again after a reset.
            "HANDED; support does reset why=power; support queues 0; support hands 0 SUPP 010000 help",
            "HANDED; support does host-taking number=0; support TAKEN message=0; support boots 000002; "
                    + "support queues 0; support hands 0 SUPP 010000 help",
            "TAKEN; support queues 0; support hands 1 SUPP 020000 help",
            "support queues 0 255; support hands 0 //// 000000 help; support queues 0 255; "
                    + "support hands 1 //// 000000 help",
            "TWO; police asks //SU three; police SENT number=2; police UNDELIVERED number=0; "
                    + "police UNDELIVERED number=1",
            "UNICASTS; police asks SUPP help; police does host-key step=set address=SUPP; "
                    + "police does host-key step=delete address=//SU; police does host-key step=session address=ROMA; "
                    + "support asks //SU help; support does host-key step=renew address=SUPO",
            "UNICASTS; police does host-id id=SUPO epoch=000002; police asks //SU help", // another sketch
            "TWO; police UNDELIVERED number=0; police boots 000002; police asks SUPP one; police UNDELIVERED number=0",
    })
    void genuine_isAccepted(String script) {
        TestTrace.assertAccepted(verdict(script));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "HANDED; police DELIVERED number=0 | police declares message 0 DELIVERED; "
                    + "expected that a host of SUPP has taken it",
            "police does host-transmit number=7 asked=1 destination=SUPP; "
                    + "police does host-transmit number=7 asked=2 destination=SUPP"
                    + " | police gives a message the number 7; expected 8",
            "police DELIVERED number=0 | expected a message under way",
            "SENT; police UNDELIVERED number=0; police UNDELIVERED number=0 | expected a message under way",
            "TWO; police UNDELIVERED number=1 | expected the outcome of message 0 first",
            "police asks //SU a; police asks //// b; police SENT number=1 | expected the outcome of message 0 first",
            "SENT; police does host-outcome number=0 outcome=undelivered | expected that it declares an outcome before",
            "SENT; police UNDELIVERED number=0; police does host-outcome number=0 outcome=delivered"
                    + " | message 0 undelivered first, as it has d",
            "police does host-outcome number=0 outcome=undelivered | police reports message 0 undelivered",
            "SENT; police UNDELIVERED number=0; police does host-nothing; police does host-nothing"
                    + " | expected the outcome: message 0 undelivered",
            "TWO; police UNDELIVERED number=0; police UNDELIVERED number=1; "
                    + "police does host-outcome number=1 outcome=undelivered "
                    + "| expected message 0 undelivered first",
            "HANDED; support does host-taking number=0; support TAKEN message=0; support queues 1; "
                    + "support hands 1 SUPP 010001 a; support does host-taking number=1; support TAKEN message=1 "
                    + "| that it confirms what was taken before",
            "support queues 0; support does host-nothing; support does host-nothing"
                    + " | a message that waits for its host",
            "support does host-handed number=0 destination=SUPP origin=SUPO id=010000"
                    + " | hands its host message 0 of SUPO; expected one that is in its inbox",
            "HANDED; support hands 0 SUPP 010001 help | the same as before: SUPOSUPP010000",
            "HANDED; support does host-taking number=0; support TAKEN message=0; support hands 0 SUPP 010001 help "
                    + "| one that is in its inbox",
            "TAKEN; support hands 0 SUPP 010000 help | one that is in its inbox",
            "TAKEN; support queues 0; support hands 1 SUPP 010000 help"
                    + " | a higher id than before, not 010000",
            "TAKEN; support does reset why=power; support queues 0; support hands 0 SUPP 010000 help | a higher id",
            "HANDED; support queues 0; support hands 1 SUPP 010000 help | a higher id than before, not 010000",
            "support queues 1; support queues 0; support hands 0 SUPP 010001 b; support hands 1 SUPP 010000 a"
                    + " | a higher id",
            "TAKEN; support queues 1; support does host-taking number=1 | host takes message 1; "
                    + "expected one that it was hand",
            "support does host-taking number=0 | host takes message 0",
            "HANDED; support does host-taking number=0; support TAKEN message=0; support does percepts; "
                    + "support does percepts "
                    + "| support replies with 'percepts' alone; expected that it confirms what its host has taken",
            "support queues 0; support TAKEN message=0 | message 0 taken; expected one that its host was handed",
            "HANDED; support does host-taking number=0; support does host-taken number=0"
                    + " | confirms that message 0 is taken; e",
    })
    void wrong_isRefusedByName(String script, String why) {
        TestTrace.assertRefused(verdict(script), why);
    }

    @ParameterizedTest
    @ValueSource(strings = {
            "police asks //SU help", "police asks //// help", "police does host-relay number=0 asked=3.5",
            "police does host-key step=set address=//SU", "police does host-key step=renew address=SUPP",
            "police does host-key step=use address=SUPP", "police does host-key step=finish address=SUPP",
            "police queues 0 255; police hands 0 //// 000000 help",
            "police queues 0; police hands 0 //SU 010000 help",
            "police does reset why=power; police asks //SU help"})
    void moreThanUnicasts_ofABoardThatHasNone_isRefused(String script) {
        TestTrace.assertRefused(verdict("UNICASTS; " + script), "expected UNICASTS_ONLY, as it has said");
        TestTrace.assertAccepted(verdict(script));
    }
}
