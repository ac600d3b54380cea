package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;

import org.junit.jupiter.api.Test;

/** An agent is the same after its texts have been written and read. */
class ImageTest {

    @Test
    void agent_writtenInSomeStep_goesOnBehindIt() throws Exception {
        Stage there = Stage.of("!tour(3). +!tour(N) : N > 0 <- say(N); mobility.leave; say(then,N+1).").moved();
        there.run(10);
        assertEquals(List.of("say then 4"), there.done);
    }

    @Test
    void subgoal_returnsValueToItsCaller_throughTwoLevels() throws Exception {
        Stage there = Stage.of("""
                !start.
                +!start <- !outer(X,k); say(X).
                +!outer(Y,K) <- !inner(Z); Y = r(Z,K).
                +!inner(W) <- mobility.leave; W = 5.
                """).moved();
        there.run(20);
        assertEquals(List.of("say r(5,k)"), there.done);
    }

    @Test
    void failure_findsItsGoal() throws Exception {
        Stage there = Stage.of("""
                !start.
                +!start <- !risky(1,X); say(after,X).
                +!risky(N,X) <- !deeper(N); X = unreached.
                -!risky(N,X)[error(E)] <- say(failed,N,E); X = rescued.
                +!deeper(N) <- mobility.leave; .fail(oops).
                """).moved();
        there.run(20);
        assertEquals(List.of("say failed 1 internal_action", "say after rescued"), there.done);
    }

    @Test
    void program_isTheSameOnEachSide() throws Exception {
        Stage here = Stage.of("""
                limit(7). seen(b,2)[deg(3)]. seen(a,1). ~wet. text("a \\"b\\"\\nc"). odd('ROMA').
                near(X,Y) :- limit(L) & X - Y < L & not far(100).
                far(X) :- .count(seen(_,_)) > X | X = -3.
                !go.
                @mine[atomic,note("x")] +!go : near(1,2) & limit(N) <- if (N > 3) { +big } else { !small; -big };
                    while (cond(Q) & Q < 4) { +foo(Q) }; for (seen(A,_)) { note(A) }; X = .count(seen(_,_));
                    .wait({+done(_)},100); W = {!a; ?b(_)}; Z = math.max(1,-2); mobility.leave; say(X,Z,N).
                @[atomic] +!small.
                +!g[scope] <: limit(9) <- a. { @in +e(V) <- b(V). -!c <- d. }
                ^!go[state(S)] : S = never <- true.
                """);
        here.run(60);
        Image image = ImageWriter.write(here.ts, null);
        assertEquals(image, ImageWriter.write(Stage.of(image).ts, null));
    }
}
