// Agents for the public Difuser architecture use a sketch that sends and receives by itself. The older protocol
// acknowledges no action: what a busy machine has lost is said again.
!start.

+!start <-
    .difuser.port("ports/lamp");
    .difuser.listen(open);
    !transmit.

+!transmit : last(message(_)).
+!transmit <- .difuser.transmit(random(1,0.5)); .wait(1000); !transmit.

+last(message(random(I,R))) <- .print("the sketch was given ", I, " ", R); !light.

+!light : led(on).
+!light <- .act(ledOn); .wait(1000); !light.
