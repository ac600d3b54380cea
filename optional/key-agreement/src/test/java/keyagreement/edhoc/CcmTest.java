package keyagreement.edhoc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Optional;
import java.util.Random;
import javino.protocol.Bytes;
import org.bouncycastle.crypto.InvalidCipherTextException;
import org.bouncycastle.crypto.engines.AESEngine;
import org.bouncycastle.crypto.modes.CCMBlockCipher;
import org.bouncycastle.crypto.modes.CCMModeCipher;
import org.bouncycastle.crypto.params.AEADParameters;
import org.bouncycastle.crypto.params.KeyParameter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Tag("newerJava")
class CcmTest {

    /** Packet vectors 1, 2, 3, 4 and 7 of RFC 3610 section 8; examples 1 and 2 of NIST SP 800-38C appendix C. */
    @ParameterizedTest
    @CsvSource({
            "c0c1c2c3c4c5c6c7c8c9cacbcccdcecf, 00000003020100a0a1a2a3a4a5, 0001020304050607,"
                    + "08090a0b0c0d0e0f101112131415161718191a1b1c1d1e,"
                    + "588c979a61c663d2f066d0c2c0f989806d5f6b61dac38417e8d12cfdf926e0, 8",
            "c0c1c2c3c4c5c6c7c8c9cacbcccdcecf, 00000004030201a0a1a2a3a4a5, 0001020304050607,"
                    + "08090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f,"
                    + "72c91a36e135f8cf291ca894085c87e3cc15c439c9e43a3ba091d56e10400916, 8",
            "c0c1c2c3c4c5c6c7c8c9cacbcccdcecf, 00000005040302a0a1a2a3a4a5, 0001020304050607,"
                    + "08090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f20,"
                    + "51b1e5f44a197d1da46b0f8e2d282ae871e838bb64da8596574adaa76fbd9fb0c5, 8",
            "c0c1c2c3c4c5c6c7c8c9cacbcccdcecf, 00000006050403a0a1a2a3a4a5, 000102030405060708090a0b,"
                    + "0c0d0e0f101112131415161718191a1b1c1d1e,"
                    + "a28c6865939a9a79faaa5c4c2a9d4a91cdac8c96c861b9c9e61ef1, 8",
            "c0c1c2c3c4c5c6c7c8c9cacbcccdcecf, 00000009080706a0a1a2a3a4a5, 0001020304050607,"
                    + "08090a0b0c0d0e0f101112131415161718191a1b1c1d1e,"
                    + "0135d1b2c95f41d5d1d4fec185d166b8094e999dfed96c048c56602c97acbb7490, 10",
            "404142434445464748494a4b4c4d4e4f, 10111213141516, 0001020304050607, 20212223, 7162015b4dac255d, 4",
            "404142434445464748494a4b4c4d4e4f, 1011121314151617, 000102030405060708090a0b0c0d0e0f,"
                    + "202122232425262728292a2b2c2d2e2f, d2a1f0e051ea5f62081a7792073d593d1fc64fbfaccd, 6"})
    void vector_isSealedAndOpened(String key, String nonce, String associated, String text, String sealed, int tag) {
        Ccm ccm = new Ccm(Bytes.ofHex(key), Bytes.ofHex(nonce), tag);
        assertEquals(Bytes.ofHex(sealed), ccm.seal(Bytes.ofHex(text), Bytes.ofHex(associated)));
        assertEquals(Optional.of(Bytes.ofHex(text)), ccm.open(Bytes.ofHex(sealed), Bytes.ofHex(associated)));
    }

    @Test
    void textOfAnyLength_isSealedAsByBouncyCastleAndOpenedOnlyUnchanged() throws InvalidCipherTextException {
        Random random = new Random(3610);
        for (int length = 0; length < 100; length++) {
            Bytes key = bytes(random, 16);
            Bytes nonce = bytes(random, 13);
            Bytes text = bytes(random, length);
            Bytes associated = bytes(random, random.nextInt(50));
            CCMModeCipher theirs = CCMBlockCipher.newInstance(AESEngine.newInstance());
            theirs.init(true, new AEADParameters(new KeyParameter(key.toArray()), 64, nonce.toArray(),
                    associated.toArray()));
            Ccm ccm = new Ccm(key, nonce, 8);
            Bytes sealed = ccm.seal(text, associated);
            byte[] expected = new byte[length + 8];
            theirs.doFinal(expected, theirs.processBytes(text.toArray(), 0, length, expected, 0));
            assertEquals(Bytes.copyOf(expected), sealed);
            assertEquals(Optional.of(text), ccm.open(sealed, associated));
            byte[] changed = sealed.toArray();
            changed[random.nextInt(changed.length)] ^= 1 << random.nextInt(8);
            assertEquals(Optional.empty(), ccm.open(Bytes.copyOf(changed), associated));
            assertEquals(Optional.empty(), ccm.open(sealed, Bytes.join(associated, Bytes.of(0))));
            assertEquals(Optional.empty(), ccm.open(sealed.slice(0, random.nextInt(8)), associated));
            assertFalse(ccm.toString().contains(key.hex()));
        }
    }

    private static Bytes bytes(Random random, int length) {
        byte[] bytes = new byte[length];
        random.nextBytes(bytes);
        return Bytes.copyOf(bytes);
    }
}
