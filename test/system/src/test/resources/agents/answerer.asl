// Knows something, and how to do something, and answers who asks.
speed(80).
near(bus1, "the bus that has its engine on fire"). near(bus2, "a bus with 41 passengers, some of them hurt").

!start.

+!start <-
    .port("ports/police");
    .setMyRFId("SUPO");
    .getRFMessages(open);
    .print("listens").

@greet +!greet(Who) <- .print("good \"morning\", ", Who).

+!sing(Who) <- .print("asked to sing for ", Who); !song(Who).
