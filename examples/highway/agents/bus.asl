// The bus (ROMA) drives until an obstacle is less than 20 cm ahead; then it asks all in range for help.

!start.

+!start : true <-                                       // plan 1 of the paper
    .print("I am a Diffuser agent");
    .port("ports/bus");
    .percepts(open);
    .setMyRFId(ROMA);
    .getRFMessages(open);
    .print("Ready");
    !drive.

+!drive : not accident <- .act(drive).
+!drive.

+proximity(Distance) : Distance < 20 & not accident <-  // plan 2
    +accident;
    .print("I have suffered an accident!!!");
    .act(stop);
    .act(accidentAlert);
    .print("Asking for help!!");
    .diffuse(broadcast, tell, help).

+helpComing[cast(unicast, Police)] : accident <-        // a broadcast could be forged
    .print("Help is coming, says ", Police).

{ include("device.asl") }
