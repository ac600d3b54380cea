/* Y1 holds: a message is delivered in the end, though packets are lost and a fragment is forged. */
Police.Sending --> Police.Answered
/* Y2 holds: only a genuine whole is handed on, and what is reported delivered was handed on. */
A[] ((Support.Handed || Support.Again) imply (first != NONE && first != WRONG && rest != NONE && rest != WRONG)) && (Police.Answered imply (Support.Handed || Support.Again))
/* Y3 holds: a forged fragment that comes later shuts out no genuine one. */
E<> Support.Handed && first == WRONG_NEWER
/* Y4 holds: nor does one that comes before. */
E<> Support.Handed && rest == RIGHT_NEWER && Police.failed == 1
/* Y5 holds: of fragments that nobody forged none is refused. */
A[] Thief.sent == 0 imply (first <= RIGHT && rest <= RIGHT && Support.refusals == 0 && doubted == 0)
/* Y6 holds: of one forged fragment no other suffers. */
A[] first < WRONG || rest < WRONG
/* Y7 holds: the fragment that came last is here. */
A[] Support.Checking imply (last == FIRST ? first : rest) != NONE
/* Y8 holds: a fragment is to be sent once more only after a refusal. */
A[] (doubted != 0 && Support.Collecting) imply (Support.refusals > 0 && doubted == last && first != NONE && rest != NONE)
/* Y9 holds: that may be the first one, too. */
E<> doubted == FIRST && Support.Collecting
/* Y10 holds: refused for the fourth time, all is forgotten. */
E<> Support.refusals == MOST_REFUSALS - 1 && doubted == REST
/* Y11 holds: where nothing is lost or forged, one attempt is enough. */
A[] (losses == 0 && Thief.sent == 0) imply Police.failed == 0
/* Y12 holds: where nothing is forged, each lost packet costs one attempt, and one is lost where all was forgotten. */
A[] Thief.sent == 0 imply Police.failed <= LOST + 1
/* Y13 holds: the last fragment of an attempt asks. */
A[] Police.Awaiting imply (wants || Thief.sent > 0) && !Police.first_pending && !Police.rest_pending
/* Y14 holds: a sender that knows that the first fragment is here sends one fragment an attempt. */
A[] Police.first_there imply !(Police.first_pending && Police.rest_pending)
/* Y15 holds: nothing is stuck. */
A[] deadlock imply Police.Answered
/* Y16 holds: what has got nothing new for 5 s is forgotten, though its sender goes on. */
E<> Police.first_there && first == NONE && losses > 0 && Thief.sent == 0
/* Y17 holds: a message that was handed on is acknowledged again. */
E<> Support.Again && losses > 0 && Thief.sent == 0
/* Y18 holds: a sender sends as long as something is to be sent. */
A[] Police.Sending imply (Police.first_pending || Police.rest_pending)
/* Y19 holds: where nothing is lost or forged, the last fragment asks. */
A[] (Police.Awaiting && losses == 0 && Thief.sent == 0) imply Police.asked == REST
/* Y20 holds: nothing is kept of what is forgotten. */
A[] Support.Forgotten imply (first == NONE && rest == NONE && doubted == 0 && Support.refusals == 0)
/* Y21 holds: only a whole that cannot be genuine is refused. */
A[] Support.Refused imply (first != NONE && rest != NONE && (first == WRONG || rest == WRONG) && first <= WRONG && Thief.sent > 0)
/* Y22 holds: the first fragment may be lost. */
E<> losses == LOST && first == NONE && Thief.sent == 0 && Police.failed == 1
/* Y23 holds: so may the last one. */
E<> losses == LOST && rest == NONE && first == RIGHT && Police.failed == 1 && !Police.first_there
/* Y24 holds: so may the acknowledgement. */
E<> losses == LOST && Support.Handed && Police.Awaiting && Police.failed == 1 && Thief.sent == 0
/* Y25 holds: so may an answer. */
E<> losses == LOST && Police.failed == 1 && first == RIGHT && rest == NONE && Police.asked == FIRST && Police.Awaiting && !Police.first_there && Support.Collecting
/* Y26 holds: the last fragment is asked for once more, and then the first one. */
E<> Police.first_there && Police.first_pending && Police.Sending
/* Y27 holds: the fragment that has asked is sent again. */
E<> Police.first_there && Police.rest_pending && Police.failed > 0 && Thief.sent == 0
/* Y28 holds: so many attempts may fail. */
E<> Thief.sent == 0 && Police.failed == LOST + 1
/* Y29 holds: one forged fragment may cost all attempts but the last. */
E<> Thief.sent == 1 && Police.failed == MAX_ATTEMPTS - 1 && Police.Sending
/* Y30 holds: a message of which a board keeps something is handed on, or forgotten. */
Support.Collecting && first != NONE --> Support.Handed || Support.Forgotten
/* Y31 holds: a board that acknowledges a message again goes on. */
Support.Again --> Support.Handed
/* Y32 holds: a fragment that another follows asks for nothing. */
A[] (Support.Answering && Police.Sending && Thief.sent == 0) imply !wants
/* Y33 holds: what is refused for the first three times is kept, and a fragment of it is to be sent once more. */
Support.Refused && Support.refusals < MOST_REFUSALS - 1 --> doubted != 0
/* Y34 holds: a sender knows whether attempts in a row have failed an odd number of times. */
A[] Police.odd == (Police.failed - 2 * (Police.failed / 2))
/* Y35 holds: no fragment is genuine that was not sent. */
A[] (Police.failed == 0 && !Police.first_there) imply ((Police.first_pending imply (first == NONE || first == WRONG)) && (Police.rest_pending imply (rest == NONE || rest == WRONG)))
/* Y36 holds: a forged fragment that comes later shuts out no genuine last one, either. */
E<> Support.Handed && rest == WRONG_NEWER
/* Y37 holds: nothing is lost before it was sent. */
A[] (Police.first_pending && Police.rest_pending && Police.failed == 0 && Thief.sent == 0) imply losses == 0
/* Y38 holds: the first fragment may be lost twice. */
E<> losses == LOST && first == NONE && rest == RIGHT && Police.asked == FIRST && Police.failed == 1 && Police.Awaiting && Thief.sent == 0
/* Y39 holds: so may the last one. */
E<> losses == LOST && rest == NONE && first == RIGHT && Police.asked == REST && Police.failed == 0 && Police.first_there && Police.Awaiting && Thief.sent == 0
/* Y40 holds: of a whole that was checked and is not handed on, a fragment is to be sent once more. */
A[] (Support.Answering && first != NONE && rest != NONE) imply doubted == last
