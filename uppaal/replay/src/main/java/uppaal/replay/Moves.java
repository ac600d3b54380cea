package uppaal.replay;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import trace.TraceEvent;

/**
 * Holds what hosts say to each other of agents that move to the automata of {@code handover.xml} (SPEC 9). It passes
 * between boards and hosts, so the trace has it in the clear; that on the air there is the same is for {@link Bytes}.
 */
final class Moves {
    private final Handover handover;
    private final Map<String, MoveEnd> ends = new Recent<>();
    /** By board and hash: how many bytes of a part are there at most. Of what is not here all may be. */
    private final Map<String, Integer> kept = new Recent<>();
    private int words;

    Moves(Handover handover) {
        this.handover = handover;
    }

    /** How much was checked. */
    String checked() {
        return words == 0 ? "" : ", " + words + " messages of moves";
    }

    /** A host wants a message to be sent. */
    void says(TraceEvent event) throws RefusedException {
        Optional<MoveWord> said = event.said().flatMap(MoveWord::of);
        if (said.isEmpty()) {
            return;
        }
        MoveWord word = said.get();
        String to = event.text("destination");
        String what = event.board() + "'s host says " + word + " of move " + word.move() + " to " + to;
        words++;
        if (to.startsWith("//")) {
            throw new RefusedException(what + "; expected that it says so to one device alone");
        }
        if (!word.isRight()) {
            throw new RefusedException(what + "; expected a message as in SPEC 9.1");
        }
        MoveEnd end = end(event.board(), word.isOfSender(), to, word.move());
        if (word.is('O') && end.offer().isEmpty()) {
            leave(end, word, what);
        }
        if (!end.says(word)) {
            throw new RefusedException(what + "; expected " + end.expected(word));
        }
        if (word.is('O')) {
            word.parts().forEach(part -> kept.remove(event.board() + part.hash()));
        } else if (word.is('W')) {
            keep(end);
        }
    }

    /** An agent is offered. By its earlier moves it must be awake here. */
    private void leave(MoveEnd end, MoveWord offer, String what) throws RefusedException {
        for (MoveEnd other : ends.values()) {
            if (other != end && other.board.equals(end.board) && isOf(other, offer.identity()) && !other.isAwake()) {
                throw new RefusedException(what + "; expected none of '" + Bytes.shown(offer.identity())
                        + "', which has gone by an earlier move");
            }
        }
    }

    private static boolean isOf(MoveEnd end, String agent) {
        return end.isSender && end.offer().filter(offer -> offer.identity().equals(agent)).isPresent();
    }

    /** What a receiver says that it has, it has; and what was handed to it meanwhile. */
    private void keep(MoveEnd end) {
        List<Integer> at = end.atMost();
        for (int i = 0; i < at.size(); i++) {
            kept.put(end.board + end.parts().get(i).hash(), at.get(i));
        }
    }

    /** A board hands a message to its host. What goes to many, a host drops, and what has no such form. */
    void hears(TraceEvent event) {
        Optional<MoveWord> said = event.said().flatMap(MoveWord::of).filter(MoveWord::isRight);
        if (said.isEmpty() || event.text("destination").startsWith("//")) {
            return;
        }
        MoveWord word = said.get();
        MoveEnd end = end(event.board(), !word.isOfSender(), event.text("origin"), word.move());
        end.hears(word, word.is('O') ? kept(event.board(), word.parts()) : List.of());
        if (word.is('D') && word.part() < end.parts().size()) {
            come(end, word);
        } else if (word.is('G')) {
            end.offer().filter(offer -> !offer.isCloning()).ifPresent(offer -> wake(word.move(), offer.identity()));
        }
    }

    private List<Integer> kept(String board, List<MoveWord.Part> parts) {
        return parts.stream()
                .map(part -> Math.min(part.packed(), kept.getOrDefault(board + part.hash(), part.packed())))
                .toList();
    }

    /** An agent may wake, and so be back where it was before, also at another board of the same MAS. */
    private void wake(String move, String agent) {
        ends.values().stream().filter(end -> isOf(end, agent) && !end.move.equals(move)).forEach(MoveEnd::mayReturn);
    }

    /** Bytes of a part have come to a board. Another move may have the same part. */
    private void come(MoveEnd end, MoveWord data) {
        String hash = end.parts().get(data.part()).hash();
        kept.computeIfPresent(end.board + hash,
                (part, bytes) -> data.offset() <= bytes ? Math.max(bytes, data.end()) : bytes);
        for (MoveEnd other : ends.values()) {
            if (other != end && !other.isSender && other.board.equals(end.board)) {
                for (int part = 0; part < other.parts().size(); part++) {
                    if (other.parts().get(part).hash().equals(hash)) {
                        other.hears(data.of(other.move, part), List.of());
                    }
                }
            }
        }
    }

    /** A board says hello, perhaps to a host that has been started again. */
    void greets(TraceEvent event) {
        ends.values().stream().filter(end -> end.board.equals(event.board())).forEach(MoveEnd::mayDie);
    }

    /** The trace has ended. */
    void end() {
        ends.values().forEach(MoveEnd::end);
    }

    private MoveEnd end(String board, boolean isSender, String peer, String move) {
        String key = board + (isSender ? " to " : " from ") + peer + " " + move;
        MoveEnd known = ends.get(key);
        MoveEnd end = known == null ? new MoveEnd(board, isSender, move, handover) : known;
        ends.put(key, end);
        return end;
    }
}
