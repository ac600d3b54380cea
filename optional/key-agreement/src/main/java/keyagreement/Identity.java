package keyagreement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.interfaces.ECPrivateKey;
import java.time.InstantSource;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.keyring.DeviceNotes;
import javino.keyring.PrivateFile;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Key;
import keyagreement.edhoc.Credential;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.HandshakeException.Reason;
import keyagreement.edhoc.P256;
import keyagreement.edhoc.Party;
import keyagreement.edhoc.Secret;

/** A device's certificate and secret, the authorities that it trusts, and their last revocation lists. */
public final class Identity {

    // Lines of a device's file, and of what an authority answers.
    static final String SECRET = "secret";
    static final String CERTIFICATE = "certificate";
    static final String AUTHORITY = "authority";
    static final String REVOCATION_LIST = "revocation-list";
    static final String CONTRIBUTION = "contribution";

    /** Before a member in the group's file that is owed the key: no digit of an address. */
    private static final String OWED = "-";

    private static final int KEY_LABEL = 32768;

    private final Path file;
    private final InstantSource clock;
    private final Certificate certificate;
    private final ECPrivateKey secret;
    private final Credential credential;
    private final List<AuthorityKeys> authorities = new ArrayList<>();
    private final List<RevocationList> revocationLists = new ArrayList<>();

    private Identity(Path file, Entries entries, InstantSource clock) throws HandshakeException {
        this.file = file;
        this.clock = clock;
        for (Bytes keys : entries.all(AUTHORITY)) {
            authorities.add(AuthorityKeys.decode(keys));
        }
        certificate = Certificate.decode(entries.get(CERTIFICATE).orElse(Bytes.EMPTY));
        secret = P256.secret(P256.number(entries.get(SECRET).orElse(Bytes.EMPTY)));
        credential = certificate.credential(authority(certificate.authority()));
        if (!P256.publicX(secret).equals(P256.x(credential.key()))) {
            throw new HandshakeException("the secret is not that of the certificate");
        }
        for (Bytes revocationList : entries.all(REVOCATION_LIST)) {
            revocationLists.add(verified(revocationList));
        }
    }

    /**
     * Reads the identity of a device, which {@code javino enroll} wrote.
     *
     * @param clock the computer's, by which certificates end.
     * @return nothing where the device has no certificate.
     * @throws IllegalArgumentException if the file is damaged, or others may read it.
     */
    public static Optional<Identity> read(Path folder, Address device, InstantSource clock) throws IOException {
        Path file = DeviceNotes.identity(folder, device);
        Entries entries = Files.exists(file) ? Entries.parse(PrivateFile.read(file), file) : new Entries();
        return entries.get(CERTIFICATE).isEmpty() ? Optional.empty() : Optional.of(of(file, entries, clock));
    }

    static Identity of(Path file, Entries entries, InstantSource clock) {
        try {
            return new Identity(file, entries, clock);
        } catch (HandshakeException | IllegalArgumentException e) {
            throw new IllegalArgumentException(file + " is damaged: " + e.getMessage(), e);
        }
    }

    /** Its own certificate. */
    public Certificate certificate() {
        return certificate;
    }

    /**
     * This device in a handshake with another.
     *
     * @param other the device that it wants, or whose address the frame has. Only a certificate for this address is
     *              accepted, and only one that passes {@link #check}.
     */
    public Party with(Address other) {
        return new Party() {
            @Override
            public Credential own() {
                return credential;
            }

            @Override
            public ECPrivateKey secret() {
                return secret;
            }

            @Override
            public Credential find(Bytes kid) throws HandshakeException {
                Certificate theirs = Certificate.decode(kid);
                if (!theirs.address().equals(other)) {
                    throw refused("the " + theirs + " is not that of " + other);
                }
                if (theirs.address().equals(certificate.address())) {
                    throw refused("the " + theirs + " is for this device's own address");
                }
                return theirs.credential(authority(theirs.authority()));
            }

            @Override
            public void admit(Credential proved) throws HandshakeException {
                check(Certificate.decode(proved.kid()));
            }
        };
    }

    /**
     * Whether a certificate may be believed now: its authority is trusted, its day not past, and no revocation list
     * names it. To be asked again before a renewal.
     */
    public synchronized void check(Certificate other) throws HandshakeException {
        authority(other.authority());
        if (other.until().isBefore(today())) {
            throw new HandshakeException(Reason.EXPIRED, "the " + other + " is past: it is " + today() + " by "
                    + (today().equals(latestListedDay()) ? "the authority's revocation list"
                            : "this computer's clock"));
        }
        for (RevocationList revocationList : revocationLists) {
            if (revocationList.authority() == other.authority() && revocationList.revokes(other)) {
                throw new HandshakeException(Reason.REVOKED, "the " + other + " is revoked by " + revocationList);
            }
        }
    }

    /** Why a certificate may not be believed now; nothing if it may. */
    Optional<Reason> refusal(Certificate other) {
        try {
            check(other);
            return Optional.empty();
        } catch (HandshakeException e) {
            return Optional.of(e.reason());
        }
    }

    /**
     * The latest day ever seen in a revocation list, or that of the clock if that is later. The clock's is not kept:
     * one that was years ahead once would end all certificates for ever.
     */
    private LocalDate today() {
        LocalDate told = LocalDate.ofInstant(clock.instant(), ZoneId.systemDefault());
        return told.isAfter(latestListedDay()) ? told : latestListedDay();
    }

    private LocalDate latestListedDay() {
        return revocationLists.stream().map(RevocationList::day).max(LocalDate::compareTo).orElse(LocalDate.EPOCH);
    }

    private static HandshakeException refused(String what) {
        return new HandshakeException(what);
    }

    private AuthorityKeys authority(int id) throws HandshakeException {
        return authorities.stream().filter(keys -> keys.id() == id).findFirst()
                .orElseThrow(() -> new HandshakeException("authority " + id + " is not trusted here"));
    }

    /** The newest revocation list of each authority that was trusted, to be handed on. */
    public synchronized List<RevocationList> revocationLists() {
        return List.copyOf(revocationLists);
    }

    /**
     * Takes a revocation list that came from anybody.
     *
     * @return whether it is newer than all before: then it is to be kept.
     * @throws HandshakeException if it is forged or of no trusted authority.
     */
    public synchronized boolean take(Bytes bytes) throws HandshakeException {
        return replace(verified(bytes), revocationLists);
    }

    /** Keeps all revocation lists in the file. */
    public void keep() throws IOException, JavinoException, InterruptedException {
        PrivateFile.change(file, text -> {
            Entries entries = Entries.parse(text, file);
            for (RevocationList each : revocationLists()) {
                keep(each, entries);
            }
            return entries.format();
        });
    }

    private Path groupFile() {
        return file.resolveSibling(file.getFileName().toString().replace(".identity", ".group"));
    }

    /** The key of the group that this device gives, who has had it, and, after a mark, who is owed it. */
    Optional<GroupKeys.Kept> groupKey() throws IOException {
        if (!certificate.groupKeyServer() || !Files.exists(groupFile())) {
            return Optional.empty();
        }
        List<String> words = List.of(PrivateFile.read(groupFile()).strip().split("\\s+"));
        Map<Boolean, Set<Address>> isOwed = words.stream().skip(1).collect(Collectors.partitioningBy(
                word -> word.startsWith(OWED), Collectors.mapping(
                        word -> Address.parse(word.startsWith(OWED) ? word.substring(OWED.length()) : word),
                        Collectors.toSet())));
        return Optional.of(new GroupKeys.Kept(Key.of(Bytes.ofHex(words.get(0))), isOwed.get(false), isOwed.get(true)));
    }

    void keepGroupKey(GroupKeys.Kept kept) throws IOException, JavinoException, InterruptedException {
        Stream<String> members = Stream.concat(kept.had().stream().map(Address::toString),
                kept.owed().stream().map(member -> OWED + member));
        String text = Stream.concat(Stream.of(kept.key().bytes().hex()), members.sorted())
                .collect(Collectors.joining("\n"));
        if (Files.exists(groupFile())) {
            PrivateFile.change(groupFile(), before -> text);
        } else {
            PrivateFile.create(groupFile(), text);
        }
    }

    private RevocationList verified(Bytes bytes) throws HandshakeException {
        RevocationList revocationList = RevocationList.decode(bytes);
        if (!revocationList.isOf(authority(revocationList.authority()))) {
            throw new HandshakeException("the " + revocationList + " is not signed by its authority");
        }
        return revocationList;
    }

    /** Puts a revocation list in the place of an older one of its authority; false if it is no newer. */
    private static boolean replace(RevocationList revocationList, List<RevocationList> in) {
        List<RevocationList> same = in.stream()
                .filter(each -> each.authority() == revocationList.authority()).toList();
        return same.stream().allMatch(each -> each.sequence() < revocationList.sequence())
                && (in.removeAll(same) | in.add(revocationList));
    }

    /** The same in a file. */
    static void keep(RevocationList revocationList, Entries entries) throws HandshakeException {
        List<RevocationList> kept = new ArrayList<>();
        for (Bytes bytes : entries.all(REVOCATION_LIST)) {
            kept.add(RevocationList.decode(bytes));
        }
        if (replace(revocationList, kept)) {
            entries.remove(REVOCATION_LIST);
            kept.forEach(each -> entries.add(REVOCATION_LIST, each.toBytes()));
        }
    }

    /** The key of a session, for the boards of both: the same at both sides (SPEC 11.1). */
    public static Key key(Secret secret, Address initiator, Address responder) {
        return Key.of(secret.export(KEY_LABEL, pair(initiator, responder), Key.LENGTH));
    }

    /** 6 bytes. */
    static Bytes pair(Address initiator, Address responder) {
        return Bytes.join(Bytes.ofNumber(initiator.value(), 3), Bytes.ofNumber(responder.value(), 3));
    }
}
