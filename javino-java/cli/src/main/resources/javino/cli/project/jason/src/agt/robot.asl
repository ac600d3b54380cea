// Flashes its lamp at the start, and lights it when it gets dark.

!start.

+!start <-
    .port("ports/robot");       // of the emulated board; for a real one such as "/dev/ttyACM0"
@openArm@    .percepts(open);
    !greet.

+!greet <- .act(lampOn); .wait(500); .act(lampOff).

+light(L) : L < 300 & not dark <- +dark; .print("it is dark: ", L); .act(lampOn)@closeArm@.
+light(L) : L > 600 & dark     <- -dark; .print("it is bright again: ", L); .act(lampOff)@releaseArm@.

+lamp(State) <- .print("my lamp is ", State).@seeArm@

+port(Port, State)      <- .print("my board at ", Port, " is ", State).
-!start[error_msg(Why)] <- .print("I could not start: ", Why).
