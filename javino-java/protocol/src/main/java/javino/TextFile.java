package javino;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads texts that users name, of which one may be the wrong file: no more of it than a text can have. */
public final class TextFile {

    /** The most bytes of a text: an authority's file with all its certificates has 6 MiB. */
    public static final int MOST_BYTES = 16 << 20;

    private TextFile() {
    }

    /** The mark that some editors put before a text; it belongs to no text. */
    private static final String BYTE_ORDER_MARK = "\uFEFF";

    /**
     * Reads a file to its end, without a byte order mark.
     *
     * @throws IllegalArgumentException naming it if it has more than {@link #MOST_BYTES}, or if it is no text in UTF-8.
     */
    public static String read(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new FileSystemException(file.toString(), null, "it is a folder, not a file");
        }
        byte[] bytes;
        try (InputStream in = Files.newInputStream(file)) {
            bytes = in.readNBytes(MOST_BYTES + 1);
        }
        if (bytes.length > MOST_BYTES) {
            throw new IllegalArgumentException(
                    file + " has more than " + MOST_BYTES + " bytes, and so is not the file that is meant");
        }
        try {
            String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
            return text.startsWith(BYTE_ORDER_MARK) ? text.substring(BYTE_ORDER_MARK.length()) : text;
        } catch (CharacterCodingException e) {
            throw new IllegalArgumentException(
                    file + " is no text in UTF-8: is it the right file? If so, save it in UTF-8", e);
        }
    }
}
