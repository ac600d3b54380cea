package gateway;

import java.util.Map;
import java.util.TreeMap;

/** The gateways of one cell. One of them relays: the first by name of those that are there. */
final class CellGateways {

    /** Each says so often that it is there. */
    static final long SAY_MILLIS = 60_000;
    /** One that has said nothing for so long has gone; the broker may have gone before. */
    static final long GONE_MILLIS = 150_000;
    static final int MOST = 64;

    private final String own;
    private final Map<String, Long> there = new TreeMap<>();

    /** @param own the name of this gateway. */
    CellGateways(String own) {
        this.own = own;
    }

    /** A gateway has said that it is there, or that it goes. @return whether it is another one that has come. */
    boolean said(String name, boolean isThere, long now) {
        boolean isNew = isThere && !name.equals(own) && !there.containsKey(name);
        if (!isThere) {
            there.remove(name);
        } else if (there.containsKey(name) || there.size() < MOST || name.equals(own)) {
            there.put(name, now);
        }
        return isNew;
    }

    /** The broker has gone: nobody knows who is there. */
    void clear() {
        there.clear();
    }

    /** Whether this gateway relays. Before the broker has told of it, it knows of no others. */
    boolean isOwnTurn(long now) {
        if (!there.containsKey(own)) {
            return false;
        }
        return there.entrySet().stream()
                .filter(entry -> entry.getKey().equals(own) || now - entry.getValue() < GONE_MILLIS)
                .findFirst().map(Map.Entry::getKey).filter(own::equals).isPresent();
    }
}
