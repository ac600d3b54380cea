package javino.cli;

import java.util.EnumSet;
import java.util.Set;
import javino.Printable;
import javino.keyring.Keyring;
import javino.protocol.Address;
import javino.protocol.Address.Kind;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads addresses on the command line, so that a wrong one is wrong usage. */
public abstract class AddressOption implements ITypeConverter<Address> {

    private final Set<Kind> kinds;
    private final String expected;

    private AddressOption(Set<Kind> kinds, String expected) {
        this.kinds = kinds;
        this.expected = expected;
    }

    @Override
    public final Address convert(String text) {
        Address address = parse(text);
        if (!kinds.contains(address.kind())) {
            throw new TypeConversionException(expected + " was expected, not " + address);
        }
        return address;
    }

    private static Address parse(String text) {
        try {
            return Address.parse(text);
        } catch (IllegalArgumentException e) {
            throw new TypeConversionException(e.getMessage());
        }
    }

    /** A device's own address. */
    public static final class Device extends AddressOption {
        /** The constructor for picocli. */
        public Device() {
            super(EnumSet.of(Kind.DEVICE), "a device such as SUPO, which begins with one of A-Z a-z 0-9,");
        }
    }

    /** An address that a key can be shared with. */
    static final class KeyHolder extends AddressOption {
        KeyHolder() {
            super(EnumSet.of(Kind.DEVICE, Kind.MULTICAST), "a device such as SUPO or a group such as //SU");
        }
    }

    /** An address that a message can be for. */
    static final class Destination extends AddressOption {
        Destination() {
            super(EnumSet.of(Kind.DEVICE, Kind.MULTICAST, Kind.BROADCAST),
                    "a device such as SUPO, a group such as //SU, or //// for all");
        }
    }

    /** Two devices. */
    static final class Pair implements ITypeConverter<Keyring.Members> {
        @Override
        public Keyring.Members convert(String text) {
            String[] ends = text.split(",", -1);
            if (ends.length != 2) {
                throw new TypeConversionException("a pair is written as ROMA,SUPO, not " + Printable.of(text));
            }
            try {
                return Keyring.Members.pair(Address.parse(ends[0]), Address.parse(ends[1]));
            } catch (IllegalArgumentException e) {
                throw new TypeConversionException(e.getMessage());
            }
        }
    }

    /** A group by its two digits. */
    public static final class Group implements ITypeConverter<Address> {
        /** The constructor for picocli. */
        public Group() {
        }

        @Override
        public Address convert(String text) {
            try {
                return Address.multicast(text);
            } catch (IllegalArgumentException e) {
                throw new TypeConversionException(e.getMessage());
            }
        }
    }
}
