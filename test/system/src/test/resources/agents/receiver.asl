// Agents for the public Difuser architecture hear messages and acknowledge them.
!start.

+!start <-
    .difuser.port("ports/police");
    .difuser.limit(250);
    .difuser.listen(open);
    .print("listens").

+message(random(I,R)) <-
    .print("message ", I);
    .difuser.transmit(ack(I)).
