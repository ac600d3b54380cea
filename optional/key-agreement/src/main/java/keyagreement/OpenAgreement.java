package keyagreement;

import java.io.IOException;
import java.security.SecureRandom;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.Consumer;

import diffuser.board.KeyService;
import diffuser.report.Failure;

import javino.JavinoException;
import javino.board.LostKeyException;
import javino.board.Transitions;
import javino.board.Transmission;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Key;

/** Does with a board what {@link KeyAgreement} wants, from its opening to its end; on the clock's thread. */
final class OpenAgreement {

    private final KeyService.Host host;
    private final Identity identity;
    private final Set<Address> stored;
    private final Time.Timer clock;
    private final Address self;
    private final Address group;
    private final Set<Address> met = new HashSet<>();
    private final Map<Address, Throwable> failures = new HashMap<>();
    private long alarm = Context.NEVER;
    /** Null when it has ended. */
    private KeyAgreement agreement;
    private volatile Map<Event, Long> events = Map.of();

    /**
     * @param stored for whom the board has stored keys.
     * @param random for keys.
     */
    OpenAgreement(KeyService.Host host, Identity identity, Set<Address> stored, Time.Timer clock, SecureRandom random)
            throws IOException {
        this.host = host;
        this.identity = identity;
        this.stored = stored;
        this.clock = clock;
        self = identity.certificate().address();
        group = Address.multicast(self.group());
        agreement = new KeyAgreement(identity, identity.groupKey(), random);
        step(all -> {
            if (!stored.contains(group)) {
                all.lacksGroupKey(clock.millis());
            }
        });
    }

    /** The counts of events so far. For any thread. */
    Map<Event, Long> events() {
        return events;
    }

    /** Tells the agent with whom there are keys. */
    void tellMet() {
        host.met(met);
    }

    /** Ends all: the board forgets all session keys. */
    void close() {
        step(KeyAgreement::close);
        agreement = null;
        met.clear();
        tellMet();
    }

    /** Takes a step, unless it has ended, and does what follows. */
    void step(Consumer<KeyAgreement> what) {
        if (agreement == null) {
            return;
        }
        what.accept(agreement);
        agreement.effects().forEach(this::perform);
        events = agreement.events();
        if (met.removeIf(peer -> !agreement.isSecure(peer))) {
            tellMet();
        }
        long next = agreement.next();
        if (next < alarm) {
            alarm = next;
            clock.after(Math.max(0, next - clock.millis()), () -> {
                alarm = Context.NEVER;
                step(all -> all.tick(clock.millis()));
            });
        }
    }

    private <T> void whenDone(CompletableFuture<T> what, BiConsumer<T, Throwable> then) {
        what.whenComplete((done, thrown) -> clock.execute(() -> step(all -> then.accept(done, thrown))));
    }

    private void perform(Effect effect) {
        if (effect instanceof Effect.Broadcast broadcast) {
            broadcast(broadcast);
        } else if (effect instanceof Effect.Unicast unicast) {
            unicast(unicast);
        } else if (effect instanceof Effect.Multicast multicast) {
            PendingMessage message = (PendingMessage) multicast.ticket();
            if (!message.isOver()) {
                message.follow(host.send(message.to(), message.message()));
            }
        } else if (effect instanceof Effect.SetSessionKey set) {
            setSessionKey(set.device(), set.key());
        } else if (effect instanceof Effect.DeleteKey delete) {
            host.deleteKey(delete.device());
        } else if (effect instanceof Effect.SetGroupKey set) {
            setGroupKey(set.key());
        } else if (effect instanceof Effect.KeepGroupKey kept) {
            keep("the key of " + group + " could not be kept, and will be another at the next start",
                    () -> identity.keepGroupKey(kept.kept()));
        } else if (effect instanceof Effect.KeepRevocationLists) {
            keep("a revocation list of the authority could not be kept", identity::keep);
        } else if (effect instanceof Effect.Met fresh) {
            met.add(fresh.peer());
            host.met(met);
        } else if (effect instanceof Effect.Receive receive) {
            host.received(receive.from(), receive.content());
        } else if (effect instanceof Effect.End end) {
            PendingMessage message = (PendingMessage) end.ticket();
            message.end(end.how(), end.how() == Ending.NOT_SENT ? failures.remove(message.to()) : null);
        } else {
            Effect.Transition transition = (Effect.Transition) effect;
            Transitions.log(transition.machine(), self, transition.peer(), transition.id(), transition.state());
        }
    }

    private void broadcast(Effect.Broadcast broadcast) {
        long asked = clock.millis();
        whenDone(host.send(Address.BROADCAST, broadcast.message()).end(), (outcome, thrown) -> agreement.said(broadcast,
                thrown == null || !Failure.of(thrown).error().equals("queue_full"), clock.millis() - asked,
                clock.millis()));
    }

    private void unicast(Effect.Unicast unicast) {
        if (unicast.ticket().filter(ticket -> ((PendingMessage) ticket).isOver()).isPresent()) {
            // Its agent was told that it is not sent.
            clock.execute(() -> step(all -> all.sent(unicast.to(), Session.Input.FAILED, clock.millis())));
            return;
        }
        Transmission transmission = host.send(unicast.to(), unicast.message());
        transmission.taken().thenRun(() -> unicast.ticket().ifPresent(ticket -> ((PendingMessage) ticket).take()));
        whenDone(transmission.end(), (outcome, thrown) -> {
            if (thrown == null) {
                agreement.sent(unicast.to(), Session.Input.valueOf(outcome.name()), clock.millis());
            } else {
                failures.put(unicast.to(), thrown);
                agreement.sent(unicast.to(), Failure.of(thrown).error().equals("no_key") ? Session.Input.NO_KEY
                        : Session.Input.FAILED, clock.millis());
            }
        });
    }

    private void setSessionKey(Address device, Key key) {
        whenDone(host.setSessionKey(device, key), (done, thrown) -> {
            if (thrown != null) {
                boolean noPlace = Failure.of(thrown).error().equals("unknown_command");
                Throwable why = noPlace ? new Failure("no_place",
                        "the board has no place for the key with the certified"
                                + " device " + device + ": build its sketch with JAVINO_SESSION_KEYS of 1 or more")
                        .toException() : thrown;
                failures.put(device, why);
                host.warn(Failure.of(why).message());
            }
            agreement.keySet(device, thrown == null, clock.millis());
        });
    }

    void setGroupKey(Key key) {
        whenDone(host.setGroupKey(group, key), (done, thrown) -> {
            if (thrown == null) {
                stored.add(group);
                agreement.groupKeySet();
            } else if (isLostKey(thrown)) {
                agreement.groupKeyRefused(clock.millis());
            } else {
                host.warn(Failure.of(thrown).message());
            }
        });
    }

    private static boolean isLostKey(Throwable thrown) {
        return thrown instanceof LostKeyException || thrown.getCause() instanceof LostKeyException;
    }

    private interface Keeping {

        void keep() throws IOException, JavinoException, InterruptedException;
    }

    private void keep(String failed, Keeping what) {
        try {
            what.keep();
        } catch (IOException | JavinoException | IllegalArgumentException e) {
            host.warn(failed + ": " + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
