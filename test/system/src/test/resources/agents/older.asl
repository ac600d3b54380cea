// Asks of a board with the older protocol what it can and cannot do.
!start.

+!start <-
    .port("ports/lamp");
    .percepts(open);
    !until(ledOn, led(on)).

+led(on)[source(percept)] <-
    .print("led is on");
    !attempt({ .setMyRFId("ROMA") });
    !attempt({ .getRFMessages(open) });
    !attempt({ .diffuse(broadcast, tell, help) });
    !attempt({ .act(ledOff, _) });
    !attempt({ ledOff });
    !until(ledOff, led(off)).
+led(off) : done <- .print("led is off").

// The older protocol acknowledges no action, and a busy machine may lose one.
+!until(_, Percept) : Percept.
+!until(Action, Percept) <- .act(Action); .wait(2000); !until(Action, Percept).

+!attempt(Body) <- Body; .print("no error of ", Body).
-!attempt(Body)[error(Error), error_msg(Why)] <- +done; .print(Body, ": ", Error, ", ", Why).
