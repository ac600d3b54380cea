package uppaal.replay;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
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
        /** The other side's. */
        Key other() {
            return new Key(HostMachines.OTHERS.get(machine), peer, host, id);
        }

        @Override
        public String toString() {
            return machine + " " + id + " with " + peer;
        }
    }

    /**
     * Where it was.
     *
     * @param states of which it may have been in any: nobody tells that a host was killed
     * @param once what it says when it comes there
     */
    private record Stay(Set<String> states, Set<String> once) {}

    final Key key;
    private final MachineModel model;
    /** Since what was said last: a host may tell of its next state before its board takes what it has said before. */
    private final List<Stay> stays = new ArrayList<>();
    /** Where it was ever. */
    private final Set<String> been = new HashSet<>();
    /** How often a word came and nothing has followed from it yet. */
    private final Map<String, Integer> came = new HashMap<>();
    private boolean known;
    /** What its agent is called here, as the host has said; empty where it has not since it was started. */
    private String name = "";
    /** The agent that moves; nothing where that is not known. */
    Optional<AgentParts> agent = Optional.empty();

    HostMachine(Key key, MachineModel model) {
        this.key = key;
        this.model = model;
        stays.add(new Stay(Set.of(model.initial()), Set.of()));
        been.add(model.initial());
    }

    private boolean isClone() {
        return agent.filter(AgentParts::isClone).isPresent();
    }

    private Stay now() {
        return stays.get(stays.size() - 1);
    }

    /** Whether it may be there now. */
    boolean is(String state) {
        return now().states.contains(state);
    }

    /** Whether it may have said that. */
    boolean maySay(String word) {
        return been.stream().anyMatch(state -> model.saysOnce(state).contains(word)
                || model.says(state, any -> true).containsKey(word));
    }

    /** The host was handed a fragment of a word; where it has all, it has the word. */
    void hear(String word, int fragment, int fragments) {
        came.merge(word + fragment, 1, Integer::sum);
        if (IntStream.range(0, fragments).allMatch(part -> came.containsKey(word + part))) {
            came.merge(word, 1, Integer::sum);
        }
    }

    private boolean hasCome(String word) {
        return came.getOrDefault(word, 0) > 0;
    }

    private void use(Set<String> words) {
        words.forEach(word -> came.merge(word, -1, Integer::sum));
    }

    /**
     * Its host tells where it is.
     *
     * @param isRecorded whether it may have begun before the trace did
     * @param proved whether the other side may have said a word
     * @return the transition; nothing where it stays
     */
    Optional<String> tell(String state, boolean isRecorded, Predicate<String> proved) throws RefusedException {
        boolean isOld = isRecorded && !known && model.isRecorded(state);
        known = true;
        been.add(state);
        if (is(state)) {
            stays.set(stays.size() - 1, new Stay(Set.of(state), now().once));
            return Optional.empty();
        }
        for (String from : now().states) {
            Optional<Set<String>> needs =
                    model.needs(from, state, isClone(), word -> hasCome(word) && proved.test(word));
            if (needs.isPresent()) {
                use(needs.get());
                stays.add(new Stay(Set.of(state), model.saysOnce(state)));
                return Optional.of(MachineModel.transition(from, state));
            }
        }
        if (!isOld) {
            throw new RefusedException(key.host() + " tells that its " + key + " is '" + state + "'; expected "
                    + now().states.stream().sorted().map(from -> "'" + from + "', or from there "
                            + model.expected(from, isClone())).collect(Collectors.joining("; or ")));
        }
        stays.add(new Stay(Set.of(state), model.saysOnce(state)));
        return Optional.empty();
    }

    /** Its host says a word. @return whether it may. */
    boolean say(String word) {
        known = true;
        for (int i = 0; i < stays.size(); i++) {
            Stay stay = stays.get(i);
            boolean isFirst = stay.once.contains(word);
            Set<String> able = stay.states.stream()
                    .filter(state -> isFirst && model.saysOnce(state).contains(word)
                            || model.says(state, this::hasCome).containsKey(word))
                    .collect(Collectors.toSet());
            if (!able.isEmpty()) {
                if (!isFirst) {
                    use(model.says(able.iterator().next(), this::hasCome).get(word));
                }
                Set<String> rest = new HashSet<>(stay.once);
                if (!model.repeats()) {
                    rest.remove(word);
                }
                stays.set(i, new Stay(able, rest));
                stays.subList(0, i).clear();
                return true;
            }
        }
        return false;
    }

    /** Whether it was there when it said its last word. */
    boolean saidIn(String state) {
        return stays.get(0).states.contains(state);
    }

    /** What its host may say. */
    Set<String> words() {
        Set<String> words = new TreeSet<>();
        for (Stay stay : stays) {
            words.addAll(stay.once);
            stay.states.forEach(state -> words.addAll(model.says(state, this::hasCome).keySet()));
        }
        return words;
    }

    /** Its host says what its agent is called. @return what it was called before; the same where it was not. */
    String call(String called) {
        name = name.isEmpty() ? called : name;
        return name;
    }

    /** Its host may have been killed and started again. */
    void restart() {
        Set<String> after = now().states.stream().flatMap(state -> model.killed(state, isClone()).stream())
                .collect(Collectors.toSet());
        stays.set(stays.size() - 1, new Stay(after, now().once));
        been.addAll(after);
        name = "";
    }
}
