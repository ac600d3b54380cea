package javino.protocol;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;

/** A capability that a board tells in hello (SPEC 4.3). */
public enum Capability {
    @Capabilities.def: /** $4 */ $1($2),
    /** It says when it has taken a request; all boards do but those of an earlier library. */
    SAYS_TAKEN(0);

    /** The capabilities of a board of an earlier library, which does not tell them. */
    public static final Set<Capability> OF_EARLIER_LIBRARY = Collections.unmodifiableSet(EnumSet.of(RADIO, MEMORY));

    private final int bit;

    Capability(int bit) {
        this.bit = bit;
    }

    /** The byte of a hello that says so. */
    public static int encode(Set<Capability> all) {
        return all.stream().mapToInt(capability -> capability.bit).sum();
    }

    static Set<Capability> decode(int bits) {
        Set<Capability> all = EnumSet.of(SAYS_TAKEN);
        for (Capability capability : values()) {
            if ((bits & capability.bit) != 0) {
                all.add(capability);
            }
        }
        return Collections.unmodifiableSet(all);
    }
}
