package uppaal;

import java.util.List;

/** Networks so small that their answers can be seen. */
public final class TinyNetworks {
    /**
     * A network, a property and what is true of them.
     *
     * @param rule the rule of UPPAAL's that it shows
     * @param states how many states can be reached
     * @param deadlocks how many of them have no next one
     * @param property the property that is asked
     * @param holds whether that holds
     */
    public record Tiny(String rule, Sketch sketch, int states, int deadlocks, String property, boolean holds) {
        @Override
        public String toString() {
            return rule;
        }
    }

    /** All of them. */
    public static List<Tiny> all() {
        return List.of(
                new Tiny("a broadcast needs no listener",
                        Sketch.of("broadcast chan c;").template("P", "a -> b; sync c!"), 2, 1, "E<> P.b", true),
                new Tiny("a binary sender needs one",
                        Sketch.of("chan c;").template("P", "a -> b; sync c!"), 1, 1, "E<> P.b", false),
                new Tiny("nobody hears himself",
                        Sketch.of("broadcast chan c;").template("P", "a -> b; sync c!", "a -> d; sync c?"), 2, 1,
                        "E<> P.d", false),
                new Tiny("who can hear a broadcast must",
                        Sketch.of("broadcast chan c; bool deaf = true;").template("P", "a -> b; sync c!")
                                .template("Q", "a -> b; sync c?").template("S", "a -> b; guard !deaf; sync c?"),
                        2, 1, "A[] P.b imply (Q.b && S.a)", true),
                new Tiny("who can hear in two ways chooses",
                        Sketch.of("broadcast chan c;").template("P", "a -> b; sync c!")
                                .template("Q", "a -> b; sync c?", "a -> d; sync c?")
                                .template("S", "a -> b; sync c?", "a -> d; sync c?"),
                        5, 4, "E<> Q.b && S.d", true),
                new Tiny("a binary sender meets exactly one",
                        Sketch.of("chan c;").template("P", "a -> b; sync c!")
                                .template("Q", "a -> b; sync c?").template("S", "a -> b; sync c?"),
                        3, 2, "A[] !(Q.b && S.b)", true),
                new Tiny("a committed location is left first",
                        Sketch.of("bool n;").template("P", "a -> b!; set n = 1", "b! -> d; set n = 0").template("Q",
                                "a -> b; guard n"),
                        3, 1, "A[] Q.a", true),
                new Tiny("an ordinary one is not",
                        Sketch.of("bool n;").template("P", "a -> b; set n = 1", "b -> d; set n = 0").template("Q",
                                "a -> b; guard n"),
                        5, 2, "A[] Q.a", false),
                new Tiny("a committed listener lets others speak to it, and only to it",
                        Sketch.of("broadcast chan c, d;").template("P", "a -> b; sync c!", "a -> e; sync d!")
                                .template("Q", "w! -> b; sync c?"),
                        2, 1, "A[] !P.e", true),
                new Tiny("two committed locations are left in any order",
                        Sketch.of("").template("P", "a! -> b")
                                .template("Q", "a! -> b").template("S", "a -> b"),
                        5, 1, "A[] S.b imply (P.b && Q.b)", true),
                new Tiny("a committed location without a way out stops all",
                        Sketch.of("").template("P", "a! -> b; guard false").template("Q", "a -> b"), 1, 1,
                        "E<> deadlock", true),
                new Tiny("guards are asked before assignments are made",
                        Sketch.of("chan c; int[0,1] x;").template("P", "a -> b; sync c!; set x = 1")
                                .template("Q", "a -> b; guard x == 0; sync c?"),
                        2, 1, "E<> Q.b", true),
                new Tiny("and not after them",
                        Sketch.of("broadcast chan c; int[0,1] x;").template("P", "a -> b; sync c!; set x = 1")
                                .template("Q", "a -> b; guard x == 1; sync c?"),
                        2, 1, "E<> Q.b", false),
                new Tiny("the sender assigns first, then the listeners in their order",
                        Sketch.of("broadcast chan c; int[0,9] x;").template("P", "a -> b; sync c?; set x = x * 2")
                                .template("Q", "a -> b; sync c?; set x = x + 3")
                                .template("S", "a -> b; sync c!; set x = 1"),
                        2, 1, "A[] S.b imply x == 5", true),
                new Tiny("a counter counts to its guard",
                        Sketch.of("int[-2,3] x = -2;").template("P", "a -> a; guard x < 3; set x++"), 6, 1,
                        "A[] deadlock imply x == 3", true),
                new Tiny(
                        "time passes as far as an invariant lets it, and a clock is counted one past its largest "
                                + "number",
                        Sketch.of("clock x;").template("P", "a{x<=3} -> b; guard x >= 2"), 7, 1, "E<> P.b", true),
                new Tiny("no step leads to where an invariant is false",
                        Sketch.of("clock x;").template("P", "a -> b{x<=1}; guard x >= 2"), 4, 1, "E<> P.b", false),
                new Tiny("a reset comes before the invariant is asked, which may stop time",
                        Sketch.of("clock x;").template("P", "a -> b{x<=1}; guard x >= 2; set x = 0"), 6, 1,
                        "E<> P.b && deadlock", true),
                new Tiny("two clocks run at one speed",
                        Sketch.of("clock x, y;").template("P", "a -> b; guard x == 2; set x = 0",
                                "b -> d; guard x == 1 && y == 3"),
                        12, 3, "E<> P.d", true),
                new Tiny("no time passes at a committed location",
                        Sketch.of("clock x;").template("P", "a! -> b; guard x >= 1"), 1, 1, "E<> P.b", false),
                new Tiny("no time passes at an urgent location, but others may move",
                        Sketch.of("clock x;").template("P", "a~ -> b; guard x >= 1")
                                .template("Q", "a -> b"),
                        2, 1, "A[] !P.b", true),
                new Tiny("no time passes while an urgent channel can be used",
                        Sketch.of("clock x; urgent chan c; bool on;").template("P", "a -> b; guard on; sync c!")
                                .template("Q", "a -> b; sync c?").template("S", "a -> b; guard x == 1; set on = true",
                                        "b -> d; guard x == 2"),
                        10, 3, "A[] S.d imply P.b", true),
                new Tiny("each element of an array is a variable, a clock or a channel of its own",
                        Sketch.of("const int N = 2; int[0,3] n[N] = {1, N}; clock x[N]; chan c[N];")
                                .template("P",
                                        "a{x[1]<=1} -> b; guard x[0] >= 1; sync c[N-1]!; set n[0]++, n[1] = n[0]")
                                .template("Q", "a -> b; sync c[0]?").template("S", "a -> b; sync c[1]?"),
                        4, 1, "A[] (S.b imply n[0] == 2 && n[1] == 2) && Q.a", true),
                new Tiny("one of two values is chosen",
                        Sketch.of("int[0,3] n; clock x;").template("P", "a -> b; set n = n == 0 ? 2 : n - 1",
                                "b -> d; guard x >= (n == 2 ? 1 : 2)"),
                        11, 1, "E<> P.d", true),
                new Tiny("an invariant may ask a variable, which a step of another may not make false",
                        Sketch.of("clock x; int[0,3] n = 2;").template("P", "a{x<=n} -> b; guard x >= 2")
                                .template("Q", "a -> b; set n = 1"),
                        11, 2, "A[] !(P.a && Q.b && n == 2)", true),
                new Tiny("a listener's invariant counts too",
                        Sketch.of("broadcast chan c; clock x;").template("P", "a -> b; guard x >= 2; sync c!")
                                .template("Q", "a -> b{x<=1}; sync c?"),
                        4, 1, "E<> P.b", false),
                new Tiny("a loop has no deadlock",
                        Sketch.of("chan c;").template("P", "a -> b; sync c!", "b -> a")
                                .template("Q", "a -> a; sync c?"),
                        2, 0, "A[] not deadlock", true));
    }

    private TinyNetworks() {
    }
}
