package fuzz;

import java.nio.charset.StandardCharsets;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Performative;
import javino.protocol.Frame;
import javino.protocol.ProtocolException;
import javino.protocol.Request;

/** Texts that agents and users give: an address, an action, a term are refused with a reason or sent as they are. */
public final class RequestTarget {

    private static final Address OWN = Address.parse("SUPO");

    private RequestTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) throws ProtocolException {
        // UTF-16, so that lone surrogates come too.
        String text = new String(data, StandardCharsets.UTF_16BE);
        address(new String(data, StandardCharsets.ISO_8859_1));
        act(text);
        transmit(text);
    }

    private static void address(String text) {
        Address address;
        try {
            address = Address.parse(text);
        } catch (IllegalArgumentException refused) {
            return;
        }
        Holds.equal(text, address.toString(), "address");
        Holds.equal(text, address.group() + address.member(), "its halves");
    }

    private static void act(String action) throws ProtocolException {
        Request act;
        try {
            act = Request.act(action);
        } catch (IllegalArgumentException refused) {
            return;
        }
        Frame sent = Frame.decode(act.frame().encode());
        Holds.equal(Bytes.join(Bytes.of('A'), Bytes.ofText(action)), sent.message(), "action");
    }

    private static void transmit(String term) throws ProtocolException {
        Content content;
        try {
            content = new Content(Performative.TELL, term);
        } catch (IllegalArgumentException refused) {
            return;
        }
        Frame sent = Frame.decode(Request.transmit(Address.BROADCAST, OWN, content).frame().encode());
        Holds.equal(content, Content.decode(sent.message()), "content");
    }
}
