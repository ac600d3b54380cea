package javino.protocol;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/**
 * Puts the pieces of one frame together, in any order (SPEC 7.1). When to give it up is for the caller to judge: a
 * board forgets it when no new piece came for 5 s.
 */
public final class Assembly {

    private final Piece[] pieces = new Piece[Piece.MAX_PIECES];
    private int least;
    private int most = Frame.MAX_LENGTH;

    /**
     * Adds a piece; one that is there already changes nothing.
     *
     * @return the whole frame, if all its pieces are here now.
     * @throws ProtocolException BAD_PIECE if it does not fit those that are here, which stay, or the frame's error if
     *     they make none.
     */
    public Optional<Frame> add(Piece piece) throws ProtocolException {
        checkFits(piece);
        least = Math.max(least, piece.leastTotal());
        most = Math.min(most, piece.mostTotal());
        pieces[piece.index()] = piece;
        return isWhole() ? Optional.of(whole()) : Optional.empty();
    }

    /** Bit k is set where piece k is here, as an acknowledgement tells it (SPEC 7.3). */
    public int received() {
        int bits = 0;
        for (int index = 0; index < pieces.length; index++) {
            bits |= pieces[index] == null ? 0 : 1 << index;
        }
        return bits;
    }

    private void checkFits(Piece piece) throws ProtocolException {
        for (Piece other : pieces) {
            expect(other == null || other.origin().equals(piece.origin()) && other.id() == piece.id(),
                    "it is of another frame", piece);
        }
        Piece same = pieces[piece.index()];
        expect(same == null || same.part().equals(piece.part()), "another with this index is here", piece);
        expect(piece.leastTotal() <= most && piece.mostTotal() >= least,
                "the others make a frame of another length", piece);
    }

    private static void expect(boolean condition, String complaint, Piece piece) throws ProtocolException {
        if (!condition) {
            throw new ProtocolException(ProtocolError.BAD_PIECE,
                    "piece " + piece.index() + " does not fit, " + complaint + ": " + piece.frame().encode().hex());
        }
    }

    private boolean isWhole() {
        int count = (most + Piece.MAX_LENGTH - 1) / Piece.MAX_LENGTH;
        return pieces[0] != null && received() == (1 << count) - 1;
    }

    private Frame whole() throws ProtocolException {
        return Frame.decode(Bytes.join(Arrays.stream(pieces).filter(Objects::nonNull).map(Piece::part)
                .toArray(Bytes[]::new)));
    }
}
