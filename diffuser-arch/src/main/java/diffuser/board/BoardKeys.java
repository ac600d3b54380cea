package diffuser.board;

import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import jason.asSyntax.Literal;

import diffuser.gate.TrustLevel;

import javino.board.AirtimeHour;
import javino.board.Board;
import javino.board.LostState;
import javino.board.ReceivedMessage;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.HostMessage;
import javino.protocol.Key;
import javino.protocol.Message;
import javino.protocol.Reply.Role;
import javino.protocol.Reply.StoredKey;

/** Which keys a board has, and what its agent and key agreement do by these. For any thread. */
final class BoardKeys implements KeyService.Host {

    private final Device device;
    private final Supplier<Board> session;
    private final DeviceContext context;
    private volatile List<StoredKey> told = List.of();
    private final Set<Address> stored = ConcurrentHashMap.newKeySet();
    /** Devices that had a session key since the port was opened: no device gets both kinds of keys meanwhile. */
    private final Set<Address> certified = ConcurrentHashMap.newKeySet();
    private volatile Set<Address> met = Set.of();
    private volatile boolean known;

    BoardKeys(Device device, Supplier<Board> session, DeviceContext context) {
        this.device = device;
        this.session = session;
        this.context = context;
    }

    /** The board has told its keys. */
    void told(List<StoredKey> keys) {
        told = keys;
        Set<Address> inEeprom = addresses(keys.stream().filter(key -> key.role() != Role.SESSION));
        stored.retainAll(inEeprom);
        stored.addAll(inEeprom);
        certified.addAll(addresses(keys.stream().filter(key -> key.role() == Role.SESSION)));
        certified.removeAll(inEeprom);
        known = true;
        LostState.ofFloors(keys).ifPresent(context.warnings()::once);
    }

    private static Set<Address> addresses(Stream<StoredKey> keys) {
        return keys.map(StoredKey::address).collect(Collectors.toSet());
    }

    /** The board is there, with an address: key agreement may begin. */
    void online(Address self, int bootEpoch) {
        context.keyService().ifPresent(keyService -> keyService.online(this, self, bootEpoch, told));
    }

    @Override
    public boolean hasBroadcasts() {
        return !device.hasUnicastsOnly();
    }

    @Override
    public long airtimeWait() {
        return device.airtime().map(AirtimeHour.Use::waitSeconds).orElse(0L);
    }

    @Override
    public Transmission send(Address to, Message message) {
        return device.sender().send(to, message);
    }

    @Override
    public CompletableFuture<?> setSessionKey(Address peer, Key key) {
        certified.add(peer);
        return session.get().setSessionKey(peer, key);
    }

    @Override
    public CompletableFuture<?> setGroupKey(Address group, Key key) {
        return session.get().setKey(group, key).thenRun(() -> stored.add(group));
    }

    @Override
    public CompletableFuture<?> deleteKey(Address peer) {
        return session.get().deleteKey(peer);
    }

    @Override
    public void met(Set<Address> peers) {
        met = Set.copyOf(peers);
        device.keysChanged();
    }

    @Override
    public void received(Address from, Content content) {
        device.address()
                .ifPresent(self -> device.take(new ReceivedMessage(from, self, 0, content), TrustLevel.CERTIFIED));
    }

    @Override
    public void warn(String what) {
        context.warnings().once(what);
    }

    /** Whether a message to that address would need a key that is not stored. */
    boolean lacks(Address to) {
        boolean needsKey = to.kind() == Address.Kind.DEVICE || to.kind() == Address.Kind.MULTICAST;
        return known && needsKey && !stored.contains(to);
    }

    /** The trust level of a device from which a sealed message came; certified as long as the keys are not known. */
    TrustLevel peer(Address from) {
        return known && !certified.contains(from) ? TrustLevel.PROVISIONED : TrustLevel.CERTIFIED;
    }

    /** The same of a message's sender; anyone with a certificate has the key of a group that key agreement shares. */
    TrustLevel peer(ReceivedMessage message) {
        boolean shared = message.to().kind() == Address.Kind.MULTICAST
                && context.keyService().map(KeyService::sharesGroup).orElse(false);
        return shared ? TrustLevel.CERTIFIED : peer(message.from());
    }

    /** The same of a host message: keys are agreed on with nobody for whom one is stored, or may be. */
    TrustLevel peer(Address from, HostMessage.Use use) {
        return use == HostMessage.Use.MOVE ? peer(from)
                : lacks(from) ? TrustLevel.CERTIFIED : TrustLevel.PROVISIONED;
    }

    /** A belief for each device with a key. */
    List<Literal> beliefs() {
        Stream<Literal> provisioned = stored.stream().filter(each -> each.kind() == Address.Kind.DEVICE)
                .map(TrustLevel.PROVISIONED::belief);
        return Stream.concat(provisioned, met.stream().map(TrustLevel.CERTIFIED::belief)).toList();
    }
}
