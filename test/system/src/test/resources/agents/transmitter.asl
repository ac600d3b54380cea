// Agents for the public Difuser architecture transmit messages, each when the one before was acknowledged.
iteration(2).

!start.

+!start <-
    .difuser.port("ports/bus");
    .difuser.listen(open);
    .difuser.limit(250);
    !transmit.

+!transmit : iteration(I) & I > 0 <-
    .random(R);
    .difuser.transmit(random(I,R)).
-!transmit <- .print("end of transmission").

+message(ack(I)) <-
    -+iteration(I-1);
    .print("ack ", I);
    !transmit.
