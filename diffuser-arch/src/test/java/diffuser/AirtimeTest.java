package diffuser;

import javino.fake.FakeBoard;
import javino.protocol.Capability;
import javino.protocol.Counter;
import javino.protocol.Status;

import org.junit.jupiter.api.Test;

/** What the agent knows of how long its board has sent. */
class AirtimeTest {

    private final FakeBoard board = new FakeBoard("antenna");

    @Test
    void airtime_inAContext_isTheShareOfTheHour() {
        board.setRise(Counter.RADIO_AIRTIME, 36);
        // The agent listens for silence, so the board is asked all the time.
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start : not .airtime(_,_) <- diffuser.note(unknown);
                    .port(antenna); .setMyRFId("SUPO"); .getRFMessages(open); .silence(1); !look.
                +!look : .airtime(S,M) & S >= 3 & M >= S & S <= 100 <- diffuser.note(share).
                +!look <- .wait(10); !look.
                """, board);
        agent.notes("unknown");
        agent.notes("share");
    }

    @Test
    void airtime_boardWithoutARadio_isNotKnown() {
        board.setCapabilities(Capability.SAYS_TAKEN);
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- .port(antenna); !look.
                +!look : not .airtime(_,_) <- diffuser.note(unknown).
                """, board);
        agent.notes("unknown");
    }

    @Test
    void message_boardFullForWantOfAirtime_failsAndSaysWhenToTryAgain() {
        board.refuse("ROMA ", Status.QUEUE_FULL).refuse("//SU", Status.QUEUE_FULL)
                .setCounter(Counter.AIRTIME_WAIT, 42);
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- .port(antenna); .setMyRFId("SUPO"); .send("//SU",tell,x); !tell; !ask.
                +undelivered(_,_,_)[source(percept),error(airtime_used),seconds(S)] <- diffuser.note(told,S).
                +!tell <- .diffuse("ROMA",tell,x).
                -!tell[error(airtime_used),seconds(S)] <- diffuser.note(again,S).
                +!ask <- .send("ROMA",askOne,x(_),_).
                -!ask[error(airtime_used),seconds(S)] <- diffuser.note(asked,S).
                """, board);
        agent.notes("told 42");
        agent.notes("again 42");
        agent.notes("asked 42");
    }
}
