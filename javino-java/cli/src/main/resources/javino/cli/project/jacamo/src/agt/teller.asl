// Reads the diary, and prints the night when the robot has written dusk and dawn into it. It needs no board.

+entry(Number, Text) <- .print("the diary says ", Number, ": ", Text).

// A goal of the organisation (src/org/house.xml).
+!night_told <- .count(entry(_, _), Entries); .print("the night has ", Entries, " entries").

{ include("$jacamo/templates/common-cartago.asl") }
{ include("$jacamo/templates/common-moise.asl") }
{ include("$moise/asl/org-obedient.asl") }
