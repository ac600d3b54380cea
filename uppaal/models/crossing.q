/* C1 holds: each host gets the other's message at most once. */
A[] Support.given1 <= 1 && Listener.given1 <= 1
/* C2 holds: what is reported delivered, the host has got. */
A[] (Police.told1 imply Support.given1 == 1) && (Answer.told1 imply Listener.given1 == 1)
/* C3 holds: nothing is stuck before both messages have ended. */
A[] deadlock imply (Police.Idle && Answer.Idle && active == 0)
/* C4 holds: frames may collide. */
E<> collided
/* C5 holds: both messages can be delivered. */
E<> Police.told1 && Answer.told1
