/* O1 holds: nothing is handed over that was not sent. */
A[] (Addressee.Handed || Addressee.Taking || Addressee.Taken) imply Air.sentOnce
/* O2 holds: what is acknowledged, the host has taken. */
A[] Air.acked imply (Addressee.Taken || Addressee.Lost)
/* O3 holds: what ends as delivered was acknowledged. */
A[] Origin.Answered imply Air.acked
/* O4 holds: a message that is given up may have been taken. */
E<> Origin.Over && !Air.acked && Addressee.Taken
