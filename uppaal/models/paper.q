// The eight properties of section 5.2.3 of the paper, in its words as far as they are legal UPPAAL.
// The paper itself gives 1 to 6 as satisfied and shows by 7 and 8 what cannot be.

/* P1 holds: the network has no deadlock. */
A[] not deadlock

/* P2 holds: when the bus has sent its broadcast, a receiver has it or waits for the next message. */
A[] Bus_Sender.Broadcast_Sent imply ( \
    Police_Receiver.Broadcast_Received || Police_Receiver.Waiting || \
    Hospital_Receiver.Broadcast_Received || Hospital_Receiver.Waiting || \
    Ambulance_Receiver.Broadcast_Received || Ambulance_Receiver.Waiting || \
    Support_Service_Receiver.Broadcast_Received || Support_Service_Receiver.Waiting)

/* P3 holds: when the support service has sent its multicast, hospital or ambulance has it or waits again. */
A[] Support_Service_Sender.Multicast_Sent imply ( \
    Hospital_Receiver.Multicast_Received || Hospital_Receiver.Waiting || \
    Ambulance_Receiver.Multicast_Received || Ambulance_Receiver.Waiting)

/* P4 holds: when the support service has encrypted its multicast, hospital or ambulance decrypts it. */
A[] Support_Service_Sender.Multicast_Encrypted imply ( \
    Hospital_Receiver.Multicast_Decrypted || Ambulance_Receiver.Multicast_Decrypted)

/* P5 holds: when the police has sent its unicast, the support service has it or waits again. */
A[] Police_Sender.Unicast_Sent imply ( \
    Support_Service_Receiver.Unicast_Received || Support_Service_Receiver.Waiting)

/* P6 holds: when the police has encrypted its unicast, the support service decrypts it. */
A[] Police_Sender.Unicast_Encrypted imply Support_Service_Receiver.Unicast_Decrypted

/* P7 fails: a unicast of the police is received by hospital or ambulance, which only hear multicasts. */
A[] Police_Sender.Unicast_Sent imply ( \
    Hospital_Receiver.Multicast_Received || Ambulance_Receiver.Multicast_Received)

/* P8 fails: a multicast of the support service is received by the police, which only hears broadcasts. */
A[] Support_Service_Sender.Multicast_Sent imply Police_Receiver.Broadcast_Received
