package gateway;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javino.protocol.Address;

/** The names of docs/mqtt.md. */
final class Topics {

    /** What a cell or a gateway may be called. */
    static final String NAME = "[A-Za-z0-9_-]{1,32}";
    private static final Pattern TOPIC = Pattern.compile("(" + NAME + ")/(air|heard|gateway)(?:/(" + NAME + "))?");

    private final String prefix;

    /** What a topic is about. */
    enum About {
        /** A frame that was heard. */
        AIR,
        /** A device that was heard. */
        HEARD,
        /** A gateway that is there. */
        GATEWAY
    }

    /**
     * A topic.
     *
     * @param cell where.
     * @param name of the device or gateway; empty if it is about a frame.
     */
    record Topic(String cell, About about, String name) {

        /** The device's address; nothing where the name is none. */
        Optional<Address> device() {
            try {
                return Optional.of(Address.parse(name.replace('-', '+').replace('_', '/')))
                        .filter(address -> address.kind() == Address.Kind.DEVICE);
            } catch (IllegalArgumentException none) {
                return Optional.empty();
            }
        }
    }

    /** @param prefix of all topics, without the slash behind it. */
    Topics(String prefix) {
        this.prefix = prefix + "/";
    }

    String air(String cell) {
        return prefix + cell + "/air";
    }

    String heard(String cell, Address device) {
        return heard(cell, device.toString().replace('+', '-').replace('/', '_'));
    }

    String heard(String cell, String name) {
        return prefix + cell + "/heard/" + name;
    }

    String gateway(String cell, String name) {
        return prefix + cell + "/gateway/" + name;
    }

    /** Reads a topic; nothing where it is none of these. */
    Optional<Topic> read(String topic) {
        Matcher parts = TOPIC.matcher(topic.startsWith(prefix) ? topic.substring(prefix.length()) : "");
        if (!parts.matches()) {
            return Optional.empty();
        }
        About about = About.valueOf(parts.group(2).toUpperCase(Locale.ROOT));
        String name = parts.group(3);
        return (about == About.AIR) == (name == null)
                ? Optional.of(new Topic(parts.group(1), about, name == null ? "" : name)) : Optional.empty();
    }
}
