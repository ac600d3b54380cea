// Says how open it is. Its board goes and comes by itself; what becomes meanwhile of the network by which its agents
// could move is written here, one word for each change of openness: together they go through the whole figure.
network([as_it_is, up, as_it_is, down, up, as_it_is, down, as_it_is]).

!start.

+!start <-
    .port("ports/robot");
    .setMyRFId(CAFE);
    .getRFMessages(open).

@one_after_the_other[atomic]
+openness(S) : network([What|Rest]) <- .print("openness ", S); -+network(Rest); !become(What).
+openness(S)                        <- .print("openness ", S).

+!become(as_it_is).
+!become(up)   <- .infrastructure(lte, [mob]).
+!become(down) <- .infrastructure(lte, []).
