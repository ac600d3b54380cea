// The hospital (SUHO) sends an ambulance when the support station asks for it.
// It hears the police's call to the group as well, and leaves that to the support station.

!start.

+!start : true <-
    .print("I am a Diffuser agent");
    .port("ports/hospital");
    .setMyRFId(SUHO);
    .getRFMessages(open);
    .print("Ready").

+someoneNeedHelp[cast(unicast, _)] <-                   // plan 7
    .print("Asking for an ambulance!!!");
    .diffuse("SUAM", tell, someoneNeedAmbulance).

+ambulanceIsComing[cast(unicast, _)] <-                 // plan 8
    .print("Sending an Ambulance!");
    .diffuse("SUPP", tell, ambulanceIsComing).

{ include("device.asl") }
