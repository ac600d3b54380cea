package uppaal.conformance;

import static java.util.Map.entry;
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
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.HostMessage.Use;
import javino.protocol.ProtocolException;
import trace.TraceEvent;

/**
 * Holds the machines of hosts to {@code handover.xml} and {@code handshake.xml}: each transition that a host tells is a
 * step of its template, behind what the step needs, and each message of a host comes from a state that says it. The two
 * sides of a move or a handshake have one id. Hosts that tell nothing may say anything.
 */
final class HostMachines implements Check {
    private static final Map<String, String> OTHERS = Map.of("departure", "arrival", "arrival", "departure",
            "initiator", "responder", "responder", "initiator");
    private static final Set<String> OF_MOVES = Set.of("departure", "arrival");
    /** The states that hosts tell apart, and the models do not. */
    private static final Map<String, String> REFINED = Map.ofEntries(entry("sending", "offered"),
            entry("sent", "offered"), entry("cloned", "gone"), entry("asked", "none"), entry("coming", "coming none"),
            entry("repeating", "coming none"), entry("waking", "here"), entry("waiting", "idle"),
            entry("asking", "open"), entry("closing", "done"), entry("closed", "done"), entry("due", "half_open"),
            entry("answering", "half_open"), entry("answered", "half_open"));
    private static final Map<String, MachineModel> MODELS =
            OTHERS.keySet().stream().collect(Collectors.toMap(machine -> machine, HostMachines::model));
    /** All transitions that a trace can tell: {@code machine: state -> state}. */
    static final Set<String> TRANSITIONS = MODELS.keySet().stream().flatMap(machine -> MODELS.get(machine).transitions()
            .map(step -> machine + ": " + step)).collect(Collectors.toCollection(TreeSet::new));
    private static final String AWAY = "";
    /** The length of a move's id in a body; that of a handshake comes behind as many bytes. */
    private static final int ID = 4;

    private final Map<HostMachine.Key, HostMachine> machines = new BoundedMap<>();
    /** By board, its last address. */
    private final Map<String, String> hosts = new HashMap<>();
    private final Set<String> telling = new HashSet<>();
    /** By a host that has told nothing, what it has said first. */
    private final Map<String, String> untold = new HashMap<>();
    /** The count of {@link AgentParts}. */
    private final Map<String, Integer> kept = new BoundedMap<>();
    /** By agent, the host where it is awake. */
    private final Map<String, String> awake = new BoundedMap<>();
    private final Set<String> covered = new TreeSet<>();
    private int told;

    HostMachines(Header header) {}

    private static MachineModel model(String machine) {
        String template = machine.substring(0, 1).toUpperCase(Locale.ROOT) + machine.substring(1);
        return new MachineModel(
                Model.read(OF_MOVES.contains(machine) ? "handover.xml" : "handshake.xml").template(template));
    }

    @Override
    public Set<String> covered() {
        return covered;
    }

    @Override
    public String checked() {
        return told == 0 ? "" : told + " states of hosts";
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        String host = hosts.getOrDefault(event.board(), "");
        switch (event.name()) {
            case "host-id" -> {
                hosts.put(event.board(), event.text("id")); // perhaps of a host that has been started again
                machines.values().stream().filter(machine -> machine.key.host().equals(event.text("id")))
                        .forEach(HostMachine::restart);
            }
            case "host-key" -> require(!event.text("step").equals("session") || !telling.contains(host)
                    || machines(host, event.text("address")).anyMatch(machine -> machine.now().contains("setting")),
                    event.board() + " has a session key for " + event.text("address"),
                    "a handshake with it that is 'setting'");
            case "transition" -> tell(event);
            case "host-transmit", "host-handed" -> message(host, event);
            default -> {}
        }
    }

    private HostMachine machine(HostMachine.Key key) {
        HostMachine machine = machines.containsKey(key) ? machines.get(key)
                : new HostMachine(key, MODELS.get(key.machine()), OF_MOVES.contains(key.machine()));
        machines.put(key, machine);
        return machine;
    }

    private Stream<HostMachine> machines(String host, String peer) {
        return machines.values().stream().filter(machine -> machine.key.host().equals(host)
                && machine.key.peer().equals(peer));
    }

    // The states that a host tells

    private void tell(TraceEvent event) throws RefusedException {
        HostMachine.Key key = new HostMachine.Key(event.text("machine"), event.text("host"), event.text("peer"),
                event.text("id"));
        String host = key.host();
        String state = event.text("state");
        String what = host + " tells that its " + key + " is '" + state + "'";
        if (!hosts.containsValue(host)) {
            return; // of another emulator
        }
        if (key.machine().equals("session")) {
            require(state.equals("none") || machines(host, key.peer()).anyMatch(one -> one.been.contains("setting")),
                    what, "a handshake with it that was 'setting'");
            return;
        }
        require(OTHERS.containsKey(key.machine()), what, "one of " + new TreeSet<>(OTHERS.keySet()));
        require(!telling.add(host) || !untold.containsKey(host), untold.get(host), "that it tells first of a machine");
        told++;
        HostMachine machine = machine(key);
        if (key.machine().equals("responder") && state.equals("answering") && machine.now().contains("over")) {
            machine.beginAgain();
        }
        List<String> meant = List.of((key.machine().equals("departure") && state.equals("none") ? "over"
                : REFINED.getOrDefault(state, state)).split(" "));
        HostMachine.Key other = new HostMachine.Key(OTHERS.get(key.machine()), key.peer(), host, key.id());
        List<String> steps = machine.tell(meant, word -> mayHaveSaid(other, word), what).stream()
                .map(from -> key.machine() + ": " + from + " -> " + meant.get(0)).filter(TRANSITIONS::contains)
                .toList();
        covered.addAll(steps);
        if (machine.agent.isPresent() && !steps.isEmpty()) {
            boolean stays = meant.get(0).equals("here") || steps.contains("departure: offered -> over");
            follow(machine.agent.get(), host, meant.get(0), stays, what);
        }
    }

    /** A sealed message can be of its sender only; a message 1 of anybody. */
    private boolean mayHaveSaid(HostMachine.Key key, String word) {
        return word.equals("first") || !telling.contains(key.host())
                || machines.containsKey(key) && machines.get(key).maySay(word);
    }

    /** @param isAwake whether the agent is awake there now */
    private void follow(AgentParts agent, String host, String state, boolean isAwake, String what)
            throws RefusedException {
        String where = awake.getOrDefault(agent.identity(), AWAY);
        require(!state.equals("ready") || agent.isWhole(), what,
                "it as a whole; of its parts these bytes are there: " + agent.here());
        require(!state.equals("here") || agent.isClone() || where.equals(AWAY) || where.equals(host),
                what, agent.identity() + " nowhere else; it is awake at " + where);
        if (isAwake && !agent.isClone()) {
            awake.put(agent.identity(), host);
        } else if (state.equals("left") && where.equals(host)) {
            awake.remove(agent.identity());
        }
    }

    // The messages of hosts to each other

    /** A host wants a message to be sent, or is handed one. */
    private void message(String host, TraceEvent event) throws RefusedException {
        Bytes message = Bytes.copyOf(event.said().orElse(new byte[0]));
        try {
            message(host, event, HostMessage.decode(message));
        } catch (ProtocolException none) {
            require(!HostMessage.isHostMessage(message) || event.is("host-handed") || !telling.contains(host),
                    event.board() + "'s host says what is no host message", "one as in SPEC 3.1");
        }
    }

    private void message(String host, TraceEvent event, HostMessage message) throws RefusedException {
        String word = word(message);
        String destination = event.text("destination");
        String to = message.to().map(Address::toString).orElse(destination);
        boolean isCast = isMove(message) ? !destination.startsWith("//") : destination.equals(Frame.ALL);
        if (event.is("host-transmit") && !word.isEmpty()) {
            say(host, to, message, isCast, event.board() + "'s host says '" + word + "' to " + to);
        } else if (!word.isEmpty() && isCast && to.equals(host)) {
            String machine = OTHERS.get(speaker(message));
            machines(machine, host, event.text("origin"), message).forEach(each -> hear(each, message));
        }
    }

    private static boolean isMove(HostMessage message) {
        return message.kind().use() == Use.MOVE;
    }

    /** The models' name of a message; empty where they do not have it. */
    private static String word(HostMessage message) {
        return switch (message.kind()) {
            case MESSAGE_1, RENEWAL_1 -> "first";
            case MESSAGE_2, RENEWAL_2 -> "second";
            case MESSAGE_3, RENEWAL_3 -> "third";
            case WANT, GROUP, CONTENT, SEQUENCES, REVOCATION_LIST, GROUP_KEY, GROUP_KEY_REQUEST -> "";
            default -> message.kind().name().substring("MOVE_".length()).toLowerCase(Locale.ROOT);
        };
    }

    /** Which machine says it. */
    private static String speaker(HostMessage message) {
        return MODELS.keySet().stream().filter(machine -> MODELS.get(machine).says(word(message))).findFirst().get();
    }

    /** Those of a host that a message may be of. Of a handshake only the first one has its id. */
    private List<HostMachine> machines(String machine, String host, String peer, HostMessage message) {
        if (isMove(message) || word(message).equals("first")) {
            int at = isMove(message) ? 0 : ID;
            return message.body().length() < at + ID ? List.of() : List.of(machine(
                    new HostMachine.Key(machine, host, peer, message.body().slice(at, at + ID).hex())));
        }
        return machines(host, peer).filter(each -> each.key.machine().equals(machine)).toList();
    }

    private void say(String host, String to, HostMessage message, boolean isCast, String what)
            throws RefusedException {
        if (!telling.contains(host)) {
            untold.putIfAbsent(host, what);
            return;
        }
        require(isCast, what, "it " + (isMove(message) ? "to one device alone" : "in a broadcast"));
        List<HostMachine> able = machines(speaker(message), host, to, message);
        String whose = what + (able.isEmpty() ? "" : " of " + able.get(able.size() - 1).key);
        Set<String> words = able.stream().flatMap(HostMachine::words).collect(Collectors.toCollection(TreeSet::new));
        require(able.stream().anyMatch(machine -> machine.say(word(message))), whose, "one of " + words);
        String right = isMove(message) ? right(able.get(0), message) : "";
        require(right.isEmpty(), whose, right);
    }

    /** The bytes that a message must have, if it has others; else nothing. */
    private String right(HostMachine machine, HostMessage message) {
        Bytes body = message.body();
        if (message.kind() == Kind.MOVE_OFFER && machine.agent.isEmpty()) {
            return leave(machine, body);
        }
        if (message.kind() == Kind.MOVE_AWAKE && !machine.now().contains("none")) {
            String name = body.from(ID).hex();
            machine.name = machine.name.or(() -> Optional.of(name));
            return !name.isEmpty() && name.equals(machine.name.get()) ? "" : "a name, and the same as before";
        }
        return machine.agent.map(agent -> switch (message.kind()) {
            case MOVE_OFFER -> agent.offer.equals(body) ? "" : "the offer that it has made before";
            case MOVE_DATA -> agent.send(body) ? "" : "bytes that were asked for";
            case MOVE_WANT -> agent.want(body) ? "" : "less; of its parts these bytes are there: " + agent.here();
            default -> "";
        }).orElse("");
    }

    /** An agent is offered for the first time: it must not sleep or be away by another move. */
    private String leave(HostMachine machine, Bytes offer) {
        machine.agent = AgentParts.of(offer, machine.key.host(), kept);
        if (machine.agent.isEmpty()) {
            return "an offer as in SPEC 9.1";
        }
        AgentParts agent = machine.agent.get();
        agent.has();
        boolean isAway = AWAY.equals(awake.get(agent.identity()));
        if (!agent.isClone()) {
            awake.put(agent.identity(), AWAY);
        }
        return isAway ? "none of " + agent.identity() + ", which sleeps or is away by another move" : "";
    }

    private void hear(HostMachine machine, HostMessage message) {
        machine.hear(word(message), message.fragment(), message.kind().fragments());
        switch (message.kind()) {
            case MOVE_OFFER -> {
                machine.agent = machine.agent.or(() -> AgentParts.of(message.body(), machine.key.host(), kept));
                machine.mayBeOld &= machine.agent.isEmpty();
            }
            case MOVE_WANT -> machine.agent.ifPresent(agent -> agent.wanted(message.body()));
            case MOVE_DATA -> machine.agent.ifPresent(agent -> agent.come(message.body()));
            default -> {}
        }
    }
}
