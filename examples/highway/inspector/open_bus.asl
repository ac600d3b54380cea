// The bus of the highway, which lets an inspector from the support station look at what it perceives.

+!moveIn(Agent, inquilinism)[cast(unicast, From)] : .term2string(From, "SUPP") <-
    .print("Welcome, ", Agent, " from ", From).

{ include("bus.asl") }
