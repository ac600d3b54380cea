package uppaal.replay;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import uppaal.network.Possible;

/**
 * One message, and what its automata may be doing: of a unicast those of its sender and its addressee; of others the
 * sender's with those of each board that may hear it.
 */
final class Message {
    /** What stands for the addressee of a unicast, whichever board that is. */
    private static final String ADDRESSEE = "";

    final String kind;
    final String origin;
    final String destination;
    /** In hexadecimal digits; of a broadcast empty. */
    final String nonce;
    /** Of a broadcast that fits one packet what it says, in hexadecimal digits; else empty. */
    final String content;
    private final int pieces;
    private final Map<Integer, String> sent = new HashMap<>();
    private final Map<String, Set<Integer>> reached = new HashMap<>();
    private final List<String> history = new ArrayList<>();
    private final Map<String, Possible> scenes = new HashMap<>();

    /** @param whole the frame, or as much of it as its first piece holds */
    Message(Payload whole, int pieces, String content) {
        kind = whole.kind();
        origin = whole.origin();
        destination = whole.destination();
        nonce = isBroadcast() ? "" : whole.nonce();
        this.content = content;
        this.pieces = pieces;
        scenes.put(ADDRESSEE, Scenes.first(kind, isUnicast()));
    }

    boolean isUnicast() {
        return kind.equals("unicast");
    }

    boolean isBroadcast() {
        return kind.equals("broadcast");
    }

    /** Whether this is the payload that this piece has had whenever it was sent; the first time, it is. */
    boolean isSame(Payload payload) {
        return sent.computeIfAbsent(payload.index(), index -> payload.identity()).equals(payload.identity());
    }

    /** The sender's board, or who else sends the message, does something. */
    void sender(String step) throws RefusedException {
        for (Map.Entry<String, Possible> scene : scenes.entrySet()) {
            Possible before = scene.getValue();
            String receiver = scene.getKey().isEmpty() ? destination : scene.getKey();
            scene.setValue(before.after(step).orElseThrow(() -> refusal(step, origin, before, receiver)));
        }
        history.add(step);
    }

    /** The sender's board may have done something. */
    void perhaps(String step) {
        scenes.replaceAll((board, possible) -> possible.perhaps(step));
    }

    /** Whether the sender's board may do something now. */
    boolean mayDo(String step) {
        return scenes.values().stream().allMatch(possible -> possible.after(step).isPresent());
    }

    /** Something happens at a board that is not the sender's. */
    void receiver(Station board, String step) throws RefusedException {
        scenes.put(scene(board), at(board).after(step).orElseThrow(() -> refusal(board, step)));
    }

    /** Something may have happened there. */
    void perhaps(Station board, String step) {
        scenes.put(scene(board), at(board).perhaps(step));
    }

    /** Whether it may happen there now. */
    boolean mayDo(Station board, String step) {
        return at(board).after(step).isPresent();
    }

    /** Whether a board may take it; of a unicast only the addressee's may. */
    boolean concerns(Station board) {
        return isUnicast() ? board.hasBeen(destination) : !board.hasBeen(origin);
    }

    private String scene(Station board) {
        return isUnicast() ? ADDRESSEE : board.name();
    }

    /** What is known of it and a board. */
    private Possible at(Station board) {
        Possible known = concerns(board) ? scenes.get(scene(board)) : null;
        if (known != null) {
            return known;
        }
        // Of a board whose id is not known yet, all is possible that is of any.
        Possible possible = Scenes.first(kind, !isUnicast() && (!board.isNamed() || board.isConcernedBy(destination)));
        for (String step : history) {
            possible = possible.after(step).orElse(possible);
        }
        return possible;
    }

    /**
     * Of what reaches a board, what that is for the model: {@code inquire}, {@code arrive}, both or nothing. Pieces may
     * come in any order, and be put together with what came before.
     */
    List<String> arrivals(Station board, Payload payload) {
        List<String> steps = new ArrayList<>();
        Set<Integer> here = reached.computeIfAbsent(board.name(), name -> new TreeSet<>());
        here.add(payload.index());
        if (payload.isPiece() && payload.asks() && here.contains(0)) {
            steps.add("inquire");
        }
        if (here.size() == pieces) {
            steps.add("arrive");
        }
        return steps;
    }

    /** A board has forgotten the pieces that it had. */
    void forgetPieces(Station board) {
        if (pieces > 1) {
            reached.remove(board.name());
        }
    }

    /** Why the model refuses something at a board. */
    RefusedException refusal(Station board, String step) {
        return concerns(board) ? refusal(step, board.name(), at(board), board.name())
                : refusal(step, board.name(), scenes.get(ADDRESSEE), destination);
    }

    private RefusedException refusal(String step, String who, Possible possible, String receiver) {
        return new RefusedException(
                Steps.words(step, origin, who) + " (" + this + "); " + expected(possible, receiver));
    }

    private String expected(Possible possible, String receiver) {
        String steps = possible.next().stream().filter(Steps::isBoards).map(step -> Steps.words(step, origin, receiver))
                .sorted()
                .collect(Collectors.joining("; "));
        return steps.isEmpty() ? "nothing more is expected of this message" : "expected one of: " + steps;
    }

    @Override
    public String toString() {
        return origin + " to " + destination + (nonce.isEmpty() ? "" : ", nonce " + nonce);
    }
}
