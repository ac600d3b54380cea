/* O1 holds: a host gets each broadcast at most once, if others use the air for 88 ms before a repeat at most. */
A[] given1 <= 1 && given2 <= 1
/* O2 holds: what is taken for a repeat has the content of the last one. */
A[] Support.Repeat imply (copy == SENDS || content == before)
/* O3 holds: a repeat that comes alone is handed on. */
E<> Support.New && copy == 2
/* O4 holds: and one that comes after the first is not. */
E<> Support.Repeat && copy == 2 && message == 2 && content != before
/* O5 holds: two broadcasts with the same content are both handed on, where the second begins later. */
E<> given1 == 1 && given2 == 1 && content == before && copy == 1
/* O6 holds: where it begins sooner it is taken for a repeat. */
E<> Support.Repeat && copy == 1
/* O7 holds: no broadcast with another content is. */
A[] (Support.Repeat && copy == 1) imply (message == 2 && content == before)
/* O8 holds: nothing is stuck. */
A[] deadlock imply message == 2
/* O9 holds: each packet is heard from its begin to its end. */
A[] Bus.OnAir == Support.Hearing
/* O10 holds: a broadcast is sent as often as it is to be. */
A[] Bus.Idle imply (copy == SENDS || message == 0)
/* O11 holds: one with another content is handed on, however soon. */
E<> given1 == 1 && given2 == 1 && content != before && Support.soon
/* O12 holds: both contents can come first. */
E<> message == 1 && content == 2 && Support.Repeat
/* O14 holds: a repeat is known of the one content as of the other. */
E<> message == 1 && content == 1 && Support.Repeat
/* O15 holds: the one content after the other is new, however soon. */
E<> Support.New && Support.soon && given1 == 1 && given2 == 0 && before == 1 && content == 2
/* O16 holds: and the other after the one. */
E<> Support.New && Support.soon && given1 == 1 && given2 == 0 && before == 2 && content == 1
/* O17 holds: only what begins soon is taken for a repeat. */
A[] Support.Repeat imply Support.soon
/* O18 holds: what begins more than 400 ms after the last broadcast's end has not begun soon. */
A[] Pause.Long imply !Support.soon
/* O19 holds: what begins just 400 ms after it may have. */
E<> Pause.Just && Support.soon
