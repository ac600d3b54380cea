package diffuser;

import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import javino.fake.FakeBoard;

/** Filters as agents for the public Argo architecture set them. */
class FilterTest {

    /** Notes what it believes of its sensors as soon as they were read. */
    private static final String PROGRAM = """
            !start.
            +!start <- .argo.port(ttyUSB0); %s; .argo.percepts(open); !note.
            +!note <- .findall(S,ledStatus(S),L); .findall(N,resourceName(N),R); .findall(X,distance(X),D);
                .findall(P,dark & P = yes,K); .findall(S,port(_,S),O); diffuser.note(L,R,D,K,O).
            """;

    private static FakeBoard board() {
        return new FakeBoard("ttyUSB0").perceive("ledStatus(off)", "resourceName(myArduino)", "distance(17)",
                "distance(250)", "dark");
    }

    private static RunningAgent argo(String program, FakeBoard board) {
        return RunningAgent.run(program, null, List.of(ScriptedArgo.class.getName()), board);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '#', value = {
            ".argo.filter(except, ledStatus(X))                              # [off] [] [] [] [on]",
            ".argo.filter(except, ledStatus(__))                             # [off] [] [] [] [on]",
            ".argo.filter(except, ledStatus(X), X = off)                     # [off] [] [] [] [on]",
            ".argo.filter(except, ledStatus(X), X = on)                      # [] [] [] [] [on]",
            ".argo.filter(except, [ledStatus(off), ledStatus(on), dark])     # [off] [] [] [yes] [on]",
            ".argo.filter(only, ledStatus(X))                                # [] [myArduino] [17,250] [yes] [on]",
            ".argo.filter(only, ledStatus(X), X = on)                        # [off] [myArduino] [17,250] [yes] [on]",
            ".argo.filter(only, [ledStatus(off), ledStatus(on)])             # [] [myArduino] [17,250] [yes] [on]",
            ".argo.filter(only, distance(X), X > 200 | not X < 200)          # [off] [myArduino] [17] [yes] [on]",
            ".filter(value, distance(X), X > 10 & X < 200)                   # [off] [myArduino] [250] [yes] [on]",
            ".argo.filter(only, ledStatus(X), X + 1 > 2)                     # [off] [myArduino] [17,250] [yes] [on]",
            "argo.filter(only, distance(X), X + 1 > a)                       # [off] [myArduino] [17,250] [yes] [on]",
            ".filter(except, distance(_)); .filter(only, distance(17))       # [] [] [250] [] [on]",
            ".filter(except, dark); .filter(only, dark)                      # [] [] [] [] [on]",
            ".filter(except, dark); .filter(only, dark); .filter(remove)     # [off] [myArduino] [17,250] [yes] [on]",
            ".filter(except, dark); .filter(only, dark); .filter(remove,all) # [off] [myArduino] [17,250] [yes] [on]",
            ".filter(except, dark); .filter(only, dark); .filter(remove,only)   # [] [] [] [yes] [on]",
            ".filter(except, dark); .filter(only, dark); .filter(remove,except) # [off] [myArduino] [17,250] [] [on]",
    })
    void filter_setBeforeThePerceptsAreOpened_leavesTheOthersOut(String filter, String expected) {
        RunningAgent agent = argo(PROGRAM.formatted(filter), board());
        agent.notes(expected);
    }

    @Test
    void filter_setAndRemovedLater_beliefsFollow() {
        String program = """
                !start.
                +!start <- .filter(except,distance(_)); .port(ttyUSB0); .percepts(open); .limit(3600000).
                +!light <- .filter(only,distance(X),X < 100).
                +!all <- .filter(remove).
                +distance(X) <- diffuser.note(distance,X).
                -distance(X) <- diffuser.note(no,distance,X).
                +dark <- diffuser.note(dark).
                +ledStatus(X) <- diffuser.note(led,X).
                """;
        RunningAgent agent = argo(program, board());
        agent.notesAll("distance 17", "distance 250");
        agent.achieve("light");
        agent.notes("no distance 17");
        agent.achieve("all");
        agent.notesAll("distance 17", "dark", "led off");
    }

    @ParameterizedTest
    @ValueSource(strings = {".filter(\"compass.xml\")", ".change_filter(\"compass.xml\")", ".change_filter(compass)"})
    void filter_fromAFile_failsAndSaysWhatToWrite(String filter) {
        String program = "!start. +!start <- " + filter
                + ". -!start[error(E),error_msg(M)] <- diffuser.note(E); .print(M);"
                + ".substring(\"filters are not read from files: write .filter(except, light(_))\",M); "
                + "diffuser.note(told).";
        RunningAgent agent = argo(program, board());
        agent.notes("wrong_arguments");
        agent.notes("told");
    }
}
