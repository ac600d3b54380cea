package keyagreement;

import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;

import diffuser.gate.TrustLevel;

import simulation.Network;
import simulation.SimulatedHost;

import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.HostMessage;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.Performative;

/** A host that agrees on keys by its certificate: it sends by these alone. */
public final class CertifiedHost extends SimulatedHost implements SimulatedHost.Program {

    final Identity identity;
    KeyAgreement agreement;
    private long tick;
    private Optional<GroupKeys.Kept> keptGroupKey = Optional.empty();
    /** In the board's EEPROM. */
    Optional<Key> groupKey = Optional.empty();
    /** All that the board was given, in their order. */
    final List<Key> groupKeys = new ArrayList<>();
    /** Keys that the board had, as the host has noted. */
    final Set<Key> noted = new HashSet<>();
    final Map<Address, Integer> met = new LinkedHashMap<>();
    int keysSet;
    private final Map<String, Simulation.Letter> said;

    /** @param said the messages of agents, by their contents. */
    CertifiedHost(Network<?> network, Identity identity, Map<String, Simulation.Letter> said) {
        super(network, identity.certificate().address());
        this.identity = identity;
        this.said = said;
        trust = TrustLevel.CERTIFIED;
        programs.add(this);
    }

    /** Makes hosts with certificates of one authority. @param folder the place of the certificates. */
    public static BiFunction<Network<?>, Address, SimulatedHost> maker(Path folder) {
        TestAuthority authority = new TestAuthority(folder);
        return (network, address) -> new CertifiedHost(network, authority.certified(address.toString()),
                new HashMap<>());
    }

    @Override
    public Set<HostMessage.Use> uses() {
        return Set.of(HostMessage.Use.HANDSHAKE, HostMessage.Use.KEY_AGREEMENT);
    }

    @Override
    public void started() {
        tick = Long.MAX_VALUE;
        board.keys.clear();
        agreement = new KeyAgreement(identity, keptGroupKey, new SecureRandom() {
            private static final long serialVersionUID = 1L;

            @Override
            public void nextBytes(byte[] bytes) {
                network.random.nextBytes(bytes);
            }
        });
        after(0, () -> {});
    }

    @Override
    public void received(Address from, HostMessage message) {
        agreement.received(from, message, millis());
    }

    @Override
    protected void noKey(Address from) {
        agreement.noKey(from, millis());
    }

    @Override
    protected void booted() {
        agreement.booted(millis());
    }

    @Override
    public void within(Runnable step) {
        super.within(() -> {
            fault("before a step");
            step.run();
            for (List<Effect> due = agreement.effects(); !due.isEmpty(); due = agreement.effects()) {
                due.forEach(this::perform);
            }
        });
        long next = on ? agreement.next() : Long.MAX_VALUE;
        if (next < tick) {
            tick = next;
            after(next - millis(), () -> {
                if (tick <= millis()) {
                    tick = Long.MAX_VALUE;
                    agreement.tick(millis());
                }
            });
        }
    }

    Simulation.Letter send(Address to) {
        Content content = new Content(Performative.TELL, "x" + said.size());
        Simulation.Letter letter = new Simulation.Letter(address, to, millis());
        said.put(content.term(), letter);
        within(() -> {
            if (on) {
                letter.isRefused = !agreement.send(letter, to, content, millis());
            }
        });
        return letter;
    }

    @Override
    public CompletableFuture<Outcome> send(Address to, HostMessage message) {
        if (to.equals(address)) {
            return super.send(to, message);
        }
        PendingMessage mine = new PendingMessage(to, message);
        if (!agreement.send(mine, to, message, millis())) {
            mine.fail("queue_full", "too many wait");
        }
        return mine.transmission().end();
    }

    /** Its end is told as long as the program runs. */
    private void transmit(Address to, HostMessage message, BiConsumer<Outcome, Throwable> ended) {
        KeyAgreement then = agreement;
        sender.send(to, message).end().whenComplete((outcome, thrown) -> {
            try {
                if (on && agreement == then) {
                    ended.accept(outcome, thrown);
                }
            } catch (RuntimeException e) {
                network.wrong.add(e.toString());
            }
        });
    }

    private void perform(Effect effect) {
        if (effect instanceof Effect.Broadcast broadcast) {
            fault("broadcast");
            long asked = millis();
            transmit(Address.BROADCAST, broadcast.message(), (outcome, thrown) -> agreement.said(broadcast,
                    thrown == null, millis() - asked, millis()));
        } else if (effect instanceof Effect.Unicast unicast) {
            fault("unicast");
            transmit(unicast.to(), unicast.message(), (outcome, thrown) -> agreement.sent(unicast.to(), thrown != null
                    ? Session.Input.NO_KEY : Session.Input.valueOf(outcome.name()), millis()));
        } else if (effect instanceof Effect.SetSessionKey set) {
            fault("key");
            later(() -> {
                if (!board.lost) {
                    boolean done = board.set(set.device(), set.key());
                    keysSet++;
                    later(() -> agreement.keySet(set.device(), done, millis()));
                }
            });
        } else if (effect instanceof Effect.DeleteKey delete) {
            later(() -> board.keys.remove(delete.device()));
        } else if (effect instanceof Effect.SetGroupKey set) {
            later(() -> setGroupKey(set.key()));
        } else if (effect instanceof Effect.KeepGroupKey kept) {
            keptGroupKey = Optional.of(kept.kept());
        } else if (effect instanceof Effect.Met fresh) {
            met.merge(fresh.peer(), 1, Integer::sum);
        } else if (effect instanceof Effect.Receive receive) {
            received(receive.from(), receive.content());
        } else if (effect instanceof Effect.End end) {
            ended(end);
        }
    }

    private void setGroupKey(Key key) {
        if (noted.contains(key) && !groupKey.equals(Optional.of(key))) {
            agreement.groupKeyRefused(millis());
            return;
        }
        groupKey = Optional.of(key);
        groupKeys.add(key);
        noted.add(key);
        board.eepromWrites++;
        agreement.groupKeySet();
    }

    /** Erases the board's EEPROM, and has the host notice that. */
    void erase() {
        groupKey = Optional.empty();
        board.reset();
        within(() -> agreement.lacksGroupKey(millis()));
    }

    private void ended(Effect.End end) {
        if (end.ticket() instanceof PendingMessage message) {
            message.end(end.how(), null);
            return;
        }
        Simulation.Letter letter = (Simulation.Letter) end.ticket();
        if (letter.end.isPresent()) {
            network.wrong.add("a message ended twice");
        }
        letter.end = Optional.of(end.how());
        letter.endedAt = millis();
    }

    private void received(Address from, Content content) {
        Simulation.Letter letter = said.get(content.term());
        if (letter == null || !letter.from.equals(from) || !letter.to.equals(address)) {
            network.wrong.add(address + " accepted " + content + " from " + from);
        } else if (!letter.receivedBy.add(address + " " + life)) {
            network.wrong.add(content + " came twice to " + address);
        }
    }
}
