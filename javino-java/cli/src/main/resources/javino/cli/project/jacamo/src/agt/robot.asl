// Flashes its lamp at the start, and lights it when it gets dark; writes dusk and dawn into the diary, as its role asks.

!start.

+!start <-
    .port("ports/robot");       // of the emulated board; for a real one such as "/dev/ttyACM0"
@openArm@    .percepts(open);
    !greet.

+!greet <- .act(lampOn); .wait(500); .act(lampOff).

+light(L) : L < 300 & not dark <- +dark; .print("it is dark: ", L); .act(lampOn)@closeArm@.
+light(L) : L > 600 & dark     <- -dark; .print("it is bright again: ", L); .act(lampOff)@releaseArm@.

// Goals of the organisation (src/org/house.xml); write is an operation of the artifact diary (src/env/house/Diary.java).
+!dusk_written <- .wait(dark); write("dusk").
+!dawn_written <- .wait(not dark); write("dawn").

+lamp(State) <- .print("my lamp is ", State).@seeArm@

+port(Port, State)      <- .print("my board at ", Port, " is ", State).
-!start[error_msg(Why)] <- .print("I could not start: ", Why).

{ include("$jacamo/templates/common-cartago.asl") }
{ include("$jacamo/templates/common-moise.asl") }
{ include("$moise/asl/org-obedient.asl") }
