// The inspector lives at the support station (SUPP). It travels to the bus by radio, looks there, and comes back.

+!inspect(Bus) <-
    .print("I travel to ", Bus);
    .moveOut(Bus, inquilinism);                         // what follows happens on the bus
    .send(bus, askOne, proximity(_), proximity(Distance));
    .send(bus, askOne, light(_), light(Brightness));
    .print("On ", Bus, " I see an obstacle at ", Distance, " cm, and light ", Brightness);
    .moveOut("SUPP", mutualism);                        // and what follows, at home
    .print("I am back from ", Bus, ": obstacle at ", Distance, " cm, light ", Brightness).

-!inspect(Bus)[error(E), error_msg(Why)] <-
    .print("I could not travel (", E, "): ", Why);
    .wait(5000);
    !inspect(Bus).
