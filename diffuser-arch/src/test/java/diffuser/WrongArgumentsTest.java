package diffuser;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvSource;

import javino.fake.FakeBoard;
import javino.protocol.Outcome;

class WrongArgumentsTest {

    private static final String PROGRAM = """
            !start.
            +!start <- .port(desk); !do.
            +!do <- %s; diffuser.note(done).
            -!do[error(E),error_msg(M)] <- diffuser.note(E,":",M).
            """;

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0', value = {
            ".port                             | wrong_arguments | From 1 to 2 arguments are expected",
            ".port(a,b,c)                      | wrong_arguments | From 1 to 2 arguments are expected",
            ".port(5)                          | wrong_arguments | a port's name such as \"/dev/ttyACM0\"",
            ".port(p(1))                       | wrong_arguments | not 'p(1)'",
            ".port(_)                          | wrong_arguments | a port's name such as",
            ".port(\"\")                       | wrong_arguments | a port's name such as",
            ".percepts                         | wrong_arguments | From 1 to 2 arguments are expected",
            ".percepts(closed)                 | wrong_arguments | open, block or close was expected, not 'closed'",
            ".percepts(3)                      | wrong_arguments | open, block or close was expected, not '3'",
            ".limit                            | wrong_arguments | From 1 to 2 arguments are expected",
            ".limit(soon)                      | wrong_arguments | milliseconds from 0 to 3600000",
            ".limit(-1)                        | wrong_arguments | not '-1'",
            ".limit(3600001)                   | wrong_arguments | not '3600001'",
            ".limit(X)                         | wrong_arguments | milliseconds from 0 to 3600000",
            ".filter(only,a(X),X > 1,b)        | wrong_arguments | a percept, and perhaps a comparison, was",
            ".filter                           | wrong_arguments | From 1 to 4 arguments are expected",
            ".filter(except)                   | wrong_arguments | a percept, and perhaps a comparison, was expected",
            ".filter(light(X))                 | wrong_arguments | except, only or remove was expected, not 'light(X)'",
            ".filter(except,3)                 | wrong_arguments | a percept such as light(X), or a list of such",
            ".filter(only,[a,3])               | wrong_arguments | not '[a,3]'",
            ".filter(only,a(X),b(X))           | wrong_arguments | a comparison of the percept's values, such as X < "
                    + "20",
            ".filter(only,a(X),X > 1 & b(X))   | wrong_arguments | a comparison of the percept's values",
            ".filter(remove,some)              | wrong_arguments | all, except or only was expected after remove, "
                    + "not 'some'",
            ".airtime(_)                       | wrong_arguments | 2 arguments are expected",
            ".silence                          | wrong_arguments | One argument is expected",
            ".silence(long)                    | wrong_arguments | milliseconds from 0 to 3600000 were expected, not "
                    + "'long'",
            ".silence(-0.5)                    | wrong_arguments | not '-0.5'",
            ".silence(3600001)                 | wrong_arguments | not '3600001'",
            ".infrastructure(lte)              | wrong_arguments | 2 arguments are expected",
            ".infrastructure(3,[com])          | wrong_arguments | a name for the infrastructure was expected, not '3'",
            ".infrastructure(_,[com])          | wrong_arguments | a name for the infrastructure was expected",
            ".infrastructure(lte,com)          | wrong_arguments | a list of com and mob, or [], was expected, not "
                    + "'com'",
            ".infrastructure(lte,[com,car])    | wrong_arguments | not '[com,car]'",
            ".infrastructure(lte,[\"com\"])    | wrong_arguments | a list of com and mob, or [], was expected",
            ".infrastructure(lte,X)            | wrong_arguments | a list of com and mob, or [], was expected",
            ".setMyRFId                        | wrong_arguments | One argument is expected",
            ".setMyRFId(\"ROM\")               | bad_address     | \"ROM\" has 3",
            ".setMyRFId(\"RO!A\")              | bad_address     | '!'",
            ".setMyRFId(\"//SU\")              | bad_address     | a device's id begins with one of A-Z a-z 0-9",
            ".setMyRFId(broadcast)             | bad_address     | a device's id begins with",
            ".setMyRFId(\"++++\")              | bad_address     | nothing can be sent to it",
            ".setMyRFId(1234)                  | bad_address     | write it as a string",
            ".setMyRFId(_)                     | bad_address     | write it as a string",
            ".getRFMessages                    | wrong_arguments | One argument is expected",
            ".getRFMessages(yes)               | wrong_arguments | open or block was expected, not 'yes'",
            ".diffuse(broadcast,tell)          | wrong_arguments | 3 arguments are expected",
            ".diffuse(everyone,tell,help)      | bad_address     | everyone is no RF address",
            ".diffuse(\"+FAA\",tell,help)      | bad_address     | nothing can be sent to it",
            ".diffuse(broadcast,sing,help)     | wrong_arguments | the radio takes only tell, untell,",
            ".diffuse(broadcast,askOne,help)   | not_sealed      | askOne goes to a device or a group, not to all",
            ".diffuse(broadcast,\"tell\",help) | wrong_arguments | a performative such as tell was expected, not",
            ".diffuse(broadcast,tell,3)        | bad_content     | a belief, a goal or a list of such was expected",
            ".diffuse(broadcast,tell,\"help\") | bad_content     | a belief, a goal or a list of such was expected",
            ".diffuse(\"ROMA\",sorry,\"x\")    | wrong_arguments | untellHow, not sorry",
            ".diffuse(\"ROMA\",tellHow,go)    | bad_content     | a plan such as { +!go <- run }, or a list of such",
            ".diffuse(\"ROMA\",untellHow,3)   | bad_content     | a plan's label or a list of such was expected",
            ".diffuse(\"ROMA\",askHow,go)     | bad_content     | a triggering event such as { +!go(_) } was expected",
            ".diffuse(\"ROMA\",askOne,3)      | bad_content     | a belief was expected",
            ".diffuse(broadcast,tell,a__b(1))  | bad_content     | a name with two underlines may mean something",
            ".filter(except,_)                 | wrong_arguments | a percept such as light(X), or a list of such",
            ".deliver(\"ROMA\",tell)          | wrong_arguments | 3 arguments are expected",
            ".deliver(broadcast,tell,help)     | wrong_arguments | not ////, as messages to all or to a group",
            ".deliver(\"//SU\",tell,help)     | wrong_arguments | not acknowledged; use .diffuse",
            ".deliver(\"SU\\\\\",tell,help)   | wrong_arguments | not acknowledged; use .diffuse",
            ".deliver(everyone,tell,help)      | bad_address     | everyone is no RF address",
            ".deliver(\"ROMA\",sing,help)     | wrong_arguments | the radio takes only tell, untell,",
            ".deliver(\"ROMA\",\"tell\",help) | wrong_arguments | a performative such as tell was expected, not",
            ".deliver(\"ROMA\",tell,3)        | bad_content     | a belief, a goal or a list of such was expected",
            ".act                              | wrong_arguments | From 1 to 2 arguments are expected",
            ".act(3)                           | wrong_arguments | an action such as stop or speed(80)",
            ".act(\"\")                        | wrong_arguments | an action such as stop or speed(80)",
            ".act(X)                           | wrong_arguments | an action such as stop or speed(80)",
            ".act(speed(X))                    | wrong_arguments | the action speed(X) has a variable without a value",
            "speed(X)                          | action_failed   | the action speed(X) has a variable without a value",
    })
    void action_wrongArgument_failsThePlanAndSaysWhatWasExpected(String action, String error, String fragment) {
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(action), new FakeBoard("desk"));
        String note = agent.nextNote();
        assertTrue(note.startsWith(error + " :"), note);
        assertTrue(note.contains(fragment), note);
    }

    private static final List<String> TERMS = List.of("3", "-0.5", "0 / 0", "\"text\"", "\"\"", "atom",
            "'quoted atom'", "'kqml'::p(1)", "p(1)", "p(Y)", "~p", "_", "Free", "[]", "[a|_]", "[[3],p(Y)]",
            "{ +!g <- x }", "{ a; b }", "{ +!g }", "{ p :- q }", "p[source(self)]", "p[a|Free]",
            "select__option(a,b,c,d)");

    private static final Set<String> ENDS =
            Set.of("done", "wrong_arguments", "bad_address", "bad_content", "receiver_not_found");

    /** If anything goes wrong, the step fails by an error that the page names, and nothing else. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0', value = {
            ".percepts|open", ".limit|1", ".filter|except|light(Z)|Z > 3", ".silence|0", ".infrastructure|lte|[com]",
            ".setMyRFId|\"SUPO\"", ".getRFMessages|open", ".diffuse|\"ROMA\"|tell|help", ".deliver|\"ROMA\"|tell|help",
            ".act|stop", ".send|\"ROMA\"|tell|help", ".send|\"ROMA\"|askOne|p(_)|_|20",
    })
    void action_anyTermAsEachArgument_failsAloneOrIsDone(ArgumentsAccessor given) {
        List<String> call = Stream.of(given.toArray()).filter(Objects::nonNull).map(Object::toString).toList();
        List<String> steps = new ArrayList<>();
        for (int place = 1; place < call.size(); place++) {
            for (String term : TERMS) {
                List<String> arguments = new ArrayList<>(call.subList(1, call.size()));
                arguments.set(place - 1, term);
                steps.add(call.get(0) + "(" + String.join(",", arguments) + ")");
            }
        }
        StringBuilder program =
                new StringBuilder("!start. +!start <- .port(desk); .setMyRFId(SUPO); diffuser.note(ready)."
                        + "+!hold <- .wait(held); diffuser.note(held).");
        for (int i = 0; i < steps.size(); i++) {
            program.append(
                    "+!do%1$d <- %2$s; diffuser.note(done). -!do%1$d[error(E)] <- diffuser.note(E).\n".formatted(i,
                            steps.get(i)));
        }
        RunningAgent agent = RunningAgent.run(program.toString(), new FakeBoard("desk").endAll(Outcome.DELIVERED));
        agent.notes("ready");
        agent.achieve("hold");
        for (int i = 0; i < steps.size(); i++) {
            agent.achieve("do" + i);
            String end = agent.nextNote();
            assertTrue(ENDS.contains(end) || end.equals("internal_action") && steps.get(i).startsWith(".send"),
                    steps.get(i) + " ends with " + end);
        }
        agent.believe("held");
        agent.notes("held");
    }

    @Test
    void infrastructure_listWithAnOpenEnd_failsThePlan() {
        String program = PROGRAM.formatted(".infrastructure(lte,[com|X])");
        RunningAgent agent = RunningAgent.run(program, new FakeBoard("desk"));
        String note = agent.nextNote();
        assertTrue(note.contains("a list of com and mob, or [], was expected, not '[com|X]'"), note);
    }

    @Test
    void action_textTooLong_failsThePlan() {
        String atom = "a".repeat(520);
        String program = PROGRAM.formatted(".act(" + atom + ")") + "+!say <- .diffuse(broadcast,tell," + atom + ")."
                + "-!say[error(E),error_msg(M)] <- diffuser.note(E,\":\",M).";
        RunningAgent agent = RunningAgent.run(program, new FakeBoard("desk"));
        agent.notes("too_long : an action has 1…510 bytes of UTF-8, not 520");
        agent.achieve("say");
        agent.notes("too_long : a content has at most 494 bytes of UTF-8, not 525");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {".act(stop)", ".diffuse(broadcast,tell,help)",
            ".deliver(\"ROMA\",tell,help)"})
    void action_noPortOpened_failsWithNoPort(String action) {
        String program = "!do. +!do <- " + action + ". -!do[error(E),error_msg(M)] <- diffuser.note(E,\":\",M).";
        RunningAgent agent = RunningAgent.run(program);
        String note = agent.nextNote();
        assertTrue(note.startsWith("no_port : agent "), note);
        assertTrue(note.contains("open one with .port"), note);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {".port(desk)", ".percepts(open)", ".limit(1)", ".setMyRFId(ROMA)",
            ".silence(1)", ".infrastructure(lte,[com])",
            ".getRFMessages(open)", ".diffuse(broadcast,tell,help)",
            ".deliver(\"ROMA\",tell,help)", ".act(stop)"})
    void action_agentHasNoDiffuser_failsAndSaysWhichArchitecture(String action) {
        String program = "!do. +!do <- " + action + ". -!do[error(E),error_msg(M)] <- diffuser.note(E,\":\",M).";
        RunningAgent agent = RunningAgent.run(program, null, List.of());
        String note = agent.nextNote();
        assertTrue(note.startsWith("no_diffuser : "), note);
        assertTrue(note.contains("diffuser.Diffuser"), note);
    }
}
