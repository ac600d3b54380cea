package diffuser.board;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;

import diffuser.gate.TrustLevel;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;

import org.junit.jupiter.api.Test;

class HostMessagesTest {

    private static final Address ROMA = Address.parse("ROMA");
    private static final Address SUPO = Address.parse("SUPO");

    private final List<Kind> taken = new ArrayList<>();
    private final List<String> warnings = new ArrayList<>();

    /** Takes what is for these uses. */
    private record Taker(Set<HostMessage.Use> uses, List<Kind> taken) implements HostService {

        @Override
        public void received(Address from, HostMessage message) {
            taken.add(message.kind());
        }
    }

    private HostMessages messages(HostMessage.Use... uses) {
        return new HostMessages(List.of(new Taker(Set.of(uses), taken)), warnings::add);
    }

    private static HostMessage message(Kind kind) {
        boolean plain = kind.compareTo(Kind.GROUP) <= 0;
        Bytes body = Bytes.copyOf(new byte[kind.length() < 0 ? 5 : kind.length()]);
        return plain ? HostMessage.fragments(kind, SUPO, body).get(0) : new HostMessage(kind, body);
    }

    /** SPEC 3.1's rule for each kind, and no other: handshakes come broadcast, all else sealed for this device. */
    @Test
    void receive_eachKindByEachCastAndKey_reachesItsLibraryOnlyAsTheSpecificationSays() {
        HostMessages messages = messages(HostMessage.Use.values());
        long refused = 0;
        for (Kind kind : Kind.values()) {
            for (Address to : List.of(Address.BROADCAST, Address.multicast(SUPO.group()), SUPO)) {
                for (TrustLevel key : TrustLevel.values()) {
                    boolean session = key == TrustLevel.CERTIFIED;
                    boolean stored = key == TrustLevel.PROVISIONED;
                    boolean right = kind.compareTo(Kind.GROUP) <= 0 ? to.equals(Address.BROADCAST) && session
                            : to.equals(SUPO) && (session || stored && kind.name().startsWith("MOVE_"));
                    taken.clear();
                    messages.receive(ROMA, to, key, message(kind));
                    assertEquals(right ? List.of(kind) : List.of(), taken, () -> kind + " to " + to + ", " + key);
                    refused += right ? 0 : 1;
                    assertEquals(refused, messages.refused());
                }
            }
        }
        assertEquals(EnumSet.allOf(TrustLevel.class).size() * 3L * Kind.values().length, refused + 8 + 5 + 2 * 8);
    }

    @Test
    void receive_whereItsLibraryIsNotThere_isCountedAndNamedUnlessItWasBroadcast() {
        HostMessages messages = messages();
        messages.receive(ROMA, Address.BROADCAST, TrustLevel.CERTIFIED, message(Kind.MESSAGE_1));
        assertEquals(List.of(), warnings);
        messages.receive(ROMA, SUPO, TrustLevel.PROVISIONED, message(Kind.MOVE_GO));
        assertEquals(List.of("dropped a host message MOVE_GO from ROMA: the library for it is not there"), warnings);
        assertEquals(2, messages.refused());
    }

    @Test
    void receive_inTheNameOfNoDevice_isRefused() {
        HostMessages messages = messages(HostMessage.Use.values());
        messages.receive(Address.BROADCAST, Address.BROADCAST, TrustLevel.CERTIFIED, message(Kind.MESSAGE_1));
        assertEquals(List.of(), taken);
        assertEquals(1, messages.refused());
    }
}
