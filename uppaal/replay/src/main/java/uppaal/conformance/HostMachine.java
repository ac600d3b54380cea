package uppaal.conformance;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** One machine of a host, by what its host tells of it, says and was handed. */
final class HostMachine {
    /** Which one it is. */
    record Key(String machine, String host, String peer, String id) {
        @Override
        public String toString() {
            return machine + " " + id + " with " + peer;
        }
    }

    final Key key;
    private final MachineModel model;
    /**
     * Where it was since what was said last: a host may tell of its next state before its board takes what it has said
     * before. Each time it may have been in any of some states, as nobody tells that a host was killed.
     */
    private final List<Set<String>> states = new ArrayList<>();
    /** Where it was ever. */
    private final Set<String> been = new HashSet<>();
    private final Set<String> came = new HashSet<>();
    /** Where it may have been when its host was killed, until it tells of a state. */
    private Set<String> killed = Set.of();
    private boolean isKnown;
    /** What its agent is called here, as the host has said since it was started. */
    Optional<String> name = Optional.empty();
    /** The agent that moves; nothing where that is not known. */
    Optional<AgentParts> agent = Optional.empty();

    HostMachine(Key key, MachineModel model) {
        this.key = key;
        this.model = model;
        states.add(Set.of(model.initial()));
        been.add(model.initial());
    }

    private boolean isClone() {
        return agent.filter(AgentParts::isClone).isPresent();
    }

    private Set<String> now() {
        return states.get(states.size() - 1);
    }

    /** Whether it may be there now. */
    boolean is(String state) {
        return now().contains(state);
    }

    /** Whether it may ever have been there. */
    boolean was(String state) {
        return been.contains(state);
    }

    /** Whether it may have said that. */
    boolean maySay(String word) {
        return been.stream().anyMatch(state -> model.says(state, any -> true).contains(word));
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
     * @param isRecorded whether it may have begun before the trace did
     * @param proved whether the other side may have said a word
     * @return from where it came; nothing where it stays, or that is not known
     */
    Optional<String> tell(String told, List<String> meant, boolean isRecorded, Predicate<String> proved)
            throws RefusedException {
        Predicate<String> known = word -> came.contains(word) && proved.test(word);
        Set<String> able = meant.stream().filter(state -> is(state) || isRecorded && !isKnown && model.isRecorded(state)
                || now().stream().anyMatch(from -> model.leads(from, state, isClone(), known)))
                .collect(Collectors.toSet());
        if (able.isEmpty()) {
            throw new RefusedException(key.host() + " tells that its " + key + " is '" + told + "'",
                    now().stream().sorted().map(before -> "'" + before + "', or from there "
                            + model.expected(before, isClone())).collect(Collectors.joining("; or ")));
        }
        Optional<String> from = (now().containsAll(able) ? killed : now()).stream()
                .filter(before -> !before.equals(meant.get(0))
                        && model.leads(before, meant.get(0), isClone(), known))
                .findFirst();
        killed = Set.of();
        if (now().containsAll(able)) {
            states.remove(states.size() - 1);
        }
        states.add(able);
        been.addAll(able);
        isKnown = true;
        return from;
    }

    /** Its host says a word. @return whether it may. */
    boolean say(String word) {
        isKnown = true;
        for (int i = 0; i < states.size(); i++) {
            Set<String> able = states.get(i).stream()
                    .filter(state -> model.says(state, came::contains).contains(word)).collect(Collectors.toSet());
            if (!able.isEmpty()) {
                states.set(i, able);
                states.subList(0, i).clear();
                return true;
            }
        }
        return false;
    }

    /** It was over, and answers a message 1 that has come again: what the model calls its next answer. */
    void beginAgain() {
        states.clear();
        states.add(Set.of(model.initial()));
        came.removeIf(word -> word.startsWith("third"));
    }

    /** What its host may say. */
    Set<String> words() {
        return states.stream().flatMap(Set::stream).flatMap(state -> model.says(state, came::contains).stream())
                .collect(Collectors.toCollection(TreeSet::new));
    }

    /** Its host may have been killed and started again. */
    void restart() {
        killed = now();
        Set<String> after = now().stream().flatMap(state -> model.killed(state, isClone(), came::contains).stream())
                .collect(Collectors.toSet());
        states.set(states.size() - 1, after);
        been.addAll(after);
        name = Optional.empty();
    }
}
