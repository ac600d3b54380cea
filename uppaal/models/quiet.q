// For quiet.xml, together with the properties of stronger.q.

/* Q1 holds: with a connection that stays online, the network has no deadlock either. */
A[] not deadlock

// Transmissions that were begun end. In paper.xml none of these holds, since nothing forces a sender to go on.

/* Q2 holds: a unicast for which the channel was acquired is acknowledged. */
Police_Sender.Ready --> Police_Sender.Unicast_Acknowledged

/* Q3 holds: a multicast for which the channel was acquired is acknowledged by all, and the channel given back. */
Support_Service_Sender.Ready --> Support_Service_Sender.Idle

/* Q4 holds: so is a broadcast. */
Bus_Sender.Ready --> Bus_Sender.Idle

/* Q5 fails: who waits for the channel gets it: the others may take it in turns for ever. */
Police_Sender.Connected --> Police_Sender.Ready

/* Q6 holds: a sender goes on only once the connection has been seen online. */
A[] (!Police_Sender.Idle || !Support_Service_Sender.Idle || !Bus_Sender.Idle) imply Connection.Online
