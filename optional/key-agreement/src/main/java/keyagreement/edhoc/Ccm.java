package keyagreement.edhoc;

import java.security.GeneralSecurityException;
import java.util.Optional;
import javax.crypto.Cipher;
import javax.crypto.spec.IvParameterSpec;
import javax.crypto.spec.SecretKeySpec;
import javino.protocol.Bytes;

/**
 * AES-CCM (RFC 3610, NIST SP 800-38C), from the JDK's AES in CBC and CTR, as the JDK has no CCM.
 *
 * @param key       16 bytes; 24 or 32 work, too.
 * @param nonce     7…13 bytes; never twice with a key.
 * @param tagLength 4, 6, 8, …, 16 bytes.
 */
record Ccm(Bytes key, Bytes nonce, int tagLength) {

    private static final int BLOCK = 16;

    /** @throws IllegalArgumentException if RFC 3610 knows no such nonce or tag. */
    Ccm {
        if (nonce.length() < 7 || nonce.length() > 13 || tagLength < 4 || tagLength > BLOCK || tagLength % 2 != 0) {
            throw new IllegalArgumentException(
                    "AES-CCM has no nonce of " + nonce.length() + " and tag of " + tagLength + " bytes");
        }
    }

    /** @param text fewer than 65536 bytes. @param associated fewer than 65280 bytes. @return the tag is at its end. */
    Bytes seal(Bytes text, Bytes associated) {
        Bytes tag = tag(text, associated);
        Bytes sealed = crypt(Bytes.join(tag, text));
        return Bytes.join(sealed.from(BLOCK), sealed.slice(0, tagLength));
    }

    /** The text; nothing if the tag is wrong. */
    Optional<Bytes> open(Bytes sealed, Bytes associated) {
        int length = sealed.length() - tagLength;
        if (length < 0) {
            return Optional.empty();
        }
        Bytes first = Bytes.join(sealed.from(length), zeros(BLOCK - tagLength));
        Bytes opened = crypt(Bytes.join(first, sealed.slice(0, length)));
        Bytes text = opened.from(BLOCK);
        Bytes tag = tag(text, associated).slice(0, tagLength);
        return tag.isSame(opened.slice(0, tagLength)) ? Optional.of(text) : Optional.empty();
    }

    /** The last block of the CBC-MAC, RFC 3610 section 2.2. */
    private Bytes tag(Bytes text, Bytes associated) {
        int lengthBytes = BLOCK - 1 - nonce.length();
        int flags = (associated.length() > 0 ? 0x40 : 0) | (tagLength - 2) / 2 << 3 | lengthBytes - 1;
        Bytes first = Bytes.join(Bytes.of(flags), nonce, Bytes.ofNumber(text.length(), lengthBytes));
        Bytes header = associated.length() == 0 ? Bytes.EMPTY
                : padded(Bytes.join(Bytes.ofNumber(associated.length(), 2), associated));
        Bytes chained = aes("AES/CBC/NoPadding", zeros(BLOCK), Bytes.join(first, header, padded(text)));
        return chained.from(chained.length() - BLOCK);
    }

    /** Section 2.3: the tag is the first block, and the text follows. */
    private Bytes crypt(Bytes tagAndText) {
        int lengthBytes = BLOCK - 1 - nonce.length();
        return aes("AES/CTR/NoPadding", Bytes.join(Bytes.of(lengthBytes - 1), nonce, zeros(lengthBytes)), tagAndText);
    }

    private Bytes aes(String mode, Bytes iv, Bytes text) {
        try {
            Cipher cipher = Cipher.getInstance(mode);
            cipher.init(Cipher.ENCRYPT_MODE, new SecretKeySpec(key.toArray(), "AES"),
                    new IvParameterSpec(iv.toArray()));
            return Bytes.copyOf(cipher.doFinal(text.toArray()));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every JDK has AES", e);
        }
    }

    private static Bytes padded(Bytes text) {
        return Bytes.join(text, zeros(-text.length() & BLOCK - 1));
    }

    private static Bytes zeros(int length) {
        return Bytes.copyOf(new byte[length]);
    }

    @Override
    public String toString() {
        return "AES-CCM with tags of " + tagLength + " bytes";
    }
}
