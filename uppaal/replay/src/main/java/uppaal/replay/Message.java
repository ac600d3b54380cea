package uppaal.replay;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import javino.protocol.Payload;

/**
 * One message, with its ends at the boards.
 */
final class Message {
    /** So long a receiver surely keeps a piece after a new one, in seconds; and nearly always what it told to have. */
    private static final double KEPT = 4;
    private static final double TOLD = 2;
    /** And after so long without another new piece it has forgotten all: 5 s, and some more. */
    static final double FORGOTTEN = 6;

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
    private final Scenes scenes;
    private final Map<String, End> receivers = new HashMap<>();
    private boolean forged;
    /**
     * When it came undamaged to its receiver, which could hear, open and keep it, as long as that has neither handed it
     * on nor answered. In pieces: when one came so that asks, the first one or with all others there.
     */
    private final List<Double> came = new ArrayList<>();
    /** How often an acknowledgement of it came undamaged to its sender, and how often it was told that it is stale. */
    private int confirmed;
    private int stale;
    /** The pieces that its receiver may have, and those of them that it surely has. */
    private final Set<Integer> possible = new HashSet<>();
    private final Set<Integer> kept = new HashSet<>();
    /** When one came last, and one that is surely new. */
    private double lastPiece = Double.NEGATIVE_INFINITY;
    private double renewed = Double.NEGATIVE_INFINITY;
    /** How often in a row its receiver has told to lack a piece that it surely has. */
    private final Map<Integer, Integer> missed = new HashMap<>();
    private boolean doubted;
    /** Whether it was handed on or answered, or was to be. */
    private boolean heeded;
    private boolean goesOn;
    /** What pieces its receiver has told to have, and how often so in a row that came undamaged to its sender. */
    private int have;
    private int lacking;
    /** When a copy of it came undamaged to its sender since that has sent it; infinite where none did. */
    private double copied = Double.NEGATIVE_INFINITY;
    /** Null where a stranger is the sender. */
    private End sender;
    /** The check value of the key that it was sealed with; null where that is not known. */
    private String seal;
    /** Whether it may have been sealed with an earlier key: that was changed before it was on the air. */
    private boolean mayBeOlder;

    /**
     * @param whole the frame, or as much of it as its first piece holds
     * @param scenes those in which its ends are replayed
     */
    Message(Payload whole, int pieces, String content, Scenes scenes) {
        kind = whole.kind().toString();
        origin = whole.origin();
        destination = whole.destination();
        nonce = isBroadcast() ? "" : whole.nonce();
        this.content = content;
        this.pieces = pieces;
        this.scenes = scenes;
    }

    /** Whether a board that has its sender's key now has that with which it was sealed: perhaps an earlier one. */
    boolean isSealedFor(Station board) {
        return seal != null && !mayBeOlder && seal.equals(board.check(isUnicast() ? origin : destination));
    }

    /** Whether its sender's board may have lost the key that it was sealed with, so that it can prove no answer. */
    boolean mayHaveLostItsKey(Station sender) {
        return mayBeOlder || seal != null && !seal.equals(sender.check(destination));
    }

    /** A board of ours is its sender, which has been asked for this. */
    void sentBy(Station board, Transmission asked) {
        seal = board.check(destination);
        mayBeOlder = !Objects.equals(seal, asked.check);
        sender = new End(this, origin, scenes, scenes.sender(kind, pieces > 1), board.ear);
    }

    /** Nobody can have it: an attacker has made it up. */
    void forge() {
        forged = true;
    }

    boolean isForged() {
        return forged;
    }

    boolean isInPieces() {
        return pieces > 1;
    }

    boolean isUnicast() {
        return kind.equals("unicast");
    }

    boolean isBroadcast() {
        return kind.equals("broadcast");
    }

    /** It is sent, or a piece of it. */
    void send(Payload payload) {
        sent.putIfAbsent(payload.index(), payload.identity());
    }

    /** Whether this is the payload that this piece has had when it was sent first. */
    boolean isSame(Payload payload) {
        return sent.getOrDefault(payload.index(), payload.identity()).equals(payload.identity());
    }

    /** The sender's board does something. */
    void sender(double seconds, String step) throws RefusedException {
        if (sender != null) {
            sender.see(seconds, step);
        }
    }

    /** The sender's board may have done something. */
    void perhaps(double seconds, String step) throws RefusedException {
        if (sender != null) {
            sender.perhaps(seconds, step);
        }
    }

    /** Whether the sender's board may do something now. */
    boolean mayDo(double seconds, String step) throws RefusedException {
        return sender == null || sender.may(seconds, step);
    }

    /** Its end at the sender's board; null where that is a stranger's. */
    End sender() {
        return sender;
    }

    /** Its end at a board that is not the sender's. */
    End receiver(Station board) {
        return receivers.computeIfAbsent(board.name(),
                name -> new End(this, board.name(), scenes, scenes.receiver(kind), board.ear));
    }

    /** Whether something of it has come there. */
    boolean hasReached(Station board) {
        return receivers.containsKey(board.name());
    }

    /** Something happens at a board that is not the sender's. */
    void receiver(double seconds, Station board, String step) throws RefusedException {
        if (!isFor(board)) {
            throw new RefusedException(
                    Steps.words(step, origin, board.name()) + " (" + this + "); expected nothing of it there");
        }
        receiver(board).see(seconds, step);
    }

    /** Something may have happened there. */
    void perhaps(double seconds, Station board, String step) throws RefusedException {
        if (isFor(board)) {
            receiver(board).perhaps(seconds, step);
        }
    }

    /** Whether it may happen there now. */
    boolean mayDo(double seconds, Station board, String step) throws RefusedException {
        return isFor(board) && receiver(board).may(seconds, step);
    }

    /** Whether a board may be one of those that it is for; of one whose id is not known yet that is possible. */
    private boolean isFor(Station board) {
        return concerns(board) && (isUnicast() || !board.isNamed() || board.isConcernedBy(destination));
    }

    /** Whether a board may take it; of a unicast only the addressee's may. */
    boolean concerns(Station board) {
        return isUnicast() ? board.hasBeen(destination) : !board.hasBeen(origin);
    }

    /**
     * Of what reaches a board, what that is for the model: {@code inquire}, {@code arrive}, both or nothing. Pieces may
     * come in any order, and be put together with what came before.
     */
    List<String> arrivals(Station board, Payload payload) {
        List<String> steps = new ArrayList<>();
        Set<Integer> here = reached.computeIfAbsent(board.name(), name -> new TreeSet<>());
        here.add(payload.index());
        if (payload.isFragment() && payload.asks() && here.contains(0)) {
            steps.add("question_comes");
        }
        if (isWhole(board) && !forged) {
            steps.add("message_comes");
        }
        return steps;
    }

    /** The same for a forged piece that asks, in the place of any of its own. */
    List<String> arrivals(Station board) {
        return isWhole(board) ? List.of("question_comes", "message_comes") : List.of("question_comes");
    }

    private boolean isWhole(Station board) {
        return reached.getOrDefault(board.name(), Set.of()).size() == pieces;
    }

    /** Whether it, or a piece of it, has come to a board. */
    boolean hasCome(Station board) {
        return reached.containsKey(board.name());
    }

    /** A board has forgotten the pieces that it had. */
    void forgetPieces(Station board) {
        if (pieces > 1) {
            reached.remove(board.name());
        }
    }

    /** It comes, or a piece that asks, undamaged to its receiver, which listens and has key and room. */
    void comes(double seconds) {
        came.add(seconds);
    }

    /** When it has come so, in seconds. */
    List<Double> came() {
        return came;
    }

    /** An acknowledgement of it comes undamaged to its sender. */
    void confirm() {
        confirmed++;
    }

    /** How often one came. */
    int confirmed() {
        return confirmed;
    }

    /** A notice comes undamaged to its sender: its receiver cannot take it any more. */
    void outdate() {
        stale++;
    }

    /** How often one came. */
    int stale() {
        return stale;
    }

    /** Its sender may have heard which of its pieces lack: it goes on, in its turn. */
    void goesOn() {
        goesOn = true;
    }

    /** Its sender makes an attempt. @return whether it may be in the turn of the one before */
    boolean attempts() {
        boolean inTurn = goesOn;
        goesOn = false;
        return inTurn;
    }

    /** A copy of it comes undamaged to its sender; or what came counts no more. */
    void copied(double seconds) {
        copied = seconds;
    }

    /** When one came last, in seconds. */
    double copied() {
        return copied;
    }

    boolean wasCopied() {
        return copied > Double.NEGATIVE_INFINITY;
    }

    /** Of what sort it is: of those one after the other, some are surely heard. */
    String sort() {
        return kind + (pieces > 1 ? " in fragments" : "");
    }

    /** Its receiver hands it on or answers. */
    void heed() {
        came.clear();
        heeded = true;
    }

    /** Whether what comes makes it whole, at a board that has not heeded it; of those in pieces only unicasts count. */
    boolean becomesWhole(Station board, double seconds) {
        if (pieces == 1) {
            return !hasCome(board);
        }
        boolean now = isUnicast() && !heeded && !doubted && isKept(seconds);
        heeded |= now;
        return now;
    }

    /** Whether all its pieces have come so that its receiver has them. */
    boolean isKept(double seconds) {
        return kept.size() == pieces && keeps(seconds);
    }

    /** Whether its receiver surely has its first piece. */
    boolean hasFirst(double seconds) {
        return kept.contains(0) && keeps(seconds);
    }

    private boolean keeps(double seconds) {
        return renewed > seconds - KEPT;
    }

    /**
     * A piece comes to its receiver.
     *
     * @param surely whether undamaged, and there is a place for it; but only new pieces keep the others
     * @return whether it is surely new there
     */
    boolean comes(int piece, boolean surely, double seconds) {
        if (lastPiece < seconds - FORGOTTEN) {
            possible.clear();
            doubted = false;
        }
        if (!keeps(seconds)) {
            kept.clear();
        }
        lastPiece = seconds;
        boolean isNew = possible.add(piece) && surely;
        if (isNew) {
            kept.add(piece);
            renewed = seconds;
        }
        return isNew;
    }

    /** Its receiver tells which pieces it has. @return how often in a row it has lacked one that it keeps */
    int missed(int all, double seconds) {
        Set<Integer> told = new HashSet<>();
        for (int piece = 0; piece < pieces; piece++) {
            if (!isLacking(all, piece)) {
                missed.remove(piece);
                told.add(piece);
            } else if (!doubted && keeps(seconds) && kept.contains(piece)) {
                missed.merge(piece, 1, Integer::sum);
            }
        }
        kept.clear();
        kept.addAll(told);
        renewed = Math.max(renewed, seconds - KEPT + TOLD);
        possible.removeIf(piece -> isLacking(all, piece));
        return missed.values().stream().mapToInt(Integer::intValue).max().orElse(0);
    }

    private static boolean isLacking(int all, int piece) {
        return (all >> piece & 1) == 0;
    }

    /** A piece may be here twice, and one of them forged. */
    void doubtPieces(double seconds) {
        doubted = true;
        lastPiece = seconds;
    }

    /** Whether a piece of it may be forged. */
    boolean isDoubted() {
        return doubted;
    }

    /** An answer comes undamaged to its sender that tells which of its pieces have come. */
    void told(int all) {
        have = all;
        lacking = all == (1 << pieces) - 1 ? 0 : lacking + 1;
    }

    /** Its sender sends a piece. @return how often it was told before that others are lacking */
    int told(Payload piece) {
        lacking = isLacking(have, piece.index()) ? 0 : lacking;
        return lacking;
    }

    /** What its ends have heard need not count any more: a board was reset, or its keys are others. */
    void forgetHeard() {
        came.clear();
        confirmed = 0;
        stale = 0;
        lacking = 0;
        copied = Double.NEGATIVE_INFINITY;
        kept.clear();
        missed.clear();
    }

    /** Up to this moment nothing more was seen at a board. */
    void await(double seconds, Station board) throws RefusedException {
        if (sender != null && board.hasBeen(origin)) {
            sender.await(seconds);
        }
        End receiver = receivers.get(board.name());
        if (receiver != null) {
            receiver.await(seconds);
        }
    }

    /** Why the model refuses a step at one of its ends. */
    RefusedException refusal(String step, String who, End end) {
        String steps = end.next().stream().filter(Steps::isBoards).map(next -> Steps.words(next, origin, who)).sorted()
                .collect(Collectors.joining("; "));
        return new RefusedException(Steps.words(step, origin, who) + " (" + this + "); "
                + (steps.isEmpty() ? "nothing more is expected of this message" : "expected one of: " + steps));
    }

    @Override
    public String toString() {
        return origin + " to " + destination + (nonce.isEmpty() ? "" : ", nonce " + nonce);
    }
}
