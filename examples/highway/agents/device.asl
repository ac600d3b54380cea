// Plans that all five devices share: they print when their board is lost or found,
// and start again if it is lost before they are ready.

+port(Port, off) <- .print("My board at ", Port, " is off").
+port(Port, on)  <- .print("My board at ", Port, " is on").

-!start[error_msg(Why)] <- .print("I start again: ", Why); .wait(1000); !start.
