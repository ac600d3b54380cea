package javino.protocol;

/** A message of one device to another: for its agent, or for its host (SPEC 3). */
public sealed interface Message permits Content, HostMessage {

    /** Its bytes, 1…494, before the board seals them. */
    Bytes encode();
}
