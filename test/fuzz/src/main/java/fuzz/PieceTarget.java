package fuzz;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javino.protocol.Assembly;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.Piece;
import javino.protocol.ProtocolException;

/**
 * Frames, each after a byte with its length: those that are pieces are written as they were, and what is put together
 * of them is a frame that is cut into them.
 */
public final class PieceTarget {

    private PieceTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) {
        Assembly assembly = new Assembly();
        int at = 0;
        while (at < data.length) {
            int end = Math.min(data.length, at + 1 + (data[at] & 0xFF));
            add(assembly, Bytes.copyOf(Arrays.copyOfRange(data, at + 1, end)));
            at = end;
        }
    }

    private static void add(Assembly assembly, Bytes bytes) {
        int before = assembly.received();
        try {
            Frame frame = Frame.decode(bytes);
            Piece piece = Piece.decode(frame);
            Holds.equal(frame, piece.frame(), "piece");
            Optional<Frame> whole = assembly.add(piece);
            Holds.equal(before | 1 << piece.index(), assembly.received(), "what is here");
            whole.ifPresent(together -> checkWhole(together, piece, assembly.received()));
        } catch (ProtocolException refused) {
            Holds.always((before & assembly.received()) == before, "a refusal takes nothing away");
        }
    }

    private static void checkWhole(Frame whole, Piece last, int received) {
        List<Piece> pieces = Piece.cut(whole, last.id());
        Holds.equal((1 << pieces.size()) - 1, received, "all are here");
        Holds.equal(pieces.get(last.index()).part(), last.part(), "the last that came");
    }
}
