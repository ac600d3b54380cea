// Says how open it is; whoever is silent for two seconds is out of reach.
!start.

+!start <-
    .port("ports/robot");
    .setMyRFId(CAFE);
    .getRFMessages(open);
    .silence(2000).

+openness(S) <- .print("openness ", S).
