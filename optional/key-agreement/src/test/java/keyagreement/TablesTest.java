package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import keyagreement.HandshakeState.Deed;
import keyagreement.HandshakeState.Input;
import keyagreement.edhoc.Initiator;
import keyagreement.edhoc.Responder;
import keyagreement.edhoc.Role;
import keyagreement.edhoc.Secret;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Each pair of a state and an input, as SPEC 11.3 has it. */
class TablesTest {

    private static final SecureRandom RANDOM = new SecureRandom();
    private static final Address ROMA = Address.parse("ROMA");
    private static final Address SUPO = Address.parse("SUPO");

    @TempDir
    Path folder;
    private Context context;
    private Identity other;
    private Optional<Secret> kept;
    private long now;

    @BeforeEach
    void certify() throws Exception {
        TestAuthority authority = new TestAuthority(folder);
        context = new Context(authority.certified("ROMA"), RANDOM);
        other = authority.certified("SUPO");
    }

    private static Stream<Table<?, ?, ?>> tables() {
        return Stream.of(HandshakeState.TABLE, Session.TABLE, MessageQueue.TABLE, RevocationLists.TABLE);
    }

    @Test
    void specification_hasThese() throws Exception {
        String section = Files.readString(Path.of(System.getProperty("javino.spec"))).split("### 11.3 ")[1];
        List<String> blocks = Stream.of(section.split("```\n")).filter(block -> block.startsWith(" ")).toList();
        assertEquals(tables().map(Table::grid).toList(), blocks);
        Set<String> reasons = tables().flatMap(table -> table.cells().values().stream())
                .filter(Table.Cell::isIgnored).map(Table.Cell::ignored).collect(Collectors.toSet());
        reasons.forEach(reason -> assertTrue(section.contains("`" + reason + "`"), reason));
    }

    @Test
    void states_areAllReached() {
        tables().forEach(table -> {
            Set<Object> states = table.cells().values().stream().map(Table.Cell::next).collect(Collectors.toSet());
            table.cells().keySet().forEach(pair -> {
                Enum<?> state = pair.get(0);
                assertTrue(state.ordinal() == 0 || states.contains(state) || state == HandshakeState.ANSWERING,
                        () -> state + " is never reached");
            });
        });
    }

    @ParameterizedTest
    @ValueSource(strings = {"NONE NEVER\nSEALED . .", "NONE SETTING UNPROVEN PROVEN\nBOOTED . . . ."})
    void table_thatIsNotWhole_isRefused(String grid) {
        assertThrows(IllegalArgumentException.class,
                () -> Table.of(Session.class, Session.Input.class, Session.Deed.class, grid));
    }

    /** A handshake that has come to a state by messages. */
    private Handshake in(HandshakeState state, Round round) throws Exception {
        kept = Optional.empty();
        Secret before = secret();
        kept = round == Round.FULL ? Optional.empty() : Optional.of(before);
        Handshake made = state.compareTo(HandshakeState.ANSWERING) < 0 ? begun(state) : answered(state);
        context.effects().clear();
        now += 1000;
        assertEquals(state, made.state());
        return made;
    }

    private Secret secret() throws Exception {
        Handshake run = Handshake.begin(context, SUPO, Optional.empty(), false, now);
        Role role = new Responder(other.with(ROMA), said().get(0).body(), RANDOM);
        parts(Kind.MESSAGE_2, role).forEach(part -> run.heard(part, now));
        return run.secret();
    }

    private Handshake begun(HandshakeState state) throws Exception {
        Handshake run = Handshake.begin(context, SUPO, kept, state == HandshakeState.WAITING, now);
        if (state == HandshakeState.WAITING) {
            return run;
        }
        Bytes message1 = onAir(run).body();
        Role role = kept.isPresent() ? Renewal.answer(kept.get(), SUPO, ROMA, message1, RANDOM)
                : new Responder(other.with(ROMA), message1, RANDOM);
        List<HostMessage> second = parts(run.round.second, role);
        if (state == HandshakeState.ASKING) {
            run.heard(new HostMessage(second.get(0).kind(), second.get(0).to(), 0,
                    Bytes.copyOf(new byte[second.get(0).body().length()])), now);
            run.step(Input.LACKING, now);
            onAir(run);
        }
        if (state.compareTo(HandshakeState.SETTING) >= 0) {
            second.forEach(part -> run.heard(part, now));
        }
        if (state.compareTo(HandshakeState.CLOSING) >= 0) {
            run.step(Input.SET, now);
        }
        if (state == HandshakeState.CLOSED) {
            onAir(run);
        }
        return run;
    }

    private Handshake answered(HandshakeState state) throws Exception {
        Role role = kept.isPresent() ? Renewal.begin(kept.get(), SUPO, ROMA, RANDOM)
                : new Initiator(other.with(ROMA), RANDOM);
        Handshake run = Handshake.answer(context, SUPO, kept, role.opening(), now);
        if (state.compareTo(HandshakeState.ANSWERED) >= 0) {
            said().forEach(message -> run.onAir(message, 0, now));
        }
        if (state == HandshakeState.DUE) {
            run.again(now);
        }
        return run;
    }

    private List<HostMessage> parts(Kind kind, Role role) {
        return HostMessage.fragments(kind, ROMA, role.opening());
    }

    private HostMessage onAir(Handshake run) {
        HostMessage said = said().get(0);
        run.onAir(said, 0, now);
        return said;
    }

    /** The messages since this was asked last. */
    private List<HostMessage> said() {
        List<HostMessage> said = new ArrayList<>();
        context.effects().stream().filter(Effect.Broadcast.class::isInstance)
                .forEach(effect -> said.add(((Effect.Broadcast) effect).message()));
        context.effects().clear();
        return said;
    }

    @ParameterizedTest
    @EnumSource(Round.class)
    void handshake_inEachState_doesWithEachInputWhatTheTableHas(Round round) throws Exception {
        for (HandshakeState state : EnumSet.complementOf(EnumSet.of(HandshakeState.OVER))) {
            for (Input input : Input.values()) {
                Handshake run = in(state, round);
                long deadline = run.deadline();
                Table.Cell<HandshakeState, Deed> cell = HandshakeState.TABLE.cell(state, input);
                String what = round + ", " + state + " at " + input;
                assertEquals(cell.isIgnored() ? Optional.empty() : Optional.of(cell.deed()), run.step(input, now),
                        what);
                assertEquals(cell.next(), run.state(), what);
                assertEquals(said(state, input, run), said().stream().map(HostMessage::kind).toList(), what);
                assertTrue(!cell.isIgnored() || run.deadline() == deadline, what);
            }
        }
    }

    /** The messages by which SPEC has the other side learn of it. */
    private static List<Kind> said(HandshakeState state, Input input, Handshake run) {
        boolean late = input == Input.LATE || input == Input.LACKING;
        return switch (state) {
            case WAITING, ASKING -> late ? List.of(run.round.first) : List.of();
            case OPEN -> input == Input.LATE ? List.of(run.round.first)
                    : input == Input.LACKING ? List.of(Kind.WANT) : List.of();
            case SETTING -> input == Input.SET ? List.of(run.round.third) : List.of();
            case CLOSED -> input == Input.WANTED ? List.of(run.round.third) : List.of();
            case ANSWERED -> input == Input.LACKING || input == Input.UNOPENED ? List.of(Kind.WANT) : List.of();
            case DUE -> late || input == Input.SPENT
                    ? Collections.nCopies(run.round.second.fragments(), run.round.second) : List.of();
            case CLOSING, ANSWERING, OVER -> List.of();
        };
    }

    /** A peer's session, as it was told last. */
    private Session session = Session.NONE;
    private final List<Effect> done = new ArrayList<>();

    private List<Effect> effects() {
        List<Effect> effects = List.copyOf(context.effects());
        context.effects().clear();
        done.addAll(effects);
        effects.stream().filter(Effect.Transition.class::isInstance).map(Effect.Transition.class::cast)
                .filter(each -> each.machine().equals("session")).forEach(each -> session = (Session) each.state());
        return effects;
    }

    /** Has all that was said come to the air, until nothing more is said. */
    private List<HostMessage> onAir(Peer peer) {
        List<HostMessage> said = new ArrayList<>();
        for (List<Effect> effects = effects(); !effects.isEmpty(); effects = effects()) {
            now += 1000;
            effects.stream().filter(Effect.Broadcast.class::isInstance).map(Effect.Broadcast.class::cast)
                    .forEach(each -> {
                        said.add(each.message());
                        peer.said(each, true, 0, now);
                    });
        }
        return said;
    }

    /** The other side begins a handshake with the peer's host, and ends it. */
    private void meet(Peer peer) throws Exception {
        Initiator initiator = new Initiator(other.with(ROMA), RANDOM);
        onAir(peer);
        peer.handshake(new HostMessage(Kind.MESSAGE_1, ROMA, initiator.opening()), now);
        Bytes message2 = onAir(peer).stream().map(HostMessage::body).reduce(Bytes.EMPTY, Bytes::join);
        if (message2.length() > 0) {
            peer.handshake(new HostMessage(Kind.MESSAGE_3, ROMA, initiator.take(message2).answer()), now);
        }
        effects();
    }

    /** A peer in a state, with a message under way. */
    private Peer peer(Session state) throws Exception {
        context = new Context(context.identity(), RANDOM);
        now += 100_000;
        Peer peer = new Peer(context, new GroupKeys(context, Optional.empty()), SUPO);
        session = Session.NONE;
        peer.send("ticket", new HostMessage(Kind.CONTENT, Bytes.of(1, 2, 3)), now);
        Role role = new Responder(other.with(ROMA), onAir(peer).get(0).body(), RANDOM);
        parts(Kind.MESSAGE_2, role).forEach(part -> peer.handshake(part, now));
        peer.keySet(true, now);
        onAir(peer);
        now += 2000;
        switch (state) {
            case NONE -> peer.booted(now);
            case SETTING -> meet(peer);
            case UNPROVEN -> peer.giveWay(now);
            case PROVEN -> peer.opened(new HostMessage(Kind.SEQUENCES, Bytes.EMPTY), now);
        }
        effects();
        assertEquals(state, session);
        done.clear();
        return peer;
    }

    private void happens(Session.Input input, Peer peer) throws Exception {
        switch (input) {
            case VERIFIED -> meet(peer);
            case SET_FIRST, SET_SECOND -> peer.keySet(true, now);
            case NOT_SET -> peer.keySet(false, now);
            case SEALED -> peer.opened(new HostMessage(Kind.SEQUENCES, Bytes.EMPTY), now);
            case DELIVERED, UNDELIVERED, NO_KEY, FAILED -> peer.sent(input, now);
            case UNOPENED -> peer.noKey(now);
            case BOOTED -> peer.booted(now);
            case FORGOTTEN -> peer.forget(Ending.CLOSED);
        }
    }

    @Test
    void peer_inEachState_doesWithEachInputWhatTheTableHas() throws Exception {
        for (Session state : Session.values()) {
            for (Session.Input input : Session.Input.values()) {
                String what = state + " at " + input;
                Peer peer = peer(state);
                if (state == Session.UNPROVEN && input == Session.Input.UNDELIVERED) {
                    happens(input, peer);
                    assertEquals(List.of(Kind.MESSAGE_3), onAir(peer).stream().map(HostMessage::kind).toList());
                }
                happens(input, peer);
                effects();
                // The other side has begun: so the board was being given the key of a second one.
                boolean second = state == Session.SETTING && input == Session.Input.SET_FIRST;
                Table.Cell<Session, Session.Deed> cell = Session.TABLE.cell(state,
                        second ? Session.Input.SET_SECOND : input);
                assertEquals(cell.next(), session, what);
                boolean ended = done.stream().anyMatch(Effect.End.class::isInstance);
                assertEquals(cell.deed() == Session.Deed.END || input == Session.Input.FORGOTTEN, ended, what);
                boolean begins = done.stream().anyMatch(effect -> effect instanceof Effect.Broadcast broadcast
                        && broadcast.message().kind().first() <= Kind.RENEWAL_1.first()
                        && broadcast.message().kind() != Kind.MESSAGE_2
                        && broadcast.message().kind() != Kind.MESSAGE_3);
                // For the message under way, or for the next.
                assertEquals(cell.next() == Session.NONE && cell.deed() != Session.Deed.NOTHING, begins, what);
            }
        }
    }

    @Test
    void outcome_underAKeyThatWasReplaced_changesNoStateAndTheMessageGoesAgain() throws Exception {
        for (Session.Input input : List.of(Session.Input.UNDELIVERED, Session.Input.NO_KEY)) {
            Peer peer = peer(Session.SETTING);
            peer.keySet(true, now);
            effects();
            done.clear();
            happens(input, peer);
            effects();
            assertEquals(Session.PROVEN, session, input.name());
            assertEquals(List.of(Effect.Unicast.class), done.stream().map(Object::getClass).toList(), input.name());
        }
    }
}
