// Goes through the four kinds of openness of the paper's table 1, all that by its board's radio but the last.
!start.

+!start <- .port("ports/robot"); .setMyRFId(CAFE).

// Lets agents of ROMA move in, once agents may.
+!admit <- .add_plan({ +!moveIn(_, mutualism)[cast(unicast, From)] : .term2string(From, "ROMA") }).

+openness(S)[source(percept)] <- .print("openness ", S); !then(S).

+!then(totallyClosed) : not been <- +been; .getRFMessages(open).
+!then(closed)        : not admitted <- +admitted; !admit.
+!then(open)          <- .getRFMessages(block).
+!then(totallyClosed) <- .infrastructure(ferry, [mob]).  // carries agents to and fro, and no messages
+!then(_).
