// The highway support station (SUPP) stands between the police and the hospital.

!start.

+!start : true <-
    .print("I am a Diffuser agent");
    .port("ports/support");
    .setMyRFId(SUPP);
    .getRFMessages(open);
    .print("Ready").

+someoneNeedHelp[cast(multicast, _)] <-                 // plan 5
    .print("I got a help message in the public safety group. Forwarding to the Hospital!");
    .diffuse("SUHO", tell, someoneNeedHelp).

+ambulanceIsComing[cast(unicast, _)] <-                 // plan 6
    .print("I understood! The Ambulance is coming!");
    .diffuse("SUPO", tell, helpComing).

{ include("device.asl") }
