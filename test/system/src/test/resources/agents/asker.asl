// Asks another device what it knows and how it does it, teaches it something, and asks one that is not there.
!start.

+!start <-
    .port("ports/bus");
    .setMyRFId("ROMA");
    .getRFMessages(open);
    .send("SUPO", askOne, speed(_), speed(V));
    .print("speed is ", V);
    .send("SUPO", askOne, colour(_), Colour);
    .print("colour is ", Colour);
    .send("SUPO", askAll, near(_, _), Near, 60000);
    .length(Near, Count);
    .print("near are ", Count);
    .send("SUPO", askHow, { +!greet(_) }, Plans);
    .add_plan(Plans, supo);
    !greet(asker);
    .deliver("SUPO", tellHow, { @song +!song(Who) <- .print("la la \"la\", ", Who) });
    .deliver("SUPO", achieve, sing(asker));
    !ask("SUHO");
    .diffuse("//SU", askOne, speed(_)).

+!ask(Who) <- .send(Who, askOne, speed(_), _).
-!ask(Who)[error(E)] <- .print(Who, " does not answer: ", E).

+speed(V)[source(S), cast(multicast, S)] <- .print("in the group ", S, " drives ", V).
