package diffuser.mind;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.gate.Names;
import diffuser.report.Failure;

import javino.protocol.Address;

/** Reads RF addresses as users write them (SPEC 1). */
public final class Destinations {

    private static final String BROADCAST = "broadcast";
    /** The group {@code SU} as the paper's plan 3 writes it; Jason keeps both backslashes of {@code "SU\\"}. */
    private static final Pattern GROUP = Pattern.compile("(..)\\\\{1,2}");

    private Destinations() {
    }

    /**
     * The receiver of a message: {@code broadcast}, {@code "////"}, {@code "//SU"}, {@code "SU\\"} or a device.
     *
     * @throws JasonException bad_address if it is anything else.
     */
    public static Address of(Term to) throws JasonException {
        String name = Names.of(to).orElseThrow(() -> badAddress(to.toString(), "write it as a string"));
        try {
            return parse(name);
        } catch (IllegalArgumentException e) {
            throw badAddress(name, e.getMessage());
        }
    }

    /**
     * A device's own address.
     *
     * @throws JasonException bad_address if it is anything else.
     */
    public static Address device(Term id) throws JasonException {
        Address address = of(id);
        if (address.kind() != Address.Kind.DEVICE) {
            throw badAddress(address.toString(), "a device's id begins with one of A-Z a-z 0-9");
        }
        return address;
    }

    /** The address that a receiver's name stands for, if it is one. */
    public static Optional<Address> find(String name) {
        try {
            return Optional.of(parse(name));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    /** Whether an address looks as if the group were meant, as {@code SU//} does; it is a device all the same. */
    static boolean isMistakable(Address to) {
        return to.kind() == Address.Kind.DEVICE && to.member().equals("//");
    }

    private static Address parse(String name) {
        if (name.equals(BROADCAST)) {
            return Address.BROADCAST;
        }
        Matcher group = GROUP.matcher(name);
        Address address = group.matches() ? Address.multicast(group.group(1)) : Address.parse(name);
        return switch (address.kind()) {
            case DEVICE, MULTICAST, BROADCAST -> address;
            case FRAGMENT, ACKNOWLEDGEMENT, SERIAL, RESERVED ->
                throw new IllegalArgumentException("nothing can be sent to it");
        };
    }

    private static JasonException badAddress(String found, String reason) {
        return new Failure("bad_address",
                found + " is no RF address such as \"ROMA\", \"//SU\" or broadcast: " + reason)
                .toException();
    }
}
