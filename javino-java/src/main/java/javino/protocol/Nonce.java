package javino.protocol;

/**
 * A number that an origin uses only once (SPEC 5.1).
 *
 * @param epoch   the board's boot epoch, 0…0xFFFFFE.
 * @param counter of the sealed frames in that epoch, 0…0xFFFFFF.
 */
public record Nonce(int epoch, int counter) {

    /** The number of bytes. */
    public static final int LENGTH = 6;

    /** The last epoch that is used; what a board says that has none left is one more. */
    public static final int LAST_EPOCH = 0xFFFFFE;

    private static final int MAX = 0xFFFFFF;

    /** @throws IllegalArgumentException if a part is out of range. */
    public Nonce {
        if (epoch < 0 || epoch >= MAX || counter < 0 || counter > MAX) {
            throw new IllegalArgumentException(
                    "a nonce has an epoch 0…0xFFFFFE and a counter 0…0xFFFFFF, not " + epoch + ", " + counter);
        }
    }

    /** Epoch and counter, three bytes each. */
    public Bytes toBytes() {
        return Bytes.join(Bytes.ofNumber(epoch, 3), Bytes.ofNumber(counter, 3));
    }
}
