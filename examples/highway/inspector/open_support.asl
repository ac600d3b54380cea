// The support station of the highway, which sends its inspector out, and lets it come home.

+openness(open)[source(percept)] : not sent <-          // by its radio agents can move
    +sent;
    .send(inspector, achieve, inspect("ROMA")).

// Its own inspector: no other agent of that name can be at home here.
+!moveIn(inspector, mutualism)[cast(unicast, From), home(Home)] : .term2string(Home, "SUPP") <-
    .print("The inspector comes home from ", From).

+movedOut(Agent, To)[source(percept)] <- .print(Agent, " has gone to ", To).

{ include("support.asl") }
