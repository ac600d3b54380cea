// Does with its board what it is told.
!start.
+!start <- .port("ports/robot"); .percepts(open); .setMyRFId("ROMA"); .getRFMessages(open).
+!do(Action) <- .act(Action).
