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
A[] ForgedA.HalfOpen imply (half[0] > 0 && !setting[0])
/* H5 holds: nothing is stuck before all that was begun has ended. */
A[] deadlock imply !(open[0] || open[1] || half[0] > 0 || half[1] > 0 || setting[0] || setting[1])
/* H6 holds: each handshake that was begun ends. */
RunA1.Open --> RunA1.Done || RunA1.Over
/* H7 holds: and so does that of the other host. */
RunB1.Open --> RunB1.Done || RunB1.Over
/* H8 holds: each answer ends, too. */
AnswerB1_1.HalfOpen --> AnswerB1_1.Done || AnswerB1_1.Over
/* H9 holds: and so does that of the other host. */
AnswerA1_1.HalfOpen --> AnswerA1_1.Done || AnswerA1_1.Over
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
/* H17 holds: what a host remembers of its handshakes is so: of those that it has begun. */
A[] open[0] == (RunA1.Open || RunA2.Open) && open[1] == RunB1.Open
/* H18 holds: of those that it has answered, each beside the others. */
A[] half[0] == (AnswerA1_1.HalfOpen ? 1 : 0) + (AnswerA1_2.HalfOpen ? 1 : 0) + (ForgedA.HalfOpen ? 1 : 0) && \
    half[1] == (AnswerB1_1.HalfOpen ? 1 : 0) + (AnswerB1_2.HalfOpen ? 1 : 0) + (AnswerB2_1.HalfOpen ? 1 : 0) + (AnswerB2_2.HalfOpen ? 1 : 0) + (ForgedB.HalfOpen ? 1 : 0)
/* H19 holds: of those that give its board a key. */
A[] setting[0] == (RunA1.Setting || RunA2.Setting || AnswerA1_1.Setting || AnswerA1_2.Setting) && \
    setting[1] == (RunB1.Setting || AnswerB1_1.Setting || AnswerB1_2.Setting || AnswerB2_1.Setting || AnswerB2_2.Setting)
/* H20 holds: while its board is given a key, nothing else of it is open. */
A[] (setting[0] imply !open[0] && half[0] == 0) && (setting[1] imply !open[1] && half[1] == 0)
/* H21 holds: a forged one that never ends holds back nobody: who has answered it begins all the same, and gets a key. */
E<> ForgedA.HalfOpen && ForgedB.HalfOpen && RunA1.Open
/* H22 holds: who has the higher one does. */
E<> open[1] && AnswerB1_1.HalfOpen
/* H23 holds: and what is forged may seem to be one that it is to answer. */
E<> open[1] && ForgedB.HalfOpen
/* H24 holds: each host may send two messages. */
E<> TrafficA.uses == 2 && TrafficB.uses == 2
/* H25 holds: who has begun another handshake trusts no key. */
A[] (open[0] imply session[0] == NONE) && (open[1] imply session[1] == NONE)
/* H26 holds: and may have one. */
E<> RunA2.Open && key[0] == 1
/* H27 holds: no session without a key on the board. */
A[] (key[0] == 0 imply session[0] == NONE) && (key[1] == 0 imply session[1] == NONE)
/* H28 holds: a key that was given stays, as long as no board is reset and no host is killed. */
A[] faults == 0 imply (RunA1.Done imply key[0] != 0) && (RunB1.Done imply key[1] != 0)
/* H29 holds: only what was undelivered ends trust in a key. */
A[] (key[0] != 0 && session[0] == NONE imply TrafficA.uses > 0) && (key[1] != 0 && session[1] == NONE imply TrafficB.uses > 0)
/* H30 holds: of a key that was proved, only the second time. */
A[] (key[0] >= 5 && session[0] == NONE imply TrafficA.uses == 2) && \
    (1 <= key[1] && key[1] <= 4 && session[1] == NONE imply TrafficB.uses == 2)
/* H31 holds: after it was undelivered once, it is in doubt. */
E<> key[1] == 1 && session[1] == UNPROVEN && TrafficB.uses == 1 && TrafficA.uses == 0
/* H32 holds: the key of a handshake that it has begun is proved to a host by a message alone. */
A[] (1 <= key[0] && key[0] <= 4 && session[0] == PROVEN imply TrafficA.uses + TrafficB.uses > 0) && \
    (key[1] >= 5 && session[1] == PROVEN imply TrafficA.uses + TrafficB.uses > 0)
/* H33 holds: by one that it has sent. */
E<> key[0] == 1 && session[0] == PROVEN && TrafficB.uses == 0
/* H34 holds: or by one that came. */
E<> key[0] == 1 && session[0] == PROVEN && TrafficA.uses == 0
/* H35 holds: nobody can send under a key that the other side has not. */
A[] (RunA1.Done && faults == 0 && key[1] == 0 && TrafficA.uses == 0) imply session[0] == UNPROVEN
/* H36 holds: a handshake for which there is a key of another one is over. */
A[] (key[1] == 1 && session[1] != NONE imply !RunB1.Open) && (key[0] == 5 && session[0] != NONE imply !RunA1.Open && !RunA2.Open)
/* H37 holds: no handshake is begun before the one before it has ended. */
A[] RunA1.Idle imply RunA2.Idle
/* H38 holds: no answer is given before the first one, nor to what nobody has said. */
A[] (AnswerB1_1.Idle && AnswerB2_1.Idle imply AnswerB1_2.Idle && AnswerB2_2.Idle) && (RunA2.Idle imply AnswerB2_1.Idle && AnswerB2_2.Idle) && \
    (RunB1.Idle imply AnswerA1_1.Idle && AnswerA1_2.Idle) && (RunA1.Idle imply AnswerB1_1.Idle && AnswerB1_2.Idle)
/* H39 holds: each of the two answers may be the one that gives the key, to a later run, too. */
E<> AnswerB2_2.Done && key[0] == 4 && key[1] == 4
/* H40 holds: the host with the higher address may be the one whose handshake gives the key. */
E<> RunB1.Done && AnswerA1_1.Done && key[0] == 5 && key[1] == 5 && session[0] == PROVEN
/* H41 holds: with its second answer, too. */
E<> AnswerA1_2.Done && key[0] == 6 && key[1] == 6
/* H42 holds: a host may be killed between the two, and another handshake begins. */
E<> faults == 1 && RunA1.Over && key[0] == 0 && AnswerB1_1.HalfOpen && RunA2.Open
/* H43 holds: a reset between the two loses the key alone. */
E<> faults == 1 && AnswerB1_1.Over && RunA1.Done && key[1] == 0 && open[1]
/* H44 holds: a reset loses a key that was proved. */
E<> faults == 1 && AnswerB1_1.Done && key[1] == 0 && key[0] == 1
/* H45 holds: beside a forged one, a genuine one is answered and gives the key. */
E<> ForgedB.HalfOpen && AnswerB1_1.HalfOpen && RunA1.Done
/* H46 holds: and when it has, the forged one is over. */
A[] (AnswerB1_1.Setting imply !ForgedB.HalfOpen) && (RunA1.Setting imply !ForgedA.HalfOpen)
