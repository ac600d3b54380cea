// Has a board (ROMA), and a colleague in its MAS who has another (SUPO): they talk by radio and without.
!start.

+!start <-
    .port("ports/scout");
    .percepts(open);
    .setMyRFId(ROMA);
    .getRFMessages(open);
    .send(base, achieve, listen).

+light(L) <- .print("light ", L).

+!report[source(base)] <-
    .deliver("SUPO", tell, dark);
    .print("delivered").

+understood[source(base)]    <- .print("understood, says base").
+thanks[cast(unicast, From)] <- .print("thanks by radio from ", From); .act(headlightsOn).
+port(_, State)              <- .print("port ", State).
