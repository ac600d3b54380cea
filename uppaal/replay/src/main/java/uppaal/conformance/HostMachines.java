package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import javino.protocol.Address;
import javino.protocol.Bytes;
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
    private static final Map<String, String> OTHERS =
            Map.of("departure", "arrival", "arrival", "departure", "initiator",
                    "responder", "responder", "initiator");
    /** What hosts tell apart, and the models do not. */
    private static final Map<String, List<String>> REFINED = Map.ofEntries(Map.entry("sending", List.of("offered")),
            Map.entry("sent", List.of("offered")), Map.entry("cloned", List.of("gone")),
            Map.entry("asked", List.of("none")), Map.entry("coming", List.of("coming", "none")),
            Map.entry("repeating", List.of("coming", "none")), Map.entry("waking", List.of("here")),
            Map.entry("waiting", List.of("idle")), Map.entry("asking", List.of("open")),
            Map.entry("closing", List.of("done")), Map.entry("closed", List.of("done")),
            Map.entry("answering", List.of("half_open")), Map.entry("answered", List.of("half_open")),
            Map.entry("due", List.of("half_open")));
    private static final Map<String, MachineModel> MODELS = models();
    /** All transitions that a trace can tell: {@code machine: state -> state}. */
    static final Set<String> TRANSITIONS = MODELS.entrySet().stream().flatMap(model -> model.getValue().transitions()
            .stream().map(step -> model.getKey() + ": " + step)).collect(Collectors.toCollection(TreeSet::new));
    private static final String AWAY = "";
    /** Of the id of a move in a body; that of a handshake comes behind as many bytes. */
    private static final int ID = 4;

    private final Map<HostMachine.Key, HostMachine> machines = new BoundedMap<>();
    /** By board, its last address. */
    private final Map<String, String> hosts = new HashMap<>();
    private final Set<String> telling = new HashSet<>();
    /** By a host that has told nothing, what it has said first. */
    private final Map<String, String> untold = new HashMap<>();
    /** By host and hash: how many bytes of a part are there at most. Of what is not here all may be. */
    private final Map<String, Integer> kept = new BoundedMap<>();
    /** By agent, the host where it is awake. */
    private final Map<String, String> awake = new BoundedMap<>();
    private final Set<String> covered = new TreeSet<>();
    private int told;

    private static Map<String, MachineModel> models() {
        Document moves = Model.read("handover.xml");
        Document handshakes = Model.read("handshake.xml");
        return OTHERS.keySet().stream().collect(Collectors.toMap(machine -> machine,
                machine -> new MachineModel((isOfMove(machine) ? moves : handshakes)
                        .template(machine.substring(0, 1).toUpperCase(Locale.ROOT) + machine.substring(1)))));
    }

    private static boolean isOfMove(String machine) {
        return machine.equals("departure") || machine.equals("arrival");
    }

    /** Those that were told. */
    Set<String> covered() {
        return Set.copyOf(covered);
    }

    /** How much was checked. */
    String checked() {
        return told == 0 ? "" : told + " states of hosts";
    }

    private HostMachine machine(HostMachine.Key key) {
        HostMachine machine = machines.get(key);
        machine = machine == null ? new HostMachine(key, MODELS.get(key.machine())) : machine;
        machines.put(key, machine);
        return machine;
    }

    // What a host tells of itself

    void tell(TraceEvent event) throws RefusedException {
        String host = event.text("host");
        String state = event.text("state");
        HostMachine.Key key = new HostMachine.Key(event.text("machine"), host, event.text("peer"), event.text("id"));
        List<String> meant = key.machine().equals("departure") && state.equals("none") ? List.of("over")
                : REFINED.getOrDefault(state, List.of(state));
        if (!hosts.containsValue(host)) {
            return; // of another emulator
        }
        if (key.machine().equals("session")) {
            require(state.equals("none") || hasAgreed(host, key.peer(), "setting", true),
                    host + " tells that its session with " + key.peer() + " is '" + state + "'",
                    "a handshake with it that was 'setting'");
            return;
        }
        require(OTHERS.containsKey(key.machine()), host + " tells of a machine '" + key.machine() + "'",
                "one of " + new TreeSet<>(OTHERS.keySet()));
        require(!telling.add(host) || !untold.containsKey(host),
                untold.get(host), "that it tells first of a machine");
        told++;
        HostMachine machine = machine(key);
        if (key.machine().equals("responder") && state.equals("answering") && machine.is("over")) {
            machine.beginAgain();
        }
        boolean isRecorded =
                key.machine().equals("departure") || key.machine().equals("arrival") && machine.agent.isEmpty();
        Optional<String> from = machine.tell(state, meant, isRecorded, word -> mayHaveSaid(
                new HostMachine.Key(OTHERS.get(key.machine()), key.peer(), host, key.id()), word));
        from.map(before -> key.machine() + ": " + before + " -> " + meant.get(0)).filter(TRANSITIONS::contains)
                .ifPresent(covered::add);
        if (machine.agent.isPresent() && from.isPresent()) {
            follow(machine, machine.agent.get(), from.get(), meant.get(0));
        }
    }

    /** What is sealed nobody else can have said; a message 1 anybody can. */
    private boolean mayHaveSaid(HostMachine.Key key, String word) {
        return word.equals("first") || !telling.contains(key.host())
                || machines.containsKey(key) && machines.get(key).maySay(word);
    }

    private void follow(HostMachine machine, AgentParts agent, String from, String state) throws RefusedException {
        String host = machine.key.host();
        String where = awake.getOrDefault(agent.identity(), AWAY);
        String what = host + " tells that its " + machine.key + " is '" + state + "'";
        require(!state.equals("ready") || agent.isWhole(kept, host),
                what, "it as a whole; of its parts these bytes are there: " + agent.here(kept, host));
        require(!state.equals("here") || agent.isClone() || where.equals(AWAY) || where.equals(host),
                what, agent.identity() + " nowhere else; it is awake at " + where);
        if (!agent.isClone() && (state.equals("here") || state.equals("over") && from.equals("offered"))) {
            awake.put(agent.identity(), host);
        } else if (state.equals("left") && where.equals(host)) {
            awake.remove(agent.identity());
        }
    }

    private boolean hasAgreed(String host, String peer, String state, boolean ever) {
        return machines.values().stream().anyMatch(machine -> machine.key.host().equals(host)
                && machine.key.peer().equals(peer) && (ever ? machine.was(state) : machine.is(state)));
    }

    /** A board has a session key: a handshake with that device must be about to give it. */
    void give(TraceEvent event) throws RefusedException {
        String host = hosts.getOrDefault(event.board(), "");
        require(!event.text("step").equals("session") || !telling.contains(host)
                || hasAgreed(host, event.text("address"), "setting", false),
                event.board() + " has a session key for " + event.text("address"),
                "a handshake with it that is 'setting'");
    }

    /** A board says hello, perhaps to a host that has been started again. */
    void greet(TraceEvent event) {
        hosts.put(event.board(), event.text("id"));
        machines.values().stream().filter(machine -> machine.key.host().equals(event.text("id")))
                .forEach(HostMachine::restart);
    }

    // What hosts say

    /** A host wants a message to be sent. */
    void say(TraceEvent event) throws RefusedException {
        String host = hosts.getOrDefault(event.board(), "");
        Bytes said = Bytes.copyOf(event.said().orElse(new byte[0]));
        Optional<HostMessage> message = message(said);
        require(message.isPresent() || !HostMessage.isHostMessage(said) || !telling.contains(host),
                event.board() + "'s host says what is no host message", "one as in SPEC 3.1");
        String word = message.map(HostMachines::word).orElse("");
        if (word.isEmpty()) {
            return;
        }
        boolean isMove = message.get().kind().use() == Use.MOVE;
        String to = message.get().to().map(Address::toString).orElse(event.text("destination"));
        String what = event.board() + "'s host says '" + word + "' to " + to;
        if (!telling.contains(host)) {
            untold.putIfAbsent(host, what);
            return;
        }
        require(isMove != event.text("destination").startsWith("//"),
                what, "it " + (isMove ? "to one device alone" : "in a broadcast"));
        List<HostMachine> able = machines(host, to, message.get(), true);
        what += able.isEmpty() ? "" : " of " + able.get(able.size() - 1).key;
        Set<String> words = new TreeSet<>();
        able.forEach(machine -> words.addAll(machine.words()));
        require(able.stream().anyMatch(machine -> machine.say(word)), what, "one of " + words);
        String right = isMove ? right(able.get(0), message.get()) : "";
        require(right.isEmpty(), what, right);
    }

    /** What is right in place of the bytes of a message; nothing where they are. */
    private String right(HostMachine machine, HostMessage message) {
        String host = machine.key.host();
        if (message.kind() == Kind.MOVE_OFFER && machine.agent.isEmpty()) {
            return leave(machine, AgentParts.of(message.body()));
        }
        if (message.kind() == Kind.MOVE_AWAKE && !machine.is("none")) {
            String name = message.body().from(ID).hex();
            machine.name = machine.name.or(() -> Optional.of(name));
            return !name.isEmpty() && name.equals(machine.name.get()) ? "" : "a name, and the same as before";
        }
        return machine.agent.map(agent -> switch (message.kind()) {
            case MOVE_OFFER -> agent.isOf(message.body()) ? "" : "the offer that it has made before";
            case MOVE_DATA -> agent.send(message.body()) ? "" : "bytes that were asked for";
            case MOVE_WANT -> agent.want(kept, host, message.body()) ? ""
                    : "less; of its parts these bytes are there: " + agent.here(kept, host);
            default -> "";
        }).orElse("");
    }

    /** An agent is offered for the first time: it must not sleep or be away by another move. */
    private String leave(HostMachine machine, Optional<AgentParts> offered) {
        machine.agent = offered;
        if (offered.isEmpty()) {
            return "an offer as in SPEC 9.1";
        }
        String identity = offered.get().identity();
        offered.get().has(kept, machine.key.host());
        boolean isAway = AWAY.equals(awake.get(identity));
        if (!offered.get().isClone()) {
            awake.put(identity, AWAY);
        }
        return isAway ? "none of " + identity + ", which sleeps or is away by another move" : "";
    }

    /** A board hands a message to its host. */
    void hear(TraceEvent event) {
        String host = hosts.getOrDefault(event.board(), "");
        message(Bytes.copyOf(event.said().orElse(new byte[0]))).filter(message -> !word(message).isEmpty()
                && event.text("destination").equals(message.to().isPresent() ? Address.BROADCAST.toString() : host)
                && message.to().map(Address::toString).orElse(host).equals(host))
                .ifPresent(message -> machines(host, event.text("origin"), message, false)
                        .forEach(machine -> hear(machine, message)));
    }

    private void hear(HostMachine machine, HostMessage message) {
        machine.hear(word(message), message.fragment(), message.kind().fragments());
        switch (message.kind()) {
            case MOVE_OFFER -> machine.agent = machine.agent.or(() -> AgentParts.of(message.body()));
            case MOVE_WANT -> machine.agent.ifPresent(agent -> agent.wanted(message.body()));
            case MOVE_DATA -> machine.agent.ifPresent(agent -> agent.come(kept, machine.key.host(), message.body()));
            default -> {}
        }
    }

    // Messages

    private static Optional<HostMessage> message(Bytes said) {
        try {
            return Optional.of(HostMessage.decode(said));
        } catch (ProtocolException none) {
            return Optional.empty();
        }
    }

    /** What the models call a message; empty where they do not speak of it. */
    private static String word(HostMessage message) {
        return switch (message.kind()) {
            case MESSAGE_1, RENEWAL_1 -> "first";
            case MESSAGE_2, RENEWAL_2 -> "second";
            case MESSAGE_3, RENEWAL_3 -> "third";
            case WANT, GROUP, CONTENT, SEQUENCES, REVOCATION_LIST, GROUP_KEY -> "";
            default -> message.kind().name().substring("MOVE_".length()).toLowerCase(Locale.ROOT);
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
        if (isOfMove(name) || word(message).equals("first")) {
            int at = isOfMove(name) ? 0 : ID;
            return message.body().length() < at + ID ? List.of() : List.of(machine(
                    new HostMachine.Key(name, host, peer, message.body().slice(at, at + ID).hex())));
        }
        return machines.values().stream().filter(machine -> machine.key.machine().equals(name)
                && machine.key.host().equals(host) && machine.key.peer().equals(peer)).toList();
    }
}
