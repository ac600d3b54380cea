package harness;

import java.io.ByteArrayOutputStream;
import java.time.Duration;
import java.util.Random;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/**
 * A real link whose bytes get lost, flipped and inserted on the way, both ways, and come in small pieces. The damage
 * comes from one seed; its places depend on how the bytes arrive.
 */
public final class DamagedLink extends ForwardedLink {

    private final Random random;
    private final double rate;

    private DamagedLink(Link link, Random random, double rate) {
        super(link);
        this.random = random;
        this.rate = rate;
    }

    /** Opens links that damage a share {@code rate} of the bytes. */
    public static LinkOpener opener(LinkOpener opener, long seed, double rate) {
        Random random = new Random(seed);
        return opener(opener, link -> new DamagedLink(link, random, rate));
    }

    @Override
    public void write(byte[] bytes) throws LinkException {
        link.write(damage(bytes, bytes.length));
    }

    @Override
    public int read(byte[] into, Duration timeout) throws LinkException {
        byte[] whole = new byte[1 + random.nextInt(Math.min(16, into.length / 2))];
        byte[] damaged = damage(whole, link.read(whole, timeout));
        System.arraycopy(damaged, 0, into, 0, damaged.length);
        return damaged.length;
    }

    private byte[] damage(byte[] bytes, int length) {
        ByteArrayOutputStream damaged = new ByteArrayOutputStream();
        for (int i = 0; i < length; i++) {
            if (random.nextDouble() >= rate) {
                damaged.write(bytes[i]);
                continue;
            }
            switch (random.nextInt(3)) {
                case 0 -> {}
                case 1 -> damaged.write(bytes[i] ^ 1 << random.nextInt(8));
                default -> {
                    damaged.write(random.nextInt(256));
                    damaged.write(bytes[i]);
                }
            }
        }
        return damaged.toByteArray();
    }
}
