// The ambulance (SUAM) drives off with its siren on, and tells the sender of the call.

!start.

+!start : true <-
    .print("I am a Diffuser agent");
    .port("ports/ambulance");
    .setMyRFId(SUAM);
    .getRFMessages(open);
    .print("Ready").

+someoneNeedAmbulance[cast(unicast, Hospital)] <-       // plan 9
    .print("I am going!!!");
    .act(sirenOn);
    .act(drive);
    .diffuse(Hospital, tell, ambulanceIsComing).

{ include("device.asl") }
