package uppaal.replay;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import uppaal.network.StateSet;

/**
 * One end of a move, at its sender's host or at its receiver's: what its automata may be doing. A host hears what its
 * board has handed to it in that order, but perhaps only after it has said more; so each such moment is followed.
 */
final class MoveEnd {
    private static final String OFFERED = "End.Offered && End.next < PARTS";
    private static final String OPEN = "End.Offered";
    private static final String NOT_OPEN = "!End.Offered";
    private static final String GONE = "End.Gone";
    private static final String AWAKE = "awake[SUPPORT] == 1";
    private static final String NONE = "End.None";
    private static final String SOME = "!End.None";
    private static final String COMING = "End.Coming";
    private static final String NOT_COMING = "!End.Coming";
    /** What is asked of a sender. */
    static final List<String> OF_SENDER = List.of(OFFERED, OPEN, NOT_OPEN, GONE, AWAKE);
    /** What is asked of a receiver. */
    static final List<String> OF_RECEIVER = List.of(NONE, SOME, COMING, NOT_COMING);
    /** So many messages a host may have been handed and not yet heard. */
    private static final int MOST_UNHEARD = 8;
    private static final int WHOLE = 2;
    private static final List<Integer> UNKNOWN = List.of();

    /**
     * What may be.
     *
     * @param heard how many of all messages were heard
     * @param at of each part: a sender's next byte, or how many bytes a receiver has at most; none where it has said
     *     nothing of them since it began
     */
    private record State(StateSet possible, int heard, List<Integer> at) {
        State with(StateSet other) {
            return new State(other, heard, at);
        }

        State heard(StateSet other, List<Integer> bytes) {
            return new State(other, heard + 1, bytes);
        }
    }

    /**
     * What a board has handed to its host.
     *
     * @param kept of an offer: how many bytes of its parts may be there
     */
    private record Heard(MoveWord word, List<Integer> kept) {}

    /** Its board. */
    final String board;
    final String move;
    final boolean isSender;
    private final Handover handover;
    private Handover.Scene scene;
    private List<State> states;
    private final List<Heard> unheard = new ArrayList<>();
    /** How many were heard in every state, and so are forgotten. */
    private int forgotten;
    /** Its last offer; null where none is known. */
    private MoveWord offer;
    private List<MoveWord.Part> parts = List.of();
    private int all;
    private int half;
    /** What the agent is called, as a receiver has said since it began; null where it has not. */
    private String named;

    /** @param move the number of the move */
    MoveEnd(String board, boolean isSender, String move, Handover handover) {
        this.board = board;
        this.move = move;
        this.isSender = isSender;
        this.handover = handover;
        begin(isSender ? handover.sender(false) : handover.receiver());
    }

    private void begin(Handover.Scene beginning) {
        scene = beginning;
        states = List.of(new State(scene.first(), forgotten, UNKNOWN));
    }

    /** The offer; nothing where none is known. */
    Optional<MoveWord> offer() {
        return Optional.ofNullable(offer);
    }

    List<MoveWord.Part> parts() {
        return parts;
    }

    /** How many bytes may be there of each of its parts, behind a want: with those that were handed meanwhile. */
    List<Integer> atMost() {
        List<Integer> most = new ArrayList<>(states.get(0).at);
        for (Heard heard : unheard) {
            if (heard.word.is('D') && heard.word.part() < most.size()
                    && heard.word.offset() <= most.get(heard.word.part())) {
                most.set(heard.word.part(), Math.max(most.get(heard.word.part()), heard.word.end()));
            }
        }
        return most;
    }

    private void offered(MoveWord word) {
        offer = word;
        parts = word.parts();
        all = parts.stream().mapToInt(MoveWord.Part::packed).sum();
        half = (all + 1) / 2;
    }

    private static int total(List<Integer> bytes) {
        return bytes.stream().mapToInt(Integer::intValue).sum();
    }

    /** How many of the model's two pieces so many bytes are: its first piece is the first half of them. */
    private int pieces(int bytes) {
        return bytes >= all ? WHOLE : bytes >= half ? 1 : 0;
    }

    // What its host says

    /** @return whether it may say that now. */
    boolean says(MoveWord word) {
        if (word.is('O') && offer == null) {
            offered(word);
            if (word.isCloning()) {
                begin(handover.sender(true));
            }
        } else if (word.is('O') && !Arrays.equals(word.body(), offer.body())) {
            return false;
        }
        if (word.is('A') && !word.agent().isEmpty()) {
            if (named != null && !named.equals(word.agent())) {
                return false;
            }
            named = word.agent();
        }
        List<State> after = new ArrayList<>();
        every(state -> said(state, word).ifPresent(after::add));
        if (after.isEmpty()) {
            return false;
        }
        set(after);
        return true;
    }

    private Optional<State> said(State state, MoveWord word) {
        return switch (word.type()) {
            case 'W' -> wanted(state, word);
            case 'D' -> sent(state, word);
            case 'A' -> after(state, "says A" + (word.agent().isEmpty() ? " unknown" : ""));
            default -> after(state, "says " + word.type());
        };
    }

    private Optional<State> after(State state, String name) {
        return handover.after(scene, state.possible, name).map(state::with);
    }

    /** It has what it wants no more, and nothing that did not come. */
    private Optional<State> wanted(State state, MoveWord word) {
        List<Integer> from = word.offsets();
        boolean may = from.size() == state.at.size();
        for (int i = 0; may && i < from.size(); i++) {
            may = from.get(i) <= state.at.get(i);
        }
        return !may ? Optional.empty()
                : after(state, "says W" + pieces(total(from)))
                        .map(wanting -> new State(wanting.possible, state.heard, from));
    }

    /** It goes on where it was asked to; of what it has said one message may not have come to its board. */
    private Optional<State> sent(State state, MoveWord word) {
        int end = word.end();
        if (state.at.isEmpty() || word.part() >= parts.size() || word.offset() < state.at.get(word.part())
                || end > parts.get(word.part()).packed()) {
            return Optional.empty();
        }
        List<Integer> next = new ArrayList<>(state.at);
        for (int i = 0; i < word.part(); i++) {
            next.set(i, parts.get(i).packed());
        }
        next.set(word.part(), end);
        int before = total(state.at);
        if (total(next) - before > word.length() + MoveWord.MOST_DATA) {
            return Optional.empty();
        }
        return scene.where(state.possible, OFFERED).flatMap(sending -> pass(sending, "says D", before, total(next)))
                .map(possible -> new State(possible, state.heard, next));
    }

    /** With so many bytes more, pieces of the model are complete. */
    private Optional<StateSet> pass(StateSet possible, String what, int before, int after) {
        Optional<StateSet> passed = Optional.of(possible);
        for (int piece = pieces(before); piece < pieces(after); piece++) {
            String name = what + piece;
            passed = passed.flatMap(known -> handover.after(scene, known, name));
        }
        return passed;
    }

    // What its host hears

    /** Its board has handed this to its host, or data of another move that has the same part. */
    void hears(MoveWord word, List<Integer> kept) {
        if (word.is('O') && offer == null) {
            offered(word);
        } else if (word.is('O') && !Arrays.equals(word.body(), offer.body())) {
            return;
        }
        unheard.add(new Heard(word, kept));
        if (unheard.size() > MOST_UNHEARD) {
            List<State> later = new ArrayList<>();
            every(state -> {
                if (state.heard > forgotten) {
                    later.add(state);
                }
            });
            if (later.isEmpty()) {
                // It could not go on before it has said something, which has not come to its board.
                states.forEach(state -> later.add(state.heard(state.possible, state.at)));
            }
            set(later);
        }
    }

    private List<State> hear(State state) {
        Heard heard = unheard.get(state.heard - forgotten);
        return isSender ? senderHears(state, heard.word) : receiverHears(state, heard);
    }

    private List<State> senderHears(State state, MoveWord word) {
        List<State> after = new ArrayList<>();
        if (word.is('W')) {
            if (word.offsets().size() == parts.size()) {
                List<Integer> from = new ArrayList<>();
                for (int i = 0; i < parts.size(); i++) {
                    from.add(Math.min(word.offsets().get(i), parts.get(i).packed()));
                }
                String name = "comes W" + Math.min(1, pieces(total(from)));
                scene.where(state.possible, OPEN).flatMap(open -> handover.after(scene, open, name))
                        .ifPresent(possible -> after.add(state.heard(possible, from)));
                scene.where(state.possible, NOT_OPEN)
                        .ifPresent(possible -> after.add(state.heard(possible, state.at)));
            } else {
                after.add(state.heard(state.possible, state.at));
            }
            return after;
        }
        after(state, "comes " + word.type()).ifPresent(next -> after.add(state.heard(next.possible, state.at)));
        if (word.is('R')) {
            // The G that it is saying answers this one as well.
            scene.where(state.possible, GONE).ifPresent(possible -> after.add(state.heard(possible, state.at)));
        }
        return after;
    }

    private List<State> receiverHears(State before, Heard heard) {
        State state = before;
        if (!before.at.isEmpty()) {
            // What it has said may not have come to its board.
            state = before.with(perhaps(before.possible, "says W" + pieces(total(before.at))));
        }
        return switch (heard.word.type()) {
            case 'O' -> receiverIsOffered(state.with(perhaps(state.possible, "says X")), heard.kept);
            case 'D' -> receiverGets(state, heard);
            default -> {
                State known = state;
                yield after(state, "comes " + heard.word.type())
                        .map(next -> List.of(known.heard(next.possible, known.at))).orElse(List.of());
            }
        };
    }

    private StateSet perhaps(StateSet possible, String name) {
        return handover.after(scene, possible, name).map(possible::or).orElse(possible);
    }

    private List<State> receiverIsOffered(State state, List<Integer> kept) {
        List<State> after = new ArrayList<>();
        scene.where(state.possible, NONE).ifPresent(none -> {
            StateSet known = none.after("kept 0").orElseThrow();
            for (int piece = 1; piece <= pieces(total(kept)); piece++) {
                known = known.or(none.after("kept " + piece).orElseThrow());
            }
            handover.after(scene, scene.where(known, NONE).orElse(known), "comes O")
                    .ifPresent(possible -> after.add(state.heard(possible, kept)));
        });
        scene.where(state.possible, SOME).flatMap(some -> handover.after(scene, some, "comes O"))
                .ifPresent(possible -> after.add(state.heard(possible, state.at.isEmpty() ? kept : state.at)));
        return after;
    }

    private List<State> receiverGets(State state, Heard heard) {
        List<State> after = new ArrayList<>();
        scene.where(state.possible, NOT_COMING)
                .ifPresent(possible -> after.add(state.heard(possible, state.at)));
        Optional<StateSet> coming = scene.where(state.possible, COMING);
        if (coming.isEmpty()) {
            return after;
        }
        MoveWord word = heard.word;
        int end = word.end();
        boolean isPart = word.part() < state.at.size();
        if (!isPart || word.offset() > state.at.get(word.part()) || end > parts.get(word.part()).packed()) {
            // It may say at once what it wants, or has said so already.
            int other = pieces(total(state.at)) == 0 ? 1 : 0;
            after.add(state.heard(isPart ? perhaps(coming.get(), "comes D" + other) : coming.get(), state.at));
        } else if (end > state.at.get(word.part())) {
            List<Integer> more = new ArrayList<>(state.at);
            more.set(word.part(), end);
            pass(coming.get(), "comes D", total(state.at), total(more))
                    .ifPresent(possible -> after.add(state.heard(possible, more)));
        } else {
            after.add(state.heard(coming.get(), state.at));
        }
        return after;
    }

    // What else may happen

    /**
     * Its host may have been started again: what it had not heard is lost. What its board had not taken it says again.
     */
    void mayDie() {
        named = null;
        List<State> after = new ArrayList<>(states);
        every(state -> handover.after(scene, state.possible, "dies").ifPresent(
                possible -> after.add(new State(possible, forgotten + unheard.size(), state.at))));
        set(after);
    }

    /** Its agent may be back, by another move. */
    void mayReturn() {
        set(states.stream().map(state -> state.with(perhaps(state.possible, "returns"))).toList());
    }

    /** All was heard in the end. */
    void end() {
        every(state -> {});
    }

    /** Its agent is awake here again. @return whether it may be. */
    boolean isAwake() {
        List<State> after = new ArrayList<>();
        every(state -> scene.where(state.possible, AWAKE).ifPresent(possible -> after.add(state.with(possible))));
        if (after.isEmpty()) {
            return false;
        }
        set(after);
        return true;
    }

    /** In words, what it may say in place of what it must not. */
    String expected(MoveWord wrong) {
        if (wrong.is('O') && !Arrays.equals(wrong.body(), offer.body())) {
            return "the offer that it has made before";
        }
        if (wrong.is('A') && !wrong.agent().isEmpty() && !wrong.agent().equals(named)) {
            return "'" + Bytes.shown(named) + "' as before";
        }
        Set<String> words = new TreeSet<>();
        Set<List<Integer>> places = new LinkedHashSet<>();
        every(state -> {
            state.possible.next().stream().filter(name -> name.startsWith("says "))
                    .forEach(name -> words.add("'" + MoveWord.name(name.charAt("says ".length())) + "'"));
            places.add(state.at);
        });
        String expected = words.isEmpty() ? "nothing" : String.join(" or ", words);
        return wrong.is('D') || wrong.is('W') ? expected + "; of its parts these bytes are there: "
                + places.stream().map(at -> at.isEmpty() ? "none is asked for" : at.toString()).distinct()
                        .collect(Collectors.joining(" or "))
                : expected;
    }

    /** All that may be, whatever of what was handed to its host it has heard. */
    private void every(Consumer<State> use) {
        Collection<State> now = states;
        while (!now.isEmpty()) {
            now.forEach(use);
            now = merged(now.stream().filter(state -> state.heard < forgotten + unheard.size())
                    .flatMap(state -> hear(state).stream()).toList());
        }
    }

    private void set(List<State> possible) {
        states = List.copyOf(merged(possible));
        int least = Collections.min(states.stream().map(State::heard).toList());
        while (forgotten < least) {
            unheard.remove(0);
            forgotten++;
        }
    }

    private static Collection<State> merged(Collection<State> several) {
        Map<List<?>, State> merged = new LinkedHashMap<>();
        several.forEach(state -> merged.merge(List.of(state.heard, state.at), state,
                (one, other) -> one.with(one.possible.or(other.possible))));
        return merged.values();
    }
}
