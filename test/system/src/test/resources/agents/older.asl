// Asks of a board with the older protocol what it can and cannot do.
!start.

+!start <-
    .port("ports/lamp");
    .percepts(open);
    .act(ledOn).

+led(on)[source(percept)] <-
    .print("led is on");
    !attempt({ .setMyRFId("ROMA") });
    !attempt({ .getRFMessages(open) });
    !attempt({ .diffuse(broadcast, tell, help) });
    !attempt({ ledOff });
    .act(ledOff).
+led(off) : done <- .print("led is off").

+!attempt(Body) <- Body; .print("no error of ", Body).
-!attempt(Body)[error(Error), error_msg(Why)] <- +done; .print(Body, ": ", Error, ", ", Why).
