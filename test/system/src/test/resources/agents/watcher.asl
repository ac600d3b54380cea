// Says what it sees of its board, and asks it something whenever it comes.
!start.

+!start : true <-
    .port("ports/robot");
    .percepts(open);
    .setMyRFId(CAFE);
    .getRFMessages(open);
    .print("ready").

+port(_, off) <- .print("port off").
+port(_, on)  <- .print("port on"); !ask.

+!ask <- .act(headlightsOn); .print("answered").
-!ask[error_msg(Why)] <- .print("unanswered: ", Why).

+light(L) <- .print("light ", L).
+hello(X)[source(S)] <- .print("message ", X, " from ", S).
