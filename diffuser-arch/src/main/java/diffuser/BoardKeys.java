package diffuser;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import jason.asSyntax.Literal;

import javino.protocol.Address;
import javino.protocol.HostMessage;
import javino.protocol.Reply.Role;
import javino.protocol.Reply.StoredKey;

/** Which keys a board has, for its agent. For any thread. */
final class BoardKeys {

    private final Set<Address> stored = ConcurrentHashMap.newKeySet();
    /** Who has had a session key since the port was opened: nobody gets both kinds of keys meanwhile. */
    private final Set<Address> certified = ConcurrentHashMap.newKeySet();
    private volatile Set<Address> met = Set.of();
    private volatile boolean known;

    /** The board has told its keys. */
    void told(List<StoredKey> keys) {
        Set<Address> inEeprom = addresses(keys.stream().filter(key -> key.role() != Role.SESSION));
        stored.retainAll(inEeprom);
        stored.addAll(inEeprom);
        certified.addAll(addresses(keys.stream().filter(key -> key.role() == Role.SESSION)));
        certified.removeAll(inEeprom);
        known = true;
    }

    private static Set<Address> addresses(Stream<StoredKey> keys) {
        return keys.map(StoredKey::address).collect(Collectors.toSet());
    }

    /** A group's key is being stored. */
    void store(Address group) {
        stored.add(group);
    }

    /** A device's session key is being set. */
    void addCertified(Address device) {
        certified.add(device);
    }

    /** With which devices the board has session keys now. */
    void setMet(Set<Address> devices) {
        met = Set.copyOf(devices);
    }

    /** Whether a message to that address would need a key that is not stored. */
    boolean lacks(Address to) {
        boolean needsKey = to.kind() == Address.Kind.DEVICE || to.kind() == Address.Kind.MULTICAST;
        return known && needsKey && !stored.contains(to);
    }

    /** What a device is from which something came sealed; as long as that is not known, certified only. */
    TrustLevel peer(Address device) {
        return known && !certified.contains(device) ? TrustLevel.PROVISIONED : TrustLevel.CERTIFIED;
    }

    /** The same of a host message: keys are agreed on with nobody for whom one is stored, or may be. */
    TrustLevel peer(Address device, HostMessage.Use use) {
        return use == HostMessage.Use.MOVE ? peer(device)
                : lacks(device) ? TrustLevel.CERTIFIED : TrustLevel.PROVISIONED;
    }

    /** A belief for each device with a key. */
    List<Literal> beliefs() {
        Stream<Literal> provisioned = stored.stream().filter(each -> each.kind() == Address.Kind.DEVICE)
                .map(TrustLevel.PROVISIONED::belief);
        return Stream.concat(provisioned, met.stream().map(TrustLevel.CERTIFIED::belief)).toList();
    }
}
