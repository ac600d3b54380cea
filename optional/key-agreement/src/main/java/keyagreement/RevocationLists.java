package keyagreement;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.ArrayList;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;

/** Which revocation lists a peer has, and what it is told of the own ones, once under each key. */
final class RevocationLists {

    /** An initiator has said within this time which revocation lists it has, if any; a responder waits for that. */
    private static final long WAIT_MILLIS = 3000;
    private static final int SEQUENCE_LENGTH = 2;

    /** The states of the own report under this key, as SPEC 11.3 has them. */
    enum State {
        SILENT, DUE, SAID
    }

    enum Input {
        FIRST, SECOND, LATE, HEARD, NEWER
    }

    enum Deed {
        NOTHING, SAY
    }

    static final Table<State, Input, Deed> TABLE = Table.of(State.class, Input.class, Deed.class, """
               SILENT   DUE      SAID
        FIRST  SAID:SAY SAID:SAY .:SAY
        SECOND DUE      .        DUE
        LATE   -n       SAID:SAY -n
        HEARD  .        SILENT   .
        NEWER  SAID:SAY SAID:SAY .
        """);

    private final Context context;
    private final Map<Integer, Integer> known = new LinkedHashMap<>();
    private State state = State.SILENT;
    private long deadline;

    RevocationLists(Context context) {
        this.context = context;
    }

    long next() {
        return state == State.DUE ? deadline : Context.NEVER;
    }

    /** Tells what is to be said. */
    List<HostMessage> step(Input input, long now) {
        Table.Cell<State, Deed> cell = TABLE.cell(state, input);
        state = cell.next();
        deadline = input == Input.SECOND ? now + WAIT_MILLIS : deadline;
        Map<Integer, Integer> own = own();
        return switch (cell.deed()) {
            case NOTHING -> List.of();
            case SAY -> own.equals(known) ? List.of() : List.of(new HostMessage(Kind.SEQUENCES, own.entrySet().stream()
                    .map(entry -> Bytes.join(Bytes.of(entry.getKey()),
                            Bytes.ofNumber(entry.getValue(), SEQUENCE_LENGTH)))
                    .reduce(Bytes.EMPTY, Bytes::join)));
        };
    }

    private Map<Integer, Integer> own() {
        return context.identity().revocationLists().stream().collect(
                Collectors.toMap(RevocationList::authority, RevocationList::sequence, (one, next) -> next,
                        LinkedHashMap::new));
    }

    /** The peer's sequences have come. Tells what is to be said. */
    List<HostMessage> heard(Bytes sequences, long now) {
        int length = 1 + SEQUENCE_LENGTH;
        if (sequences.length() % length != 0) {
            context.count(Event.MALFORMED);
            return List.of();
        }
        known.clear();
        sequences.split(length).forEach(each -> known.put(each.at(0), (int) each.number(1, length)));
        Map<Integer, Integer> own = own();
        List<HostMessage> said = new ArrayList<>();
        for (RevocationList list : context.identity().revocationLists()) {
            if (list.sequence() > known.getOrDefault(list.authority(), 0)) {
                known.put(list.authority(), list.sequence());
                said.add(new HostMessage(Kind.REVOCATION_LIST, list.toBytes()));
            }
        }
        boolean newer = known.entrySet().stream()
                .anyMatch(entry -> entry.getValue() > own.getOrDefault(entry.getKey(), 0));
        said.addAll(step(newer ? Input.NEWER : Input.HEARD, now));
        return said;
    }
}
