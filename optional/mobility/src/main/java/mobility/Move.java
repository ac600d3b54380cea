package mobility;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import diffuser.gate.Cast;
import diffuser.gate.Provenance;
import diffuser.gate.TrustLevel;

import javino.protocol.Address;
import javino.protocol.Bytes;

/**
 * The record of a move, as it is kept in a {@link MoveStore} (SPEC 9.3).
 *
 * @param key      which move.
 * @param state    how far it is.
 * @param protocol the agent's role after it.
 * @param identity the agent that moves.
 * @param name     the agent's name on this side.
 * @param parts    the hashes of its texts.
 * @param isOurs   whether the program of this MAS starts the agent, so that it must not as long as the agent is away.
 * @param before   the move by which an agent came that moves on; its record ends when the agent has gone.
 */
record Move(Key key, State state, Protocol protocol, Identity identity, String name, List<Bytes> parts,
        boolean isOurs, Optional<Key> before) {

    private static final String CHECK = "check";

    /**
     * An agent that travels, wherever it is, and whatever it is called there.
     *
     * @param home  the device of the MAS from which it first came.
     * @param name  its name there.
     * @param token 8 random bytes, drawn each time that it leaves its home, known only where it has been since.
     */
    record Identity(Address home, String name, Bytes token) {

        static final int TOKEN_LENGTH = 8;

        Identity {
            if (token.length() != TOKEN_LENGTH) {
                throw new IllegalArgumentException("a return token has " + TOKEN_LENGTH + " bytes");
            }
        }

        /** In a time that does not tell how much of the token is right. */
        private boolean isSame(Identity other) {
            return home.equals(other.home) && name.equals(other.name) && token.isSame(other.token);
        }
    }

    /** How far a move is: three states of a sender, then three of a receiver. */
    enum State {
        /** It may come back. */
        OFFERED,
        /** It will never wake here. */
        GONE,
        /** It is awake elsewhere. */
        AWAY,
        /** It is here, but may still belong to its sender. */
        READY,
        /** It is awake here. */
        HERE,
        /** It was awake here, and has gone on. */
        LEFT
    }

    /**
     * Which move, and on which side.
     *
     * @param out    whether the agent leaves.
     * @param peer   the device on the other side.
     * @param number as the sender has chosen it.
     */
    record Key(boolean out, Address peer, int number) {

        /** As a file's name; the slash of an address is none. */
        @Override
        public String toString() {
            return String.format("%s-%s-%08x", out ? "out" : "in", peer.toString().replace('/', '_'), number);
        }

        /** @throws IllegalArgumentException if it is no file's name of a key. */
        static Key parse(String name) {
            String[] words = name.split("-");
            if (words.length != 3 || !name.matches("(out|in)-.{4}-[0-9a-f]{8}")) {
                throw new IllegalArgumentException(name + " names no move");
            }
            return new Key(words[0].equals("out"), Address.parse(words[1].replace('_', '/')),
                    Integer.parseUnsignedInt(words[2], 16));
        }
    }

    Move in(State next) {
        return new Move(key, next, protocol, identity, name, parts, isOurs, before);
    }

    Move named(String local) {
        return new Move(key, state, protocol, identity, local, parts, isOurs, before);
    }

    /** Whether the agent is awake on the other side, or will be, and never here by this move. */
    boolean isAbsent() {
        return state == State.GONE || state == State.AWAY;
    }

    /** Whether the agent that comes by it is the one that left by another: from where it went, with its token. */
    boolean isReturnOf(Move absence) {
        return absence.isAbsent() && key.peer.equals(absence.key.peer) && identity.isSame(absence.identity);
    }

    /**
     * The origin of an agent that comes by this move.
     *
     * @param peer    the trust level of the device on the other side, by its key.
     * @param here    the board to which it comes; where that is not known, any agent may be at home there.
     * @param returns whether it {@link #isReturnOf} a going from there.
     */
    Provenance provenance(TrustLevel peer, Optional<Address> here, boolean returns) {
        return Provenance.of(key.peer, Cast.UNICAST, peer).moving(identity.home, here.orElse(identity.home), returns);
    }

    /** Whether it lives here as a guest: of one that was to leave, the move by which it came says so. */
    boolean isGuest(List<Move> records) {
        return key.out
                ? records.stream().anyMatch(came -> before.equals(Optional.of(came.key)) && came.isGuest(records))
                : isOfGuest();
    }

    /** Whether a move that comes brings a guest. */
    boolean isOfGuest() {
        return protocol == Protocol.INQUILINISM;
    }

    /** Whether the agent sleeps here, and may wake here. */
    boolean isOpen() {
        return state == State.OFFERED || state == State.READY;
    }

    /** Whether it brings another agent, and the original stays. */
    boolean isClone() {
        return protocol == Protocol.CLONING;
    }

    /** Whether the agent sleeps here and its move has not ended. */
    boolean isUnderWay() {
        return state == State.OFFERED || state == State.GONE;
    }

    Move ours() {
        return new Move(key, state, protocol, identity, name, parts, true, before);
    }

    /** As a file's text. */
    Properties properties() {
        Properties all = new Properties();
        all.setProperty("state", state.name());
        all.setProperty("protocol", protocol.name());
        all.setProperty("home", identity.home.toString());
        all.setProperty("agent", identity.name);
        all.setProperty("token", identity.token.hex());
        all.setProperty("name", name);
        all.setProperty("parts", parts.stream().map(Bytes::hex).collect(Collectors.joining(",")));
        all.setProperty("ours", String.valueOf(isOurs));
        before.ifPresent(known -> all.setProperty("before", known.toString()));
        all.setProperty(CHECK, check(all));
        return all;
    }

    /** A file that has lost a line is no record: the agent would be taken for another's, or for one that is here. */
    private static String check(Properties all) {
        Map<Object, Object> others = new TreeMap<>(all);
        others.remove(CHECK);
        return Part.hash(Bytes.ofText(others.toString())).hex();
    }

    /** @throws IllegalArgumentException if these are no record's. */
    static Move of(String file, Properties all) {
        if (!check(all).equals(all.getProperty(CHECK))) {
            throw new IllegalArgumentException("it is damaged");
        }
        return new Move(Key.parse(file), State.valueOf(all.getProperty("state")),
                Protocol.valueOf(all.getProperty("protocol")),
                new Identity(Address.parse(all.getProperty("home")), all.getProperty("agent"),
                        Bytes.ofHex(all.getProperty("token", ""))),
                all.getProperty("name"),
                Stream.of(all.getProperty("parts").split(",")).filter(hash -> !hash.isEmpty()).map(Bytes::ofHex)
                        .toList(),
                Boolean.parseBoolean(all.getProperty("ours")),
                Optional.ofNullable(all.getProperty("before")).map(Key::parse));
    }
}
