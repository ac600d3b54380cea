// Plans that all five devices share: they print when their board is lost or found, and which goals failed.

+port(Port, off) <- .print("My board at ", Port, " is off").
+port(Port, on)  <- .print("My board at ", Port, " is on").

-!start[error_msg(Why)] <- .print("I could not start: ", Why).
