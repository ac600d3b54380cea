// As agents for the public Difuser architecture use a sketch that sends and receives by itself.
!start.

+!start <-
    .difuser.port("ports/lamp");
    .difuser.listen(open);
    .difuser.transmit(random(1,0.5)).

+last(message(random(I,R))) <- .print("the sketch was given ", I, " ", R); .act(ledOn).
