package uppaal.report;

import static uppaal.report.Fault.added;
import static uppaal.report.Fault.both;
import static uppaal.report.Fault.edge;
import static uppaal.report.Fault.removed;

import java.util.List;

/** The mistakes that we make in the paper's network on purpose. */
final class Faults {
    static final List<Fault> ALL = List.of(
            new Fault("wrong guard", "the bus stops waiting after three of four acknowledgements",
                    edge("Sender_Broadcast", "Broadcast_Sent -> Idle",
                            edge -> edge.withGuard("acks == receivers - 1"))),
            new Fault("no acknowledgement", "the police receives the broadcast and never acknowledges it",
                    edge("Receiver_Broadcast", "Broadcast_Received -> Waiting", edge -> edge.withSynchronisation(""))),
            new Fault("double acknowledgement", "hospital and ambulance may acknowledge one multicast twice",
                    added("Receiver_Multicast", "Multicast_Received", "Multicast_Received", "multicast_received!")),
            new Fault("impatience", "the police does not wait for the acknowledgement of its unicast",
                    edge("Sender_Unicast", "Unicast_Sent -> Unicast_Acknowledged",
                            edge -> edge.withSynchronisation(""))),
            new Fault("binary channels", "a message to many reaches one of them",
                    document -> document.withDeclarations(document.declarations().replace("broadcast chan", "chan"))),
            new Fault("eavesdropper", "the support service's receiver decrypts multicasts of others",
                    added("Receiver_Unicast", "Waiting", "Unicast_Decrypted", "encryptMulticast?")),
            new Fault("thief", "hospital and ambulance take unicasts for the support service, and acknowledge them",
                    both(added("Receiver_Multicast", "Multicast_Decrypted", "Multicast_Received", "sendUnicast?"),
                            both(added("Receiver_Multicast", "Waiting", "Multicast_Decrypted", "encryptUnicast?"),
                                    added("Receiver_Multicast", "Multicast_Received", "Waiting",
                                            "unicast_received!")))),
            new Fault("forgery", "the police's receiver takes broadcasts that nobody sent",
                    added("Receiver_Broadcast", "Waiting", "Broadcast_Received", "")),
            new Fault("plain unicast", "the police sends its unicast without encrypting it",
                    both(both(removed("Sender_Unicast", "Ready -> Unicast_Encrypted"),
                            added("Sender_Unicast", "Ready", "Unicast_Sent", "sendUnicast!")),
                            added("Receiver_Unicast", "Waiting", "Unicast_Received", "sendUnicast?"))),
            new Fault("lost unicast", "the police's unicast is sent and never arrives",
                    edge("Sender_Unicast", "Unicast_Encrypted -> Unicast_Sent", edge -> edge.withSynchronisation(""))),
            new Fault("forgetfulness", "hospital and ambulance may forget what they decrypted",
                    added("Receiver_Multicast", "Multicast_Decrypted", "Waiting", "")),
            new Fault("shared channel", "the channel is given to a second sender while the first has it",
                    added("Channel", "Not_Released", "Not_Released", "acquire?")),
            new Fault("channel not taken", "the bus sends without asking for the channel",
                    both(edge("Sender_Broadcast", "Connected -> Ready", edge -> edge.withSynchronisation("")),
                            edge("Sender_Broadcast", "Broadcast_Sent -> Idle", edge -> edge.withSynchronisation("")))),
            new Fault("channel kept", "the support service never gives the channel back",
                    edge("Sender_Multicast", "Multicast_Sent -> Idle", edge -> edge.withSynchronisation(""))));

    private Faults() {
    }
}
