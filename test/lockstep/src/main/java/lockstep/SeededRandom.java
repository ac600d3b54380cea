package lockstep;

import java.security.SecureRandom;
import java.security.SecureRandomSpi;
import java.util.Random;

/** Random numbers that anybody can make again: a key of them is for tests. */
final class SeededRandom extends SecureRandom {

    private static final long serialVersionUID = 1;

    private static final class Numbers extends SecureRandomSpi {
        private static final long serialVersionUID = 1;
        private final Random random;

        Numbers(long seed) {
            random = new Random(seed);
        }

        @Override
        protected void engineSetSeed(byte[] seed) {
            // The seed is the run's.
        }

        @Override
        protected void engineNextBytes(byte[] bytes) {
            random.nextBytes(bytes);
        }

        @Override
        protected byte[] engineGenerateSeed(int count) {
            byte[] bytes = new byte[count];
            random.nextBytes(bytes);
            return bytes;
        }
    }

    SeededRandom(long seed) {
        super(new Numbers(seed), null);
    }
}
