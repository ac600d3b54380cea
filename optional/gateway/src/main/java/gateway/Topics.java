package gateway;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javino.protocol.Address;

/** The topics of docs/mqtt.md: {@code PREFIX/WHAT/NAME/from/CELL}, so that an access list can say who may write. */
final class Topics {

    /** Names of cells and gateways. */
    static final String NAME = "[A-Za-z0-9_-]{1,32}";
    private static final Pattern TOPIC = Pattern.compile(
            "(to|group|search|broadcast|seek|gateway)/(" + NAME + ")/from/(" + NAME + ")(?:/(air|heard/(" + NAME
                    + ")))?");

    private static final String FROM = "/from/";

    private final String prefix;
    private final String cell;

    /** The subject of a topic. */
    enum About {
        /** For a cell: a frame, or where a device was heard. */
        TO,
        /** A frame, as the other three. */
        GROUP, SEARCH, BROADCAST,
        /** The question which cell has heard a device. */
        SEEK,
        /** A gateway that is there. */
        GATEWAY
    }

    /**
     * A topic.
     *
     * @param name  the cell, group, device or gateway that it is about.
     * @param from  the cell of the gateway that has published it.
     * @param heard the device that was heard; empty if it is about a frame or nothing.
     */
    record Topic(About about, String name, String from, String heard) {

        /** The cells for which it is, if it is about a frame. */
        Router.Whom whom() {
            return about == About.TO ? Router.Whom.CELL : Router.Whom.valueOf(about.name());
        }

        /** The address of the device that is sought or was heard; nothing where the name is none. */
        Optional<Address> device() {
            try {
                return Optional.of(Address.parse((about == About.SEEK ? name : heard).replace('-', '+')
                        .replace('_', '/'))).filter(address -> address.kind() == Address.Kind.DEVICE);
            } catch (IllegalArgumentException none) {
                return Optional.empty();
            }
        }
    }

    /**
     * @param prefix the prefix of all topics, without the slash behind it.
     * @param cell   the cell of the gateway that publishes.
     */
    Topics(String prefix, String cell) {
        this.prefix = prefix + "/";
        this.cell = cell;
    }

    /** Frames. @param to a cell or group. */
    String air(Router.Whom whom, String to) {
        About about = switch (whom) {
            case CELL -> About.TO;
            case GROUP -> About.GROUP;
            case SEARCH -> About.SEARCH;
            case BROADCAST -> About.BROADCAST;
        };
        return topic(about, name(to)) + "/air";
    }

    /** The question who has heard a device. */
    String seek(Address device) {
        return topic(About.SEEK, name(device.toString()));
    }

    /** The answer. */
    String heard(String other, Address device) {
        return heard(other, name(device.toString()));
    }

    /** The same. @param device its name in topics, or {@code +}. */
    String heard(String other, String device) {
        return topic(About.TO, other) + "/heard/" + device;
    }

    /** The topic of a gateway of this cell, for its own state. */
    String gateway(String name) {
        return topic(About.GATEWAY, name);
    }

    /** All questions for a device, or all frames for a group. */
    String wanted(Address address) {
        return fromAll(address.kind() == Address.Kind.MULTICAST ? air(Router.Whom.GROUP, address.member())
                : seek(address));
    }

    /** The same topic of all cells. */
    static String fromAll(String topic) {
        int from = topic.lastIndexOf(FROM) + FROM.length();
        int end = topic.indexOf('/', from);
        return topic.substring(0, from) + "+" + (end < 0 ? "" : topic.substring(end));
    }

    private String topic(About about, String name) {
        return prefix + about.name().toLowerCase(Locale.ROOT) + "/" + name + FROM + cell;
    }

    /** In a topic, + and / have a meaning. */
    private static String name(String digits) {
        return digits.replace('+', '-').replace('/', '_');
    }

    /** Reads a topic; nothing where it is none of these. */
    Optional<Topic> read(String topic) {
        Matcher parts = TOPIC.matcher(topic.startsWith(prefix) ? topic.substring(prefix.length()) : "");
        if (!parts.matches()) {
            return Optional.empty();
        }
        About about = About.valueOf(parts.group(1).toUpperCase(Locale.ROOT));
        String rest = parts.group(4);
        boolean right = switch (about) {
            case TO -> rest != null;
            case GROUP, SEARCH, BROADCAST -> "air".equals(rest);
            case SEEK, GATEWAY -> rest == null;
        };
        return right ? Optional.of(new Topic(about, parts.group(2), parts.group(3),
                parts.group(5) == null ? "" : parts.group(5))) : Optional.empty();
    }
}
