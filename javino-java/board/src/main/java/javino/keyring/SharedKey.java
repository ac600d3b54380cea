package javino.keyring;

import java.util.List;
import javino.protocol.Key;

/**
 * The key that a pair or a group shares.
 *
 * @param key  the key so far.
 * @param next the key that it is being renewed to; null where it is not.
 */
public record SharedKey(Key key, Key next) {

    /** The one that a board is to have in the end. */
    public Key last() {
        return next == null ? key : next;
    }

    /** The keys that a board may be sealing with. */
    public List<Key> all() {
        return next == null ? List.of(key) : List.of(key, next);
    }

    /** The key in the words of a keyring. */
    public String format() {
        return key.bytes().hex() + (next == null ? "" : ", next " + next.bytes().hex());
    }

    /** @throws IllegalArgumentException if it is none; without any key. */
    public static SharedKey parse(String text) {
        String[] keys = text.split(",", -1);
        if (keys.length > 2 || keys.length == 2 && !keys[1].strip().startsWith("next ")) {
            throw new IllegalArgumentException("a key that is being renewed is written as key, next key");
        }
        return new SharedKey(Key.ofHex(keys[0].strip()),
                keys.length == 1 ? null : Key.ofHex(keys[1].strip().substring("next ".length()).strip()));
    }

    @Override
    public String toString() {
        return all().toString();
    }
}
