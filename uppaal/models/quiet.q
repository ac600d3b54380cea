// For quiet.xml, together with the properties of stronger.q.

/* Q1 holds: with a connection that stays online, the network has no deadlock either. */
A[] not deadlock

/* Q2 holds: a sender goes on only once the connection has been seen online. */
A[] (!Police_Sender.Idle || !Support_Service_Sender.Idle || !Bus_Sender.Idle) imply Connection.Online
