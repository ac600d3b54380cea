// Properties that the eight of the paper leave open. All of these hold for paper.xml and for quiet.xml.

// Exactly the addressees receive.

/* S1 holds: a unicast that was just sent is received by its addressee, and by nobody else. */
A[] Police_Sender.Unicast_Sent imply ( \
    Support_Service_Receiver.Unicast_Received && Police_Receiver.Waiting && \
    Hospital_Receiver.Waiting && Ambulance_Receiver.Waiting)

/* S2 holds: a multicast that was just sent is received by the whole group, and by nobody else. */
A[] (Support_Service_Sender.Multicast_Sent && Support_Service_Sender.acks == 0) imply ( \
    Hospital_Receiver.Multicast_Received && Ambulance_Receiver.Multicast_Received && \
    Police_Receiver.Waiting && Support_Service_Receiver.Waiting)

/* S3 holds: a broadcast that was just sent is received by all. */
A[] (Bus_Sender.Broadcast_Sent && Bus_Sender.acks == 0) imply ( \
    Police_Receiver.Broadcast_Received && Support_Service_Receiver.Broadcast_Received && \
    Hospital_Receiver.Broadcast_Received && Ambulance_Receiver.Broadcast_Received)

// Nobody decrypts what is not theirs.

/* S4 holds: what the receiver of unicasts decrypts is a unicast that was encrypted for it. */
A[] Support_Service_Receiver.Unicast_Decrypted imply Police_Sender.Unicast_Encrypted

/* S5 holds: what the receivers of multicasts decrypt is a multicast that was encrypted for them. */
A[] (Hospital_Receiver.Multicast_Decrypted || Ambulance_Receiver.Multicast_Decrypted) imply \
    Support_Service_Sender.Multicast_Encrypted

// Every message that is received was sent, and its sender waits for the acknowledgement.

/* S6 holds: a unicast that is received was sent. */
A[] Support_Service_Receiver.Unicast_Received imply Police_Sender.Unicast_Sent

/* S7 holds: a multicast that is received was sent. */
A[] (Hospital_Receiver.Multicast_Received || Ambulance_Receiver.Multicast_Received) imply \
    Support_Service_Sender.Multicast_Sent

/* S8 holds: a broadcast that is received was sent. */
A[] (Police_Receiver.Broadcast_Received || Support_Service_Receiver.Broadcast_Received || \
    Hospital_Receiver.Broadcast_Received || Ambulance_Receiver.Broadcast_Received) imply \
    Bus_Sender.Broadcast_Sent

// One message at a time.

/* S9 holds: while the channel is released, no sender has begun to encrypt or to send. */
A[] Channel.Released imply ( \
    (Police_Sender.Idle || Police_Sender.Connected) && \
    (Support_Service_Sender.Idle || Support_Service_Sender.Connected) && \
    (Bus_Sender.Idle || Bus_Sender.Connected))

/* S10 holds: of any two senders, one has not begun. */
A[] ((Police_Sender.Idle || Police_Sender.Connected || \
      Support_Service_Sender.Idle || Support_Service_Sender.Connected) && \
     (Police_Sender.Idle || Police_Sender.Connected || Bus_Sender.Idle || Bus_Sender.Connected) && \
     (Support_Service_Sender.Idle || Support_Service_Sender.Connected || Bus_Sender.Idle || Bus_Sender.Connected))

/* S16 holds: the channel is taken only as long as a sender has something to send. */
A[] Channel.Not_Released imply ( \
    !(Police_Sender.Idle || Police_Sender.Connected) || \
    !(Support_Service_Sender.Idle || Support_Service_Sender.Connected) || \
    !(Bus_Sender.Idle || Bus_Sender.Connected))

// Each kind of message can go its whole way.

/* S11 holds: a unicast can be acknowledged after it was decrypted. */
E<> Police_Sender.Unicast_Acknowledged

/* S12 holds: a multicast can be acknowledged by both receivers. */
E<> Support_Service_Sender.Multicast_Sent && Support_Service_Sender.acks == 2

/* S13 holds: a broadcast can be acknowledged by all four receivers. */
E<> Bus_Sender.Broadcast_Sent && Bus_Sender.acks == 4

/* S14 holds: the addressee of a unicast can decrypt it. */
E<> Support_Service_Receiver.Unicast_Decrypted

/* S15 holds: both receivers of a multicast can decrypt it. */
E<> Hospital_Receiver.Multicast_Decrypted && Ambulance_Receiver.Multicast_Decrypted
