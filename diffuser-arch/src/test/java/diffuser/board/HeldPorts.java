package diffuser.board;

import java.util.Set;
import java.util.stream.Collectors;

/** The ports that agents of this virtual machine hold. */
public final class HeldPorts {

    private HeldPorts() {
    }

    /** Their names. */
    public static Set<String> names() {
        return ExclusivePort.HOLDERS.keySet().stream().map(ExclusivePort.Port::name).collect(Collectors.toSet());
    }

    /** Frees all of them. */
    public static void leaveAll() {
        ExclusivePort.HOLDERS.values().forEach(ExclusivePort::leave);
    }
}
