package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

import jason.JasonException;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Whenever an agent is moved, it does what it would have done at home, and nothing else. */
class EveryCycleTest {

    private static final int CYCLES = 80;

    static final Map<String, String> PROGRAMS = new TreeMap<>(Map.ofEntries(
            Map.entry("values come back through levels", """
                    !start.
                    +!start <- !outer(X,k); say(X); !outer(Y,X); say(Y).
                    +!outer(Y,K) <- !inner(Z,Q); ?half(Q,H); Y = r(Z,K,H).
                    +!inner(W,4) <- !leaf(W).
                    +!leaf(V) <- V = f(U); !bind(U).
                    +!bind(9).
                    +?half(N,N/2) <- say(half,N).
                    """), Map.entry("recursion with tail calls", """
                    !count(5,R).
                    +!count(N,R) : N > 0 <- say(N); !sum(N,0,S); say(sum,S); !count(N-1,R).
                    +!count(0,done).
                    +!sum(0,S,S).
                    +!sum(N,A,S) : N > 0 <- !sum(N-1,A+N,S).
                    """), Map.entry("the same variable under two names", """
                    !start.
                    +!start <- !pair(X,X); say(X).
                    +!pair(A,B) <- A = B; !set(B); say(A,B).
                    +!set(C) <- !deeper(C,D); say(D).
                    +!deeper(E,F) <- E = F; F = end.
                    """), Map.entry("failures find their goals", """
                    !start.
                    +!start <- !a(1,X); say(after,X); !a(2,Y); say(after,Y).
                    +!a(N,X) <- !b(N); X = unreached.
                    -!a(N,X)[error(E)] : N > 1 <- say(failed,N,E); X = rescued.
                    +!b(1) <- !c(1).
                    +!b(2) <- !d(2).
                    +!d(N) <- stumble(N).
                    +!c(N) <- say(trying,N); stumble(N).
                    -!c(1)[error(E)] <- say(c,E); !tell(T); say(T); .fail(worse).
                    -!a(1,X)[error(E)] <- say(a,E); X = second.
                    +!tell(told).
                    """), Map.entry("loops", """
                    p(1). p(2). p(3). n(0).
                    !start.
                    +!start <- Z = kept; for (p(X)) { !twice(X,Y); say(X,Y,Z) };
                        while (n(N) & N < 3) {
                            -+n(N+1); !twice(N,M); say(round,N,M); for (p(Q) & Q > 1) { say(in,Q,N) }
                        };
                        say(Z); .count(p(_),C); say(C).
                    +!twice(X,X*2).
                    """), Map.entry("choices", """
                    limit(3). !start(1). !start(5).
                    over(X) :- limit(L) & X > L & not .member(X,[7,8]).
                    +!start(N) <- if (over(N)) { say(over,N); !x(N,R) } elif (N > 100) { say(never) } else { R = low };
                        say(R).
                    +!x(N,N+.count(limit(_))).
                    """), Map.entry("events and beliefs", """
                    !start.
                    +!start <- +a(1)[deg(2)]; ++b(2); -+c(3); say(here); -a(1); !!later(X,f(X)); say(end).
                    +a(X)[deg(D)] <- say(plus,a,X,D); .abolish(none).
                    -a(X) <- say(minus,a,X).
                    +b(X) : c(Y) <- say(b,X,Y).
                    +b(X) <- say(b,X).
                    +!later(A,f(B)) <- A = 1; say(A,B).
                    """), Map.entry("atomic plans", """
                    !one. !two.
                    @o[atomic] +!one <- say(a); !in(X); say(X); +done(one).
                    +!in(X) <- say(b); X = c.
                    +!two <- say(d); say(e); say(f).
                    +done(X) <- say(done,X).
                    """), Map.entry("suspended goals", """
                    !start.
                    +!start <- !!work(1); !!self; say(go); .suspend(work(1)); say(x); say(y); .resume(work(1)); say(z);
                        .resume(self).
                    +!work(N) <- say(w1,N); say(w2,N); say(w3,N); say(w4,N).
                    +!self <- say(s1); .suspend; say(s2).
                    """), Map.entry("goals that end from outside", """
                    !start.
                    +!start <- !!long(1,R); say(a); .succeed_goal(long(1,_)); say(b); !!again(2); say(c);
                        .fail_goal(again(2)); say(d).
                    +!long(N,R) <- !part(N); say(long,N).
                    +!part(N) <- say(p1); say(p2); say(p3); say(p4); say(p5); say(p6).
                    +!again(N) <- !part(N); say(never).
                    -!again(N) <- say(stopped,N).
                    """), Map.entry("conditions of goals", """
                    !start.
                    +!start <- !hold(4); say(held).
                    +!hold(X) <: have(X) <- say(h1,X); !!get(X); say(h2); say(h3); say(h4); say(h5).
                    +!get(X) <- say(get); +have(X).
                    """), Map.entry("plans within plans", """
                    !start.
                    +!start <- !outer(7); say(out).
                    +!outer(N) <- !inner(M); say(N,M). {
                        +!inner(K) <- say(inner,N); K = N + 1.
                    }
                    """), Map.entry("plans as values", """
                    !start.
                    +!start <- A = { say(one); !two(X); say(X) }; !do(A);
                        .add_plan({ +!new(Y) <- say(new,Y) }); !new(3);
                        !learn({ +!taught(Z) <- say(Z) }); !taught(4); .remove_plan(first); !first(1).
                    +!do(P) <- P; say(did).
                    +!two(2).
                    +!learn(P) <- .add_plan(P).
                    @first +!first(N) <- say(no).
                    +!first(N) <- say(last,N).
                    """), Map.entry("a plan that is removed while it runs", """
                    !start.
                    @me +!start <- .remove_plan(me); say(a); !b(X); say(X); say(b).
                    +!b(gone).
                    """), Map.entry("variables without a name", """
                    k(_,1). k(X,X). k([_|_],2). b(1)[source(bob)].
                    !start.
                    +!start <- !a(_,R); say(R); !b([_,Q,_|T],Q,T); say(Q); ?k(z,V); say(V); L = [_,_,3]; !c(L); say(L);
                        -b(1)[source(_)]; !k(f(1)[z(Y)]); say(Y).
                    +!a(X,p(X,Y,_)) <- X = 1; Y = _.
                    +!b([A|_],q,[]) <- A = 2; say(A).
                    +!c([1,2|_]).
                    +!k(_[z(W)]) <- W = 7; say(k).
                    -b(_) <- say(gone).
                    """), Map.entry("texts and names", """
                    !start("a \\"b\\"\\nc",'ROMA',[1,"x",[Y|T]],-2.5).
                    +!start(S,A,L,N) <- say(S,A,N,ns::p); L = [B,C|D]; !go(L,N); +ns::q(A); ?ns::q(Z); say(Z).
                    +!go([H|T],N) <- say(H,T,1/(N*4)).
                    """)));

    @TestFactory
    Stream<DynamicTest> agent_movedAtAnyCycle_doesTheSame() {
        return PROGRAMS.entrySet().stream()
                .map(program -> DynamicTest.dynamicTest(program.getKey(), () -> check(program.getValue())));
    }

    private static void check(String program) throws Exception {
        List<String> atHome = Stage.of(program).run(CYCLES).done.stream().map(EveryCycleTest::plain).toList();
        assertTrue(atHome.size() > 2, () -> "it does too little: " + atHome);
        int moves = 0;
        for (int before = 0; before < CYCLES / 2; before++) {
            Stage here = Stage.of(program).run(before);
            Image image;
            try {
                image = AgentStateWriter.write(here.ts, null);
            } catch (JasonException e) {
                assertTrue(e.getMessage().contains("waits for say(") || e.getMessage().contains("waits for stumble("),
                        e.getMessage());
                continue;
            }
            moves++;
            Stage there = Stage.of(image);
            assertEquals(image, AgentStateWriter.write(there.ts, null), "the texts after " + before + " cycles");
            List<String> done = new ArrayList<>(here.done);
            done.addAll(there.run(CYCLES).done);
            assertEquals(atHome, done.stream().map(EveryCycleTest::plain).toList(),
                    () -> "moved as\n" + image.program() + "\n--\n" + image.state());
            // It has been left as it was.
            assertEquals(atHome, here.run(CYCLES).done.stream().map(EveryCycleTest::plain).toList());
        }
        assertTrue(moves > CYCLES / 10, "it hardly moved");
    }

    /** Variables without a value have other numbers in each run. */
    private static String plain(String done) {
        return done.replaceAll("_\\d+\\w*", "_");
    }
}
