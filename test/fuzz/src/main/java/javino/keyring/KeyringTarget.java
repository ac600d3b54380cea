package javino.keyring;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;

/** A keyring's text: refused with a reason that shows no key, or read and written the same. */
public final class KeyringTarget {

    private static final Path FILE = temporary();
    private static final Pattern KEY = Pattern.compile("[0-9A-Fa-f]{32}");

    private KeyringTarget() {
    }

    private static Path temporary() {
        try {
            Path file = Files.createTempFile("keyring", ".txt");
            file.toFile().deleteOnExit();
            return file;
        } catch (IOException e) {
            throw new IllegalStateException("no file can be made to read", e);
        }
    }

    public static void fuzzerTestOneInput(byte[] data) throws IOException {
        Files.write(FILE, data);
        Keyring keyring;
        try {
            keyring = Keyring.read(FILE);
        } catch (IllegalArgumentException refused) {
            if (KEY.matcher(refused.getMessage()).find()) {
                throw new AssertionError("shows a key", refused);
            }
            return;
        }
        String text = keyring.format();
        Files.writeString(FILE, text);
        Keyring again = Keyring.read(FILE);
        if (again.size() != keyring.size() || !again.format().equals(text)) {
            throw new AssertionError("a keyring is written as it was read: " + text);
        }
    }
}
