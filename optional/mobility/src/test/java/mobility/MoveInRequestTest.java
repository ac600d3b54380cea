package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

import diffuser.gate.Policy;
import diffuser.gate.Provenance;
import diffuser.gate.TrustLevel;

import javino.protocol.Address;
import javino.protocol.Bytes;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Which plans let an agent in, by whose hands it comes and where it is at home. */
class MoveInRequestTest {

    private static final Address HERE = Address.parse("ROMA");
    private static final Address FROM = Address.parse("SUPO");

    private static Move offer(Protocol protocol, String home) {
        Move.Identity scout = new Move.Identity(Address.parse(home), "scout",
                Bytes.ofNumber(1, Move.Identity.TOKEN_LENGTH));
        return new Move(new Move.Key(false, FROM, 1), Move.State.READY, protocol, scout, "scout", List.of(), false,
                Optional.empty());
    }

    private static Provenance from(TrustLevel peer, Move move, boolean returns) {
        return move.provenance(peer, Optional.of(HERE), returns);
    }

    /** The deeds of an agent with one plan, or why it does not let the newcomer in. */
    private static String asked(String marks, TrustLevel peer, String home, boolean returns) {
        Move move = offer(Protocol.MUTUALISM, home);
        Provenance of = from(peer, move, returns);
        Policy.Decision decision = Policy.decide(Policy.Act.OFFER, of);
        Stage stage = Stage.of("+!moveIn(Agent, mutualism)[" + marks + "] <- welcome.");
        CompletableFuture<Void> answer = new CompletableFuture<>();
        try {
            MoveInRequest.pursue(stage.ts, move, of, decision, answer);
        } catch (RefusedException e) {
            return e.getMessage();
        }
        stage.run(10);
        assertTrue(answer.isDone());
        return String.join(",", stage.done);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '#', value = {
            "provisioned # SUPO # false # cast(unicast,From) # ''",
            "provisioned # ROMA # true  # cast(unicast,From) # ''",
            "provisioned # CAFE # false # cast(unicast,From) # [home(_)]",
            "provisioned # CAFE # false # cast(unicast,From),home(Home) # ''",
            "provisioned # CAFE # false # home(\"SUPO\") # no plan",
            "certified   # SUPO # false # cast(unicast,From) # [peer(certified,_)]",
            "certified   # SUPO # false # peer(certified,From) # ''",
            "certified   # ROMA # true  # cast(unicast,From) # [peer(certified,_)]",
            "certified   # CAFE # false # peer(certified,From) # [peer(certified,_),home(_)]",
            "certified   # CAFE # false # home(Home) # [peer(certified,_),home(_)]",
            "certified   # CAFE # false # peer(certified,From),home(Home) # ''",
            "provisioned # SUPO # false # cast(multicast,From) # no plan"})
    void plan_asksForWhatTheNewcomerIs_letsItIn(String peer, String home, boolean returns, String marks,
            String refusal) {
        String outcome = asked(marks, TrustLevel.valueOf(peer.toUpperCase(java.util.Locale.ROOT)), home, returns);
        assertTrue(refusal.isEmpty() ? outcome.equals("welcome") : outcome.contains(refusal), outcome);
    }

    @Test
    void plan_seesWhereTheNewcomerIsAtHome() throws RefusedException {
        Stage stage = Stage.of("""
                +!moveIn(A, mutualism)[cast(unicast, From), home(Home)] :
                    .term2string(From, "SUPO") & .term2string(Home, "CAFE") <- welcome.
                """);
        Move move = offer(Protocol.MUTUALISM, "CAFE");
        Provenance of = from(TrustLevel.PROVISIONED, move, false);
        CompletableFuture<Void> answer = new CompletableFuture<>();
        MoveInRequest.pursue(stage.ts, move, of, Policy.decide(Policy.Act.OFFER, of), answer);
        stage.run(10);
        assertEquals(List.of("welcome"), stage.done);
        Move other = offer(Protocol.MUTUALISM, "SUBB");
        Provenance elsewhere = from(TrustLevel.PROVISIONED, other, false);
        assertThrows(RefusedException.class, () -> MoveInRequest.pursue(stage.ts, other, elsewhere,
                Policy.decide(Policy.Act.OFFER, elsewhere), new CompletableFuture<>()));
    }

    @ParameterizedTest
    @EnumSource(value = TrustLevel.class, mode = EnumSource.Mode.EXCLUDE, names = "NONE")
    void offer_thatClaimsThisHome_isRefusedWhateverThePlans(TrustLevel peer) {
        Provenance of = from(peer, offer(Protocol.MUTUALISM, "ROMA"), false);
        for (Policy.Act act : List.of(Policy.Act.OFFER, Policy.Act.RETURN)) {
            for (boolean away : List.of(true, false)) {
                assertEquals(Policy.Verdict.REFUSED, Policy.decide(act, of.whileAway(away)).verdict());
            }
        }
        assertEquals(Policy.Verdict.REFUSED, Policy.decide(Policy.Act.OFFER, offer(Protocol.MUTUALISM, "SUPO")
                .provenance(peer, Optional.empty(), false)).verdict(), "where this address is not known");
    }

    @ParameterizedTest
    @EnumSource(value = TrustLevel.class, mode = EnumSource.Mode.EXCLUDE, names = "NONE")
    void offer_whileNobodyIsThereToAsk_isItsOwnReturnOrRefused(TrustLevel peer) {
        Provenance own = from(peer, offer(Protocol.MUTUALISM, "ROMA"), true).whileAway(true);
        assertEquals(Policy.Verdict.ALLOWED, Policy.decide(Policy.Act.RETURN, own).verdict());
        for (Provenance of : List.of(own, from(peer, offer(Protocol.MUTUALISM, "SUPO"), false).whileAway(true),
                from(peer, offer(Protocol.MUTUALISM, "CAFE"), false).whileAway(true))) {
            assertEquals(Policy.Verdict.REFUSED, Policy.decide(Policy.Act.OFFER, of).verdict());
        }
    }
}
