// What all five devices have in common: they tell when their board goes and comes, and what could not be done.

+port(Port, off) <- .print("My board at ", Port, " is off").
+port(Port, on)  <- .print("My board at ", Port, " is on").

-!start[error_msg(Why)] <- .print("I could not start: ", Why).
