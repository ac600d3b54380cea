package diffuser.board;

import java.util.Set;

/** The ports that agents of this virtual machine hold. */
public final class HeldPorts {

    private HeldPorts() {
    }

    /** Their names. */
    public static Set<String> names() {
        return Set.copyOf(ExclusivePort.HOLDERS.keySet());
    }

    /** Frees all of them. */
    public static void leaveAll() {
        ExclusivePort.HOLDERS.values().forEach(ExclusivePort::leave);
    }
}
