// The police car (SUPO) hears of the accident and calls its group; later it tells the vehicles that asked for help that it is coming.

!start.

+!start : true <-
    .print("I am a Diffuser agent");
    .port("ports/police");
    .setMyRFId(SUPO);
    .getRFMessages(open);
    .print("Ready").

+help[source(Vehicle)] <-                               // plan 3
    .print("I got an accident message from ", Vehicle, ". Requesting support!");
    .diffuse("//SU", tell, someoneNeedHelp).

+helpComing[cast(unicast, _)] : help[source(Vehicle)] <- // plan 4
    .print("The help is coming!");
    .diffuse(Vehicle, tell, helpComing).

{ include("device.asl") }
