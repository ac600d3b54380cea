package javino.cli;

import javino.keyring.PrivateFile;
import javino.keyring.Keyring;
import java.io.IOException;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Key;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code javino keygen}: makes a keyring, or new keys in one. */
@Command(name = "keygen", description = {
        "Makes new random keys and writes them to a file that only you can read.",
        "With --renew it adds new keys to a keyring, which javino provision then takes into use: keys of the named "
                + "pairs and "
                + "groups, all keys of the devices named by --id, or, without these options, all keys."})
final class KeygenCommand implements Callable<Integer> {

    @ArgGroup(multiplicity = "1")
    private Which which;

    @Option(names = "--pair", paramLabel = "A,B", converter = AddressOption.Pair.class,
            description = "Two devices that share a key, such as ROMA,SUPO.")
    private List<Keyring.Members> pairs = List.of();

    @Option(names = "--group", paramLabel = "GG", converter = AddressOption.Group.class,
            description = "A group that shares a key, such as SU.")
    private List<Address> groups = List.of();

    @Option(names = "--id", paramLabel = "ADDRESS", converter = AddressOption.Device.class,
            description = "With --renew: a device; all its keys are renewed.")
    private List<Address> ids = List.of();

    @Spec
    private CommandSpec spec;

    private final Time time;

    /** @param time gives the random numbers. */
    KeygenCommand(Time time) {
        this.time = time;
    }

    /** The file to write; one of the two is set. */
    private static final class Which {

        @Option(names = "--out", required = true, paramLabel = "FILE", description = "The keyring; must not exist yet.")
        private Path out;

        @Option(names = "--renew", required = true, paramLabel = "FILE",
                description = "The keyring whose keys are renewed.")
        private Path renew;
    }

    @Override
    public Integer call() throws IOException, JavinoException, InterruptedException {
        if (which.renew == null) {
            create();
        } else {
            renew();
        }
        return 0;
    }

    private void create() throws IOException, JavinoException {
        if (pairs.isEmpty() && groups.isEmpty() || !ids.isEmpty()) {
            throw wrongUsage(ids.isEmpty() ? "Name at least one --pair or --group" : "--id is for --renew");
        }
        Keyring keyring = new Keyring();
        SecureRandom random = time.secureRandom();
        try {
            named().forEach(members -> keyring.add(members, Key.random(random)));
        } catch (IllegalArgumentException e) {
            throw wrongUsage(e.getMessage());
        }
        PrivateFile.create(which.out, keyring.format());
        spec.commandLine().getOut()
                .println(keyring.size() + (keyring.size() == 1 ? " key" : " keys") + " written to " + which.out);
    }

    private void renew() throws IOException, JavinoException, InterruptedException {
        Keyring before = Keyring.read(which.renew);
        Set<Keyring.Members> chosen = chosen(before);
        SecureRandom random = time.secureRandom();
        Keyring.change(which.renew, keyring -> chosen.forEach(members -> keyring.renew(members, Key.random(random))));
        spec.commandLine().getOut().println("new keys for " + names(chosen) + " in " + which.renew
                + "; now javino provision on each board, three times");
    }

    private Set<Keyring.Members> chosen(Keyring keyring) throws JavinoException {
        Set<Keyring.Members> chosen = new LinkedHashSet<>(named());
        for (Keyring.Members members : chosen) {
            if (!keyring.keys().containsKey(members)) {
                throw new JavinoException(
                        which.renew + " has no key for " + members + "; it has " + keyring.describeMembers());
            }
        }
        for (Address id : ids) {
            Keyring.keysOf(which.renew, keyring, id).keySet()
                    .forEach(with -> keyring.membersOf(id, with).ifPresent(chosen::add));
        }
        if (pairs.isEmpty() && groups.isEmpty() && ids.isEmpty()) {
            chosen.addAll(keyring.keys().keySet());
        }
        if (chosen.isEmpty()) {
            throw new JavinoException(which.renew + " has no key");
        }
        Set<Keyring.Members> unfinished = new LinkedHashSet<>(chosen);
        unfinished.removeIf(members -> keyring.keys().get(members).next() == null);
        if (!unfinished.isEmpty()) {
            throw new JavinoException("the renewal of " + names(unfinished) + " is not finished; javino provision on "
                    + unfinished.stream().flatMap(members -> keyring.boardsWith(members).stream()).distinct()
                            .map(Address::toString).collect(Collectors.joining(", "))
                    + " first");
        }
        return chosen;
    }

    private static String names(Set<Keyring.Members> members) {
        return members.stream().map(Keyring.Members::toString).collect(Collectors.joining(", "));
    }

    private List<Keyring.Members> named() {
        return Stream.concat(pairs.stream(), groups.stream().map(Keyring.Members::group)).toList();
    }

    private ParameterException wrongUsage(String what) {
        return new ParameterException(spec.commandLine(), what);
    }
}
