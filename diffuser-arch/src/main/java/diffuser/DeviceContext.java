package diffuser;

import java.util.Optional;
import java.util.function.Consumer;

/**
 * The agent around a device.
 *
 * @param agent    its name.
 * @param inbox    where its messages go.
 * @param hosts    where messages of hosts go.
 * @param warnings where its user is told what went wrong.
 * @param wake     ends its sleep.
 * @param printed  is told what the sketch prints.
 * @param keyService agrees on keys, if that library is there.
 */
record DeviceContext(String agent, Inbox inbox, HostMessages hosts, Warnings warnings, Runnable wake,
        Consumer<String> printed, Optional<KeyService> keyService) {
}
