package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * A state machine of a host, such as the departure of an agent. The trace tells what its host said and was handed, and
 * now and then its state; in between it may be in any of some states.
 */
final class HostMachine {
    /** A machine's name in traces. */
    record Key(String machine, String host, String peer, String id) {
        @Override
        public String toString() {
            return machine + " " + id + " with " + peer;
        }
    }

    final Key key;
    private final MachineModel model;
    /**
     * The states in which it may have been, one set for each step since its last message. More than the last set is
     * kept, since a host may tell its next state before its board takes the message of the state before. A set has
     * several states, since no trace tells that a host was killed.
     */
    private final List<Set<String>> states = new ArrayList<>();
    /** All states in which it may ever have been. */
    final Set<String> been = new HashSet<>();
    private final Set<String> came = new HashSet<>();
    /** Whether it may have begun before the trace did. */
    boolean mayBeOld;
    /** The name of its agent here, as the host has told since it was started. */
    Optional<String> name = Optional.empty();
    /** The agent that moves; nothing where that is not known. */
    Optional<AgentParts> agent = Optional.empty();

    HostMachine(Key key, MachineModel model, boolean mayBeOld) {
        this.key = key;
        this.model = model;
        this.mayBeOld = mayBeOld;
        enter(Set.of(model.initial));
    }

    private void enter(Set<String> able) {
        states.add(able);
        been.addAll(able);
    }

    /** The states in which it may be now. */
    Set<String> now() {
        return states.get(states.size() - 1);
    }

    /** Whether it may have said that. */
    boolean maySay(String word) {
        return been.stream().flatMap(state -> model.says(state, any -> true)).anyMatch(word::equals);
    }

    /** The host was handed a fragment of a word; where it has all, it has the word. */
    void hear(String word, int fragment, int fragments) {
        came.add(word + fragment);
        if (IntStream.range(0, fragments).allMatch(part -> came.contains(word + part))) {
            came.add(word);
        }
    }

    /**
     * Its host tells where it is.
     *
     * @param meant which of the model's states that may be
     * @param proved whether the other side may have said a word
     * @return from where a step may have led to the first of those
     */
    Set<String> tell(List<String> meant, Predicate<String> proved, String what) throws RefusedException {
        Predicate<String> known = word -> came.contains(word) && proved.test(word);
        Set<String> before = now();
        Set<String> able = new HashSet<>(before);
        before.forEach(from -> able.addAll(model.next(from, known)));
        able.addAll(mayBeOld ? model.recorded : Set.of());
        able.retainAll(meant);
        require(!able.isEmpty(), what,
                before.stream().sorted().map(model::expected).collect(Collectors.joining("; or ")));
        if (before.containsAll(able)) {
            states.remove(states.size() - 1);
            // It may have been there till now, and its board may yet take what it said there.
            Set<String> left = before.stream().filter(from -> !able.contains(from)
                    && model.next(from, known).stream().anyMatch(able::contains)).collect(Collectors.toSet());
            if (!left.isEmpty()) {
                enter(left);
            }
        }
        enter(able);
        mayBeOld = false;
        return before.stream().filter(from -> model.next(from, known).contains(meant.get(0)))
                .collect(Collectors.toSet());
    }

    private Stream<String> says(String state) {
        return model.says(state, came::contains);
    }

    /** Its host says a word. @return whether it may. */
    boolean say(String word) {
        mayBeOld = false;
        for (int i = 0; i < states.size(); i++) {
            Set<String> able = states.get(i).stream().filter(state -> says(state).anyMatch(word::equals))
                    .collect(Collectors.toSet());
            if (!able.isEmpty()) {
                states.subList(0, i).clear();
                states.set(0, able);
                return true;
            }
        }
        return false;
    }

    /** The messages that its host may send. */
    Stream<String> words() {
        return states.stream().flatMap(Set::stream).flatMap(this::says);
    }

    /** It was over, and answers a message 1 that has come again: what the model calls its next answer. */
    void beginAgain() {
        states.clear();
        enter(Set.of(model.initial));
        came.removeIf(word -> word.startsWith("third"));
    }

    /** Its host may have been killed and started again, perhaps behind a step of which it has not told. */
    void restart() {
        Set<String> after = new HashSet<>();
        now().forEach(state -> after.addAll(model.next(state, came::contains)));
        after.retainAll(model.recorded);
        after.addAll(states.remove(states.size() - 1));
        enter(after);
        name = Optional.empty();
    }
}
