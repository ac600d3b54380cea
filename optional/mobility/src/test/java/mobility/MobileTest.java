package mobility;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.StreamSupport;

import jason.JasonException;
import jason.asSemantics.Message;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;
import jason.asSyntax.Trigger;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** An agent that sleeps does nothing, and is afterwards as it was. */
@Tag("newerJava")
class MobileTest {

    private static final String BUSY = """
            !a(1). !b.
            +!a(N) : N < 9 <- say(a,N); .wait({+never},20,_); !a(N+1).
            +!a(9).
            %s +!b <- say(b); !c(X); say(X); .wait({+never},30,_); say(d); .wait(20); !c(Y); say(Y); +done.
            +!c(c) <- say(c).
            +done <- say(done).
            """;

    @ParameterizedTest
    @ValueSource(strings = {"", "@x[atomic]"})
    void agent_asleepInAnyCycle_doesNothingAndThenGoesOn(String label) {
        List<String> all = Stage.of(BUSY.formatted(label)).untilDone(15).done.stream().sorted().toList();
        for (int before = 0; before < 36; before++) {
            Stage stage = Stage.of(BUSY.formatted(label));
            Mobile mobile = stage.front(new Mobile());
            stage.run(before);
            if (stage.ts.getC().hasPendingAction()) {
                continue;
            }
            List<String> done = List.copyOf(stage.done);
            mobile.fallAsleep();
            // Longer than its waits.
            for (int i = 0; i < 12; i++) {
                LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(5));
                stage.run(3);
            }
            assertEquals(done, stage.done);
            assertTrue(stage.ts.canSleep());
            mobile.awaken();
            assertFalse(mobile.isAsleep());
            assertEquals(all, stage.untilDone(15).done.stream().sorted().toList());
            assertNull(stage.ts.getC().getPendingIntentions().get(Mobile.ASLEEP));
        }
    }

    @Test
    void atomicWait_thatFailsMeanwhile_failsWhenAwake() {
        Stage stage;
        do { // its wait has not ended meanwhile
            stage = Stage.of("""
                    !b.
                    @x[atomic] +!b <- say(b); .wait({+never},20).
                    @y[atomic] -!b[error(E)] <- say(E); say(end).
                    """).run(4);
        } while (stage.done.size() > 1);
        Mobile mobile = stage.front(new Mobile());
        mobile.fallAsleep();
        for (int i = 0; i < 20; i++) {
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(5));
            stage.run(2);
        }
        assertEquals(List.of("say b"), stage.done);
        mobile.awaken();
        assertEquals(List.of("say b", "say wait_timeout", "say end"), stage.untilDone(3).done);
        assertFalse(stage.ts.getC().hasPendingIntention());
    }

    @Test
    void sleeper_cannotBeMovedASecondTime() {
        Stage stage = Stage.of("!go. +!go <- say(go).").run(1);
        stage.front(new Mobile()).fallAsleep();
        JasonException e = assertThrows(JasonException.class, () -> AgentStateWriter.write(stage.ts, null));
        assertEquals("traveller cannot travel: it is on its way already", e.getMessage());
    }

    @Test
    void whatComesToSleeper_waits() {
        Stage stage = Stage.of("+!go <- say(go). +told(X) <- say(told,X). +seen <- say(seen).").run(3);
        Mobile mobile = stage.front(new Mobile());
        stage.ts.getC().addMsg(new Message("tell", "bob", "traveller", "told(1)"));
        mobile.fallAsleep();
        stage.ts.getC().addExternalEv(new Trigger(Trigger.TEOperator.add, Trigger.TEType.achieve,
                ASSyntax.createLiteral("go")));
        stage.run(10);
        assertEquals(List.of(), stage.done);
        mobile.awaken();
        assertEquals(List.of("say go", "say told 1"), stage.run(10).done);
    }

    @Test
    void mindThatComes_findsWhatIsPerceivedAsNew() {
        Stage stage =
                Stage.of("!a. wet. light(5)[source(percept)]. dark[source(percept), source(bob)].").run(3);
        stage.front(new Mobile());
        Mobile.empty(stage.ts);
        assertEquals(List.of("dark[source(percept)]", "light(5)[source(percept)]"),
                StreamSupport.stream(stage.ts.getAg().getBB().spliterator(), false)
                        .filter(belief -> !AgentStateWriter.isJasons(belief)).map(Literal::toString).sorted().toList());
        Image image = new Image("+light(X)[source(percept)] <- say(light,X).\n+dark <- say(dark).", "");
        assertDoesNotThrow(() -> AgentStateReader.read(image)).enter(stage.ts, Optional.empty());
        Mobile.perceiveAnew(stage.ts);
        assertEquals(List.of("say dark", "say light 5"), stage.run(5).done.stream().sorted().toList());
    }

    /** If the bus has not sensed anything yet, an ask of its inspector fails. */
    @Test
    void inspector_whoseBusHasSensedNothingYet_asksAgainAndGoesHome() throws Exception {
        Path program = Path.of(System.getProperty("javino.root"), "examples/highway/inspector/inspector.asl");
        Stage stage = Stage.of("!inspect(bus). " + Files.readString(program).replace(".moveOut", "travel")
                .replace(".print", "say").replaceAll("\\.send\\(bus, askOne, [^;]*, (.*)\\)(;|\\.\\R)", "?$1$2")
                .replaceAll("wait\\(\\d+\\)", "wait(5)"));
        stage.untilDone(2);
        stage.ts.getAg().addBel(Literal.parseLiteral("proximity(3)"));
        stage.ts.getAg().addBel(Literal.parseLiteral("light(700)"));
        assertEquals(List.of("say I travel to  bus", "travel bus inquilinism",
                "say On  bus  I see an obstacle at  3  cm, and light  700", "travel SUPP mutualism",
                "say I am back from  bus : obstacle at  3  cm, light  700"), stage.untilDone(5).done);
    }
}
