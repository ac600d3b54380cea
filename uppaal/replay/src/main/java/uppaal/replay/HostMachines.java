package uppaal.replay;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import javino.protocol.Address;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.HostMessage.Use;
import javino.protocol.ProtocolException;
import trace.TraceEvent;
import uppaal.document.Document;

/**
 * Holds the machines of hosts to {@code handover.xml} and {@code handshake.xml}: each transition that a host tells is a
 * step of its template, behind what the step needs, and each message of a host comes from a state that says it. The two
 * sides of a move or a handshake have one id. Hosts that tell nothing may say anything.
 */
final class HostMachines {
    /** On the other side. */
    static final Map<String, String> OTHERS = Map.of("departure", "arrival", "arrival", "departure", "initiator",
            "responder", "responder", "initiator");
    private static final String AWAY = "";
    private static final int ID_AT = 4;
    private static final Map<String, MachineModel> MODELS = models();

    private final Map<HostMachine.Key, HostMachine> machines = new Recent<>();
    /** By board, its last address. */
    private final Map<String, String> hosts = new HashMap<>();
    private final Set<String> telling = new HashSet<>();
    /** By a host that has told nothing, what it has said first. */
    private final Map<String, String> untold = new HashMap<>();
    /** By host and hash: how many bytes of a part are there at most. Of what is not here all may be. */
    private final Map<String, Integer> kept = new Recent<>();
    /** By agent, the host where it is awake. */
    private final Map<String, String> awake = new Recent<>();
    private final Set<String> covered = new TreeSet<>();
    private int told;

    private static Map<String, MachineModel> models() {
        Document moves = Scenes.model("handover.xml");
        Document handshakes = Scenes.model("handshake.xml");
        Map<String, MachineModel> models = new HashMap<>();
        for (String machine : OTHERS.keySet()) {
            Document model = isOfMove(machine) ? moves : handshakes;
            models.put(machine, new MachineModel(model,
                    machine.substring(0, 1).toUpperCase(Locale.ROOT) + machine.substring(1)));
        }
        return models;
    }

    private static boolean isOfMove(String machine) {
        return machine.equals("departure") || machine.equals("arrival");
    }

    /** All transitions that a trace can tell: {@code machine: state -> state}. */
    static Set<String> transitions() {
        Set<String> all = new TreeSet<>();
        MODELS.forEach((machine, model) -> model.transitions().forEach(step -> all.add(machine + ": " + step)));
        return all;
    }

    /** Those that were told. */
    Set<String> covered() {
        return Set.copyOf(covered);
    }

    /** How much was checked. */
    String checked() {
        return told == 0 ? "" : ", " + told + " states of hosts";
    }

    private HostMachine machine(HostMachine.Key key) {
        HostMachine machine = machines.get(key);
        machine = machine == null ? new HostMachine(key, MODELS.get(key.machine())) : machine;
        machines.put(key, machine);
        return machine;
    }

    // What a host tells of itself

    void tell(TraceEvent event) throws RefusedException {
        HostMachine.Key key = new HostMachine.Key(event.text("machine"), event.text("host"), event.text("peer"),
                event.text("id"));
        if (!hosts.containsValue(key.host())) {
            return; // of another emulator
        }
        if (!OTHERS.containsKey(key.machine())) {
            throw new RefusedException(key.host() + " tells of a machine '" + key.machine() + "'; expected one of "
                    + new TreeSet<>(OTHERS.keySet()));
        }
        if (telling.add(key.host()) && untold.containsKey(key.host())) {
            throw new RefusedException(untold.get(key.host()) + "; expected that it tells first of a machine");
        }
        told++;
        HostMachine machine = machine(key);
        boolean slept = machine.is("offered");
        boolean isRecorded = isOfMove(key.machine())
                && (key.machine().equals("departure") || machine.agent.isEmpty());
        Optional<String> transition =
                machine.tell(event.text("state"), isRecorded, word -> mayHaveSaid(key.other(), word));
        transition.map(step -> key.machine() + ": " + step).filter(transitions()::contains).ifPresent(covered::add);
        if (transition.isPresent() && machine.agent.isPresent()) {
            follow(machine, machine.agent.get(), event.text("state"), slept);
        }
    }

    /** What is sealed nobody else can have said; a message 1 anybody can. */
    private boolean mayHaveSaid(HostMachine.Key key, String word) {
        return word.equals("first") || !telling.contains(key.host())
                || machines.containsKey(key) && machines.get(key).maySay(word);
    }

    private void follow(HostMachine machine, AgentParts agent, String state, boolean slept) throws RefusedException {
        String host = machine.key.host();
        String what = host + " tells that its " + machine.key + " is '" + state + "'; expected ";
        if (state.equals("ready") && !agent.isWhole(kept, host)) {
            throw new RefusedException(what + "it as a whole; of its parts these bytes are there: "
                    + agent.here(kept, host));
        }
        if (agent.isClone()) {
            return;
        }
        String where = awake.getOrDefault(agent.identity(), AWAY);
        if (state.equals("here") && !where.equals(AWAY) && !where.equals(host)) {
            throw new RefusedException(what + agent.identity() + " nowhere else; it is awake at " + where);
        }
        if (state.equals("here") || state.equals("over") && slept) {
            awake.put(agent.identity(), host);
        } else if (state.equals("left") && where.equals(host)) {
            awake.remove(agent.identity());
        }
    }

    /** A board has a session key: a handshake with that device must be about to give it. */
    void give(TraceEvent event) throws RefusedException {
        String host = hosts.getOrDefault(event.board(), "");
        if (event.text("step").equals("session") && telling.contains(host) && machines.values().stream()
                .noneMatch(machine -> machine.key.host().equals(host)
                        && machine.key.peer().equals(event.text("address")) && machine.is("setting"))) {
            throw new RefusedException(event.board() + " has a session key for " + event.text("address")
                    + "; expected a handshake with it that is 'setting'");
        }
    }

    /** A board says hello, perhaps to a host that has been started again. */
    void greet(TraceEvent event) {
        String host = event.text("id");
        hosts.put(event.board(), host);
        machines.values().stream().filter(machine -> machine.key.host().equals(host)).forEach(HostMachine::restart);
    }

    // What hosts say

    /** A host wants a message to be sent. */
    void say(TraceEvent event) throws RefusedException {
        String host = hosts.getOrDefault(event.board(), "");
        Optional<byte[]> said = event.said().filter(bytes -> HostMessage.isHostMessage(
                javino.protocol.Bytes.copyOf(bytes)));
        if (said.isEmpty()) {
            return;
        }
        String what = event.board() + "'s host says ";
        HostMessage message;
        try {
            message = HostMessage.decode(javino.protocol.Bytes.copyOf(said.get()));
        } catch (ProtocolException wrong) {
            require(host, what + "what is no host message: " + wrong.getMessage());
            return;
        }
        String word = word(message.kind());
        if (word.isEmpty()) {
            return;
        }
        boolean isMove = message.kind().use() == Use.MOVE;
        String to = isMove ? event.text("destination") : message.to().map(Address::toString).orElse("");
        what += "'" + word + "' to " + to;
        if (isMove == event.text("destination").startsWith("//")) {
            require(host, what + "; expected it " + (isMove ? "to one device alone" : "in a broadcast"));
        } else if (!telling.contains(host)) {
            untold.putIfAbsent(host, what);
        } else {
            say(host, to, word, message, what);
        }
    }

    private void require(String host, String wrong) throws RefusedException {
        if (telling.contains(host)) {
            throw new RefusedException(wrong);
        }
    }

    private void say(String host, String to, String word, HostMessage message, String what) throws RefusedException {
        List<HostMachine> able = machines(host, to, message, true);
        Set<String> words = new TreeSet<>();
        able.forEach(machine -> words.addAll(machine.words()));
        if (able.stream().noneMatch(machine -> machine.say(word))) {
            throw new RefusedException(what + of(able) + "; expected "
                    + (words.isEmpty() ? "nothing" : "one of " + words));
        }
        if (message.kind().use() == Use.MOVE) {
            HostMachine machine = able.get(0);
            String wrong = wrong(machine, message);
            if (!wrong.isEmpty()) {
                throw new RefusedException(what + of(able) + "; expected " + wrong);
            }
        }
    }

    private static String of(List<HostMachine> machines) {
        return machines.isEmpty() ? "" : " of " + machines.get(machines.size() - 1).key;
    }

    /** What is expected in place of the bytes of a message; nothing where they are right. */
    private String wrong(HostMachine machine, HostMessage message) {
        String host = machine.key.host();
        AgentParts agent = machine.agent.orElse(null);
        return switch (message.kind()) {
            case MOVE_OFFER -> agent == null ? leave(machine, AgentParts.of(message.body()))
                    : agent.isOf(message.body()) ? "" : "the offer that it has made before";
            case MOVE_AWAKE -> {
                String name = message.body().from(ID_AT).hex();
                String before = machine.saidIn("none") ? "" : machine.call(name);
                yield name.equals(before) && name.isEmpty() == machine.saidIn("none") ? ""
                        : machine.saidIn("none") ? "no name" : "a name, and the same as before";
            }
            case MOVE_DATA -> agent == null || agent.send(message.body()) ? "" : "bytes that were asked for";
            case MOVE_WANT -> agent == null || agent.want(kept, host, message.body()) ? ""
                    : "less; of its parts these bytes are there: " + agent.here(kept, host);
            default -> "";
        };
    }

    /** An agent is offered for the first time: it must not sleep or be away by another move. */
    private String leave(HostMachine machine, Optional<AgentParts> offered) {
        machine.agent = offered;
        if (offered.isEmpty()) {
            return "an offer as in SPEC 9.1";
        }
        AgentParts agent = offered.get();
        agent.isOf(kept, machine.key.host());
        if (AWAY.equals(awake.get(agent.identity()))) {
            return "none of " + agent.identity() + ", which sleeps or is away by another move";
        }
        if (!agent.isClone()) {
            awake.put(agent.identity(), AWAY);
        }
        return "";
    }

    /** A board hands a message to its host. */
    void hear(TraceEvent event) {
        HostMessage message;
        try {
            message = HostMessage.decode(javino.protocol.Bytes.copyOf(event.said().orElse(new byte[0])));
        } catch (ProtocolException none) {
            return;
        }
        String host = hosts.getOrDefault(event.board(), "");
        boolean isBroadcast = event.text("destination").equals(Address.BROADCAST.toString());
        boolean isMine = message.to().map(to -> isBroadcast && to.toString().equals(host))
                .orElse(event.text("destination").equals(host));
        String word = word(message.kind());
        if (isMine && !word.isEmpty()) {
            machines(host, event.text("origin"), message, false).forEach(machine -> hear(machine, word, message));
        }
    }

    private void hear(HostMachine machine, String word, HostMessage message) {
        machine.hear(word, message.fragment(), message.kind().fragments());
        Consumer<AgentParts> step = switch (message.kind()) {
            case MOVE_WANT -> agent -> agent.wanted(message.body());
            case MOVE_DATA -> agent -> agent.come(kept, machine.key.host(), message.body());
            default -> agent -> {};
        };
        machine.agent.ifPresent(step);
        if (message.kind() == Kind.MOVE_OFFER && machine.agent.isEmpty()) {
            machine.agent = AgentParts.of(message.body());
        }
    }

    // Which machines

    /** What the models call a message; empty where they do not speak of it. */
    private static String word(Kind kind) {
        return switch (kind) {
            case MESSAGE_1, RENEWAL_1 -> "first";
            case MESSAGE_2, RENEWAL_2 -> "second";
            case MESSAGE_3, RENEWAL_3 -> "third";
            case MOVE_OFFER, MOVE_WANT, MOVE_DATA, MOVE_READY, MOVE_GO, MOVE_AWAKE, MOVE_CANCELLED, MOVE_REFUSED ->
                kind.name().substring("MOVE_".length()).toLowerCase(Locale.ROOT);
            case WANT, GROUP, CONTENT, SEQUENCES, REVOCATION_LIST, GROUP_KEY -> "";
        };
    }

    /** Those of a host that may have said a message, or that it may be for. Only a first one has the handshake's id. */
    private List<HostMachine> machines(String host, String peer, HostMessage message, boolean said) {
        String sender = switch (message.kind()) {
            case MOVE_OFFER, MOVE_DATA, MOVE_GO, MOVE_CANCELLED -> "departure";
            case MOVE_WANT, MOVE_READY, MOVE_AWAKE, MOVE_REFUSED -> "arrival";
            case MESSAGE_2, RENEWAL_2 -> "responder";
            default -> "initiator";
        };
        String name = said ? sender : OTHERS.get(sender);
        boolean isMove = isOfMove(name);
        if (isMove || word(message.kind()).equals("first")) {
            int at = isMove ? 0 : ID_AT;
            return message.body().length() < at + ID_AT ? List.of()
                    : List.of(machine(new HostMachine.Key(name, host, peer,
                            message.body().slice(at, at + ID_AT).hex())));
        }
        return machines.values().stream().filter(machine -> machine.key.machine().equals(name)
                && machine.key.host().equals(host) && machine.key.peer().equals(peer)).toList();
    }
}
