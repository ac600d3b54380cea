package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import jason.asSemantics.Agent;

import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The sender of an agent has a key, and may send what it likes. */
class HostileImageTest {

    private static final int MUTATIONS = 6_000;

    /** Whether the class of {@code mobility.bomb} has been loaded to run. */
    static boolean exploded;

    private static String refusal(String program, String state) {
        RefusedException e =
                assertThrows(RefusedException.class, () -> AgentStateReader.read(new Image(program, state)));
        assertFalse(e.getMessage().matches("(?s).*[\\p{Cc}\\u2028\\u202e].*"),
                "it commands a terminal: " + e.getMessage());
        assertTrue(e.getMessage().length() < 300, e.getMessage());
        return e.getMessage();
    }

    @ParameterizedTest
    @ValueSource(strings = {"+!kqml_received(A,B,C,D) <- true.", "@x +!X <- true.", "+X <- true.", "-!_ <- true.",
            "+jag_sleeping <- a.", "+!kqml::add_all_kqml_received(a) <- a.", "+NS::p <- a.",
            "+!a <- !kqml_received(a).",
            "+!a <- .add_plan({ +!kqml_received(A,B,C,D) <- b }).", "+!a[source(kqml_received)] <- a.",
            "kqml_received(X) :- a.", "kqml::p(X) :- a.", "p :- kqml::q(X).", "@kqmlReceivedAchieve +!a <- b.",
            "@p__3 +!a <- b.", "+!a <- b. +!c <- d.", "+!a <- b. } +!c <- d.", "a :- b. c :- d.", "+!a <- b", "a.",
            "!a.", "{ include(\"x.asl\") }", "a :- ", "+!a <- _1; _1.", "+!a <- b. { +!X <- c. }",
            "+!a <: kqml_received(X) <- c.", "+!a : jag_x <- c.", " +!a <- b.", "+!a <- b.\r", "+!a <- b.\u0000",
            "+!a <- .print(\"\u202e\").", "+!a\u009b <- b.", "+!a\u2028+!b.", "+!a <- b.\n\n+!c <- d.",
            "+!a <- no.such(1).", "+!a <- .nosuch(1).",
            "+!a <- java.lang.Runtime.exec(1).", "+!a : java.lang.Thread.sleep(1) <- b.",
            "@l +!a <- b.\n@l +!c <- d.", "+!a <- +NS::p.", "+!a <- !NS::p.", "+!a <- ?NS::p.",
            "+!a <- if (b) { -NS::p }.",
            "+!a <- p(NS::q).", "+!a <- NS::p(NS::q).", "+!a <- NS::p(kqml_received(b)).",
            "+!a <- NS::kqml_received(b).",
            "+!a : NS::p <- b.", "+!a <- b(NS) . { +NS::p <- c. }"})
    void program_hostile_isRefused(String program) {
        refusal(program, "");
    }

    @ParameterizedTest
    @ValueSource(strings = {"Bp(1).", "Bp(1), q", "Bp) q(", "B", "B3", "BX", "B\"a\"", "B[a]", "B{ +!a }",
            "B{ a :- b }",
            "Bp(1+2)", "Bp(.count(x))", "Bp(math.random)", "B.print(a)", "B.stopMAS", "Bp(X) :- q", "Bp & q",
            "Bp[source(percept)]", "Bp[source(a),source(percept)]", "Bkqml_received(a)", "Bp(kqml::q)", "Bkqml::q",
            "Bjag_shutting_down", "BNS::p", "Bp(\"\n\")", "Bp(\t)", "Bp(_1)", "Zp", "p", " ",
            "Bp\n", "\nBp", "I", "S", "I!a", "I+!X", "I+!kqml_received(a,b,c,d)", "I+jag_sleeping",
            "I+p[source(percept)]", "I+!p[source(percept)]", "I+!p(1+2)", "I+!a b", "F0,0,+!a", "I\nF1,0,+!a",
            "I\nF0,3,+!a", "I\nF0,0", "I\nF-1,0,+!a", "I\nF99999999999,0,+!a", "I\nF0,99999999999,+!a",
            "I\nF0,0,+!a\nVX", "I\nF0,0,+!a\nVX,1,X,2", "I\nF0,0,+!a\nV1,2", "I\nF0,0,+!a\nVX,1]", "I\nF0,0,+!a\nVX,X",
            "I\nF0,0,+!a\nVX,math.random", "I\nF0,0,+!a\nRX,Y", "I\nF0,0,+!a\nRX,3", "I\nF0,0,+!a\nVX,1\nDb",
            "I\nF0,0,+!a\nD", "I\nF0,0,+!a\nD!kqml_received(a,b,c,d)", "I\nF0,0,+!a\nDb }; c",
            "I\nF0,0,+!a\nD.loop(a,{ b },3)", "I\nF0,0,+!a\nD.loop(a,{ b },[X])",
            "I\nF0,0,+!a\nD.foreach(a,{ b },3,[])", "I\nF0,0,+!a\nD.foreach(a,{ b },[[X,1],3],[])",
            "I\nF0,0,+!a\nDno.such(1)", "I\nF0,0,+!a\nVX,no.such(1)", "I\nF0,0,+!a[source(percept)]",
            "P+!X <- a.", "Pp :- q.", "I\nF0,0,+!a\nVX[a],1"})
    void state_hostile_isRefused(String state) {
        refusal("+!a <- b; c.", state);
    }

    /** As in the plans of JaCaMo, by which agents focus on artifacts. */
    @ParameterizedTest
    @ValueSource(strings = {"+!a(NS) <- NS::p(b)[c].", "+!a(NS) <- if (b) { NS::p } else { ns::p }."})
    void program_plainActionOfSomeNamespace_isRead(String program) throws Exception {
        assertNotNull(AgentStateReader.read(new Image(program, "")));
    }

    @Test
    void whatIsMissingHere_isNamed() {
        assertEquals("this MAS lacks the internal action no.such", refusal("+!a <- no.such(1).", ""));
    }

    @Test
    void reading_neitherLoadsNorRunsAnything() throws Exception {
        AgentStateReader.read(new Image("+!a : mobility.bomb(1) & X = mobility.bomb <- mobility.bomb(1); .print(1/0).\n"
                + "a :- mobility.bomb(X).", "Bp(-3)\nI+!a(mobility.bomb(1))\nI\nF0,0,+!a\nVX,mobility.bomb(1)"));
        assertFalse(exploded);
    }

    @ParameterizedTest
    @CsvSource({"5000,B,p(%d),''", "300,I,+!a(%d),''", "2000,'',+!a(%d) <- b.,p"})
    void tooMany_areRefused(int number, String tag, String line, String where) {
        String text = IntStream.range(0, number).mapToObj(i -> tag + line.replace("%d", "" + i))
                .collect(Collectors.joining("\n"));
        assertTrue((where.isEmpty() ? refusal("", text) : refusal(text, "")).contains("more than"));
    }

    static Stream<String> bombs() {
        int many = 60_000;
        return Stream
                .of("(", "[", "{", "f(", "not ", "not (", "-", "a & ", "a | ", "1 + ", "X = ", "a[", "~", "{ +!a <- ",
                        "if (a) { ", "V::", "[a|", "!", "\"", "'", "a;", "a,", "_")
                .flatMap(
                        part -> Stream.of(12, 60, 1000, many / part.length()).map(part::repeat));
    }

    @ParameterizedTest
    @MethodSource("bombs")
    void deepText_isReadOrRefusedAtOnce(String bomb) {
        List<Image> images = List.of(new Image("+!a : " + bomb + "b <- c.", ""), new Image("+!a <- " + bomb + ".", ""),
                new Image("p :- " + bomb + "b.", ""), new Image(bomb, bomb), new Image("", "B" + bomb),
                new Image("", "Bp(" + bomb + ")"), new Image("+!a.", "I\nF0,0,+!a\nD" + bomb),
                new Image("+!a.", "I\nF0,0,+!a\nVX," + bomb), new Image("", "I+!" + bomb));
        for (Image image : images) {
            // A text that hangs would hang the build; there is no other limit.
            Assertions.assertTimeoutPreemptively(Duration.ofMinutes(2), () -> read(image));
        }
    }

    /** @return whether it is an agent. */
    private static boolean read(Image image) {
        try {
            Stage.of(AgentStateReader.read(image), new Agent());
            return true;
        } catch (RefusedException e) {
            return false;
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {17})
    @Tag("verify")
    void genuineTexts_mutated_areReadOrRefused(int seed) throws Exception {
        Random random = new Random(seed);
        List<Image> genuine = genuine();
        int read = 0;
        for (int i = 0; i < MUTATIONS; i++) {
            Image image = genuine.get(random.nextInt(genuine.size()));
            Image other = genuine.get(random.nextInt(genuine.size()));
            read += read(new Image(mutated(image.program(), other.state(), random),
                    mutated(image.state(), other.program(), random))) ? 1 : 0;
        }
        assertTrue(read > MUTATIONS / 50 && read < MUTATIONS, read + " of " + MUTATIONS + " were agents");
    }

    @Tag("soak")
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void moreTexts_mutated_areReadOrRefused(int seed) throws Exception {
        genuineTexts_mutated_areReadOrRefused(seed);
    }

    private static List<Image> genuine() throws Exception {
        List<Image> images = new ArrayList<>();
        for (int cycles : new int[] {3, 6, 9, 12, 15}) {
            for (String program : EveryCycleTest.PROGRAMS.values()) {
                Stage stage = Stage.of(program).run(cycles);
                if (!stage.ts.getC().hasPendingAction()) {
                    images.add(AgentStateWriter.write(stage.ts, null));
                }
            }
        }
        return images;
    }

    private static String mutated(String text, String other, Random random) {
        StringBuilder result = new StringBuilder(text);
        for (int changes = random.nextInt(3); changes > 0 && result.length() > 0; changes--) {
            int at = random.nextInt(result.length());
            int end = Math.min(result.length(), at + 1 + random.nextInt(8));
            switch (random.nextInt(5)) {
                case 0 -> result.delete(at, end);
                case 1 -> result.insert(at, pick(random));
                case 2 -> result.replace(at, end, pick(random));
                case 3 -> result.insert(at, result.substring(at, end));
                default -> {
                    if (!other.isEmpty()) {
                        int from = random.nextInt(other.length());
                        result.insert(at, other, from, Math.min(other.length(), from + 20));
                    }
                }
            }
        }
        return result.toString();
    }

    private static String pick(Random random) {
        String[] parts =
                {"\n", "(", ")", "[", "]", "{", "}", ",", ".", "V_1", "_", "X", "\"", "'", "B", "I", "S", "F0,0,", "D",
                        "V", "R", "+", "!", "::", " :- ", " <- ", "|", "~", "0", "-", ".loop(", "source(percept)", "\\",
                        "\u00e9", "/*"};
        return parts[random.nextInt(parts.length)];
    }
}
