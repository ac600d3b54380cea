// The support station of the highway, which sends its inspector out, and lets it come home.

+openness(open)[source(percept)] : not sent <-          // by its radio agents can move
    +sent;
    .send(inspector, achieve, inspect("ROMA")).

+!moveIn(inspector, mutualism)[cast(unicast, From)] <- .print("The inspector comes home from ", From).

+movedOut(Agent, To)[source(percept)] <- .print(Agent, " has gone to ", To).

{ include("support.asl") }
