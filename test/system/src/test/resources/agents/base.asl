// Listens when scout asks for it; answers what it hears by radio, and without.
!start.

+!start <- .port("ports/base").

+!listen[source(Who)] <-
    .wait(port(_, on));
    .percepts(open);
    .setMyRFId(SUPO);
    .getRFMessages(open);
    .send(Who, achieve, report).

+light(L) <- .print("light ", L).

+dark[cast(unicast, From)] <-
    .print("dark by radio from ", From);
    .send(scout, tell, understood);
    .deliver(From, tell, thanks);
    .act(headlightsOn).

+port(_, State) <- .print("port ", State).
