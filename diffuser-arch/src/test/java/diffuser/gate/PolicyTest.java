package diffuser.gate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javino.protocol.Address;

import org.junit.jupiter.api.Test;

/** The table itself; what comes of it is tried by {@code RightsTest} of mobility. */
class PolicyTest {

    @Test
    void table_standsInSecurityMd() throws Exception {
        String page = Files.readString(Path.of(System.getProperty("javino.root"), "SECURITY.md"));
        assertTrue(page.contains(Policy.TABLE), "copy this into SECURITY.md:\n" + Policy.TABLE);
    }

    /** A word that is misspelt would allow nothing, and nobody would see why. */
    @Test
    void table_hasKnownWordsOnly() {
        List<Set<String>> known = List.of(words(Policy.Act.values()), words(Cast.values()), words(TrustLevel.values()),
                words(Provenance.Question.values()), words(Provenance.Home.values()), Set.of("here", "away"));
        Policy.TABLE.lines().skip(2).forEach(row -> {
            List<String> cells = Arrays.stream(row.split("\\|")).skip(1).map(String::strip).toList();
            for (int i = 0; i < known.size(); i++) {
                for (String word : cells.get(i).split(", ")) {
                    assertTrue(word.equals("any") || known.get(i).contains(word), word + " in " + row);
                }
            }
        });
    }

    private static Set<String> words(Enum<?>[] values) {
        return Stream.of(values).map(Policy::word).collect(Collectors.toSet());
    }

    @Test
    void decide_whatNoRowNames_isRefusedWithAReason() {
        Policy.Decision decision = Policy.decide(Policy.Act.ACHIEVE, Provenance.ofGuest("visitor"));
        assertEquals(Policy.Verdict.REFUSED, decision.verdict());
        assertEquals("nobody may achieve by local", decision.reason());
    }

    @Test
    void decide_agentOfAThirdDevice_comesOnlyWhereAPlanAsksForItsHome() {
        Address sender = Address.parse("SUPO");
        Provenance of = Provenance.of(sender, Cast.UNICAST, TrustLevel.CERTIFIED)
                .moving(Address.parse("CAFE"), Address.parse("ROMA"), false);
        assertEquals("[peer(certified,S),home(S)]", Policy.decide(Policy.Act.OFFER, of).asking("S"));
        Provenance own =
                Provenance.of(sender, Cast.UNICAST, TrustLevel.PROVISIONED).moving(sender, Address.parse("ROMA"),
                        false);
        assertEquals("", Policy.decide(Policy.Act.OFFER, own).asking("S"));
    }
}
