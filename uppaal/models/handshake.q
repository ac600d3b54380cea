/* H1 holds: at no moment do both hosts hold a key for proved that is not the same. */
A[] (session[0] == PROVEN && session[1] == PROVEN) imply (key[0] == key[1] || key[0] == 0 || key[1] == 0)
/* H2 holds: whoever began has a key only of a handshake whose message 2 it has verified, which the other side has said. */
A[] (key[0] == 1 imply (RunA1.Done && !AnswerB1_1.Idle)) && \
    (key[0] == 2 imply (RunA1.Done && !AnswerB1_2.Idle)) && \
    (key[0] == 3 imply (RunA2.Done && !AnswerB2_1.Idle)) && \
    (key[0] == 4 imply (RunA2.Done && !AnswerB2_2.Idle)) && \
    (key[1] == 5 imply (RunB1.Done && !AnswerA1_1.Idle)) && \
    (key[1] == 6 imply (RunB1.Done && !AnswerA1_2.Idle))
/* H3 holds: whoever answered has a key only of a handshake whose message 3 it has verified, after the other side has set the key. */
A[] (key[1] == 1 imply (AnswerB1_1.Done && RunA1.Done)) && \
    (key[1] == 2 imply (AnswerB1_2.Done && RunA1.Done)) && \
    (key[1] == 3 imply (AnswerB2_1.Done && RunA2.Done)) && \
    (key[1] == 4 imply (AnswerB2_2.Done && RunA2.Done)) && \
    (key[0] == 5 imply (AnswerA1_1.Done && RunB1.Done)) && \
    (key[0] == 6 imply (AnswerA1_2.Done && RunB1.Done))
/* H4 holds: what the attacker forges gives nobody a key. */
A[] ForgedA.HalfOpen imply (half[0] && !setting[0])
/* H5 holds: nothing is stuck before all that was begun has ended. */
A[] deadlock imply !(open[0] || open[1] || half[0] || half[1] || setting[0] || setting[1])
/* H6 holds: each handshake that was begun ends. */
RunA1.Open --> RunA1.Done || RunA1.Over
/* H7 holds: and so does that of the other host. */
RunB1.Open --> RunB1.Done || RunB1.Over
/* H8 holds: each answer ends, too. */
AnswerB1_1.HalfOpen --> AnswerB1_1.Done || AnswerB1_1.Over
/* H9 holds: also if it takes the place of a forged one. */
half[1] --> !half[1]
/* H10 holds: who has a proved key, and the other another one or none, may come to another handshake. */
E<> session[0] == PROVEN && key[1] != key[0] && session[1] == UNPROVEN
/* H11 holds: both may begin at once, and then the run of the lower address gives the key. */
E<> RunA1.Done && AnswerB1_1.Done && RunB1.Over && session[0] == PROVEN && session[1] == PROVEN && key[0] == 1 && key[1] == 1
/* H12 holds: both may be open at once. */
E<> open[0] && open[1]
/* H13 holds: a board may lose the key, and a second handshake gives another. */
E<> key[0] == key[1] && key[0] >= 3 && session[0] == PROVEN && session[1] == PROVEN && faults == 1
/* H14 holds: a message 3 may be lost: the key of one side is of no use, and is not proved. */
E<> session[0] == UNPROVEN && key[1] == 0 && AnswerB1_1.Over
/* H15 holds: two handshakes that cross, of which one comes late, may leave two keys; neither is proved. */
E<> key[0] != 0 && key[1] != 0 && key[0] != key[1] && session[0] == UNPROVEN && session[1] == UNPROVEN
/* H16 holds: a second answer to the same run may give the key. */
E<> AnswerB1_2.Done && key[0] == 2 && key[1] == 2
