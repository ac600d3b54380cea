// The bus of the highway, which lets an inspector from the support station look at what it perceives, and none that
// the station has from elsewhere.

+!moveIn(Agent, inquilinism)[cast(unicast, From)] : .term2string(From, "SUPP") <-
    .print("Welcome, ", Agent, " from ", From).

// A broadcast is sent once, and beside so many packets it may be lost: so it asks again until help comes.
+accident <- .wait(10000); !askAgain.

+!askAgain : helpComing[cast(unicast, _)].
+!askAgain <-
    .print("Asking for help again!");
    .diffuse(broadcast, tell, help);
    .wait(10000);
    !askAgain.

{ include("bus.asl") }
