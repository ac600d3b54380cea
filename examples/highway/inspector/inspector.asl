// The inspector lives at the support station (SUPP). It travels to the bus by radio, looks there, and comes back.

+!inspect(Bus) <-
    .print("I travel to ", Bus);
    !travel(Bus, inquilinism);                          // what follows happens on the bus
    !look(Distance, Brightness);
    .print("On ", Bus, " I see an obstacle at ", Distance, " cm, and light ", Brightness);
    !travel("SUPP", mutualism);                         // and what follows, at home
    .print("I am back from ", Bus, ": obstacle at ", Distance, " cm, light ", Brightness).

+!travel(To, Protocol) <- .moveOut(To, Protocol).

-!travel(To, Protocol)[error(E), error_msg(Why)] <-
    .print("I could not travel (", E, "): ", Why);
    .wait(5000);
    !travel(To, Protocol).

+!look(Distance, Brightness) <-
    .send(bus, askOne, proximity(_), proximity(Distance));
    .send(bus, askOne, light(_), light(Brightness)).

-!look(Distance, Brightness) <-                         // the bus has not sensed yet
    .wait(1000);
    !look(Distance, Brightness).
