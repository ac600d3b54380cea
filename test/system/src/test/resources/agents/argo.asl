// An agent as they are written for the Argo architecture: it blinks, and looks for its board when that is gone.
serialPort("ports/lamp").

!connect.

+!connect : serialPort(Port) <-
    .argo.port(Port);
    .argo.limit(200);
    .argo.percepts(open).

+led(off) <- .print("led is off"); .argo.act(ledOn); ?led(X); .print("led is then ", X).
+led(on)  <- .print("led is on"); .argo.act(ledOff).

+port(Port, on) <- .print(Port, " is on").
+port(Port, Status) : Status = off | Status = timeout <-
    .argo.percepts(close);
    .print(Port, " is off");
    .wait(3000);
    !connect.
