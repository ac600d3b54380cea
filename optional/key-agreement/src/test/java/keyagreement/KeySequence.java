package keyagreement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;

import diffuser.AgentHost;

import javino.JavinoException;
import javino.cli.ProvisioningHost;
import javino.fake.FakeAir;
import javino.fake.FakeBoard;
import javino.keyring.BoundedClock;
import javino.keyring.DeviceNotes;
import javino.keyring.Keyring;
import javino.keyring.KeyringNotes;
import javino.keyring.PrivateFile;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.Performative;

/**
 * Events of the boards, keys and hosts of three devices of one group, in an order that a seed has drawn. Boards and air
 * are in memory, all else is real: sessions, provisioning, the keyring and its notes, key agreement.
 */
final class KeySequence implements FakeAir.Listener, AutoCloseable {

    static final List<Address> DEVICES = Stream.of("BUSA", "BUSB", "BUKE").map(Address::parse).toList();
    private static final Address GROUP = Address.multicast("BU");
    private static final long MINUTE = 60_000;
    /** A message waits no longer for a key. */
    private static final long PATIENCE = 70_000;
    private static final int MOST_STEPS = 24;
    /** How wrong clocks are, in days. */
    private static final int[] WRONG_DAYS = {0, 0, -20_000, 300, 1200, 20_000};

    /** The kinds of events; the more often one stands in {@link #OFTEN}, the more often it happens. */
    enum Step {
        SEND, MULTICAST, SEND_UNHEARD, MULTICAST_UNHEARD, REPLAY, BOOT, LOSE_POWER, ERASE, BACK_UP, RESTORE, REPLACE,
        PROVISION, COPY_KEYRING, PROVISION_BY_COPY, RENEW_KEYS, RESTART_HOST, SET_CLOCK, WAIT
    }

    private static final List<Step> OFTEN = Stream.concat(Stream.of(Step.values()),
            Stream.of(Step.SEND, Step.SEND, Step.MULTICAST, Step.MULTICAST, Step.REPLAY, Step.REPLAY, Step.PROVISION,
                    Step.PROVISION, Step.RENEW_KEYS))
            .toList();

    /** Violations of the properties that must hold. */
    final List<String> wrong = new ArrayList<>();
    final List<String> steps = new ArrayList<>();

    private final Random random;
    private final boolean certified;
    /** Whether hosts have more notes than the keyring that is used. */
    private final boolean noted;
    private final Path folder;
    private final Path keyring;
    private final Path copy;
    private final Path folderBefore = DeviceNotes.named().folder();
    private final VirtualClock clock = new VirtualClock();
    private final FakeAir air = new FakeAir(this);
    private final Map<Address, FakeBoard> boards = new HashMap<>();
    private final Map<Address, Host> hosts = new LinkedHashMap<>();
    private final Map<Address, List<FakeBoard.Eeprom>> images = new HashMap<>();
    private final List<FakeAir.Sealed> recorded = new ArrayList<>();
    private final Map<List<Object>, Bytes> sealed = new HashMap<>();
    private final Set<List<Object>> taken = new HashSet<>();
    /** Devices whose boards may have lost what they had. */
    private final Set<Address> lost = new HashSet<>();
    /** By device, the keys that an older copy of its EEPROM has brought back: they take recordings (SECURITY, Keys). */
    private final Map<String, Set<Bytes>> restored = new HashMap<>();
    private Duration wrongBy = Duration.ZERO;
    private int said;

    private record Host(AgentHost agent, BoardKeyAgreement agreement, Time.Timer clock) {
    }

    /**
     * Begins one.
     *
     * @param folder     its own folder.
     * @param identities the folder of the devices' identities; nothing where they have no certificates.
     */
    KeySequence(long seed, Path folder, Optional<Path> identities) throws IOException, JavinoException {
        random = new Random(seed);
        this.folder = Files.createDirectories(folder);
        keyring = folder.resolve("keyring");
        copy = folder.resolve("copy");
        if (identities.isPresent()) {
            for (Address device : DEVICES) {
                String name = device + ".identity";
                Files.copy(identities.get().resolve(name), folder.resolve(name), StandardCopyOption.COPY_ATTRIBUTES);
            }
        }
        certified = identities.isPresent();
        boolean mixed = certified && random.nextBoolean();
        Keyring keys = new Keyring();
        for (int i = 0; i < DEVICES.size(); i++) {
            Address other = DEVICES.get((i + 1) % DEVICES.size());
            if (!certified || mixed && random.nextBoolean()) {
                keys.add(Keyring.Members.pair(DEVICES.get(i), other), key());
            }
        }
        if (!certified || mixed && random.nextBoolean()) {
            keys.add(Keyring.Members.group(GROUP), key());
        }
        PrivateFile.create(keyring, keys.format());
        PrivateFile.create(copy, keys.format());
        System.setProperty(BoardKeyAgreement.FOLDER_PROPERTY, folder.toString());
        noted = certified || random.nextBoolean();
        if (noted) {
            System.setProperty(KeyringNotes.PROPERTY, keyring.toString());
        }
        DEVICES.forEach(device -> boards.put(device, board(device)));
    }

    private Key key() {
        byte[] bytes = new byte[Key.LENGTH];
        random.nextBytes(bytes);
        return Key.of(Bytes.copyOf(bytes));
    }

    private FakeBoard board(Address device) {
        FakeBoard board = new FakeBoard(device + " " + folder.getFileName()).join(air);
        board.eraseEeprom();
        board.reset();
        return board;
    }

    /** Takes all its steps, or as many until something is wrong. */
    void run() throws IOException, InterruptedException {
        for (Address device : DEVICES) {
            provision(device, keyring);
        }
        // Most befalls one of them: what goes wrong takes several steps with the same board.
        Address victim = DEVICES.get(random.nextInt(DEVICES.size()));
        for (int i = random.nextInt(MOST_STEPS); i >= 0 && wrong.isEmpty(); i--) {
            Address any = DEVICES.get(random.nextInt(DEVICES.size()));
            step(OFTEN.get(random.nextInt(OFTEN.size())), random.nextInt(3) == 0 ? any : victim);
        }
    }

    private void step(Step step, Address device) throws IOException, InterruptedException {
        steps.add(step + " " + device);
        // Without notes hosts go by their clocks, which tell minutes.
        settle(noted ? random.nextInt(2) * MINUTE : 2 * MINUTE);
        FakeBoard board = boards.get(device);
        if (step == Step.ERASE || step == Step.REPLACE || step == Step.RESTORE) {
            lost.add(device);
        }
        switch (step) {
            case SEND -> send(device, other(device), true);
            case MULTICAST -> send(device, GROUP, true);
            case SEND_UNHEARD -> send(device, other(device), false);
            case MULTICAST_UNHEARD -> send(device, GROUP, false);
            case REPLAY -> {
                if (!recorded.isEmpty()) {
                    FakeAir.Sealed old = recorded.get(random.nextInt(recorded.size()));
                    steps.add(old.toString());
                    air.replay(old);
                }
            }
            case BOOT -> board.reset();
            case LOSE_POWER -> board.load(board.eeprom());
            case ERASE -> {
                board.eraseEeprom();
                board.reset();
            }
            case BACK_UP -> images.computeIfAbsent(device, none -> new ArrayList<>()).add(board.eeprom());
            case RESTORE -> {
                List<FakeBoard.Eeprom> old = images.getOrDefault(device, List.of());
                if (!old.isEmpty()) {
                    FakeBoard.Eeprom image = old.get(random.nextInt(old.size()));
                    restored.computeIfAbsent(device.toString(), none -> new HashSet<>()).addAll(image.checks());
                    board.load(image);
                }
            }
            case REPLACE -> {
                stop(device);
                board.leave();
                boards.put(device, board(device));
            }
            case PROVISION -> provision(device, keyring);
            case COPY_KEYRING -> Files.copy(keyring, copy, StandardCopyOption.REPLACE_EXISTING,
                    StandardCopyOption.COPY_ATTRIBUTES);
            case PROVISION_BY_COPY -> {
                // Nobody can know what no note tells (SECURITY, Keys).
                if (noted || !lost.contains(device)) {
                    provision(device, copy);
                }
            }
            case RENEW_KEYS -> ProvisioningHost.renew(keyring, device);
            case RESTART_HOST -> stop(device);
            case SET_CLOCK -> wrongBy = Duration.ofDays(noted ? WRONG_DAYS[random.nextInt(WRONG_DAYS.length)] : 0);
            case WAIT -> settle(random.nextInt((int) MINUTE));
        }
        host(device).agent.awaitBoard();
        settle(0);
    }

    private Address other(Address device) {
        int at = DEVICES.indexOf(device);
        return DEVICES.get((at + 1 + random.nextInt(DEVICES.size() - 1)) % DEVICES.size());
    }

    private void send(Address from, Address to, boolean isHeard) throws InterruptedException {
        for (Address device : DEVICES) {
            host(device);
        }
        air.setContact(isHeard);
        CompletableFuture<Outcome> end =
                host(from).agent.transmit(to, new Content(Performative.TELL, "x" + said++)).end();
        long until = clock.passed() + PATIENCE;
        host(from).agent.awaitBoard();
        settle(0);
        while (!end.isDone() && clock.passed() < until) {
            settle(MINUTE / 60);
            host(from).agent.awaitBoard();
        }
        air.setContact(true);
        steps.add(end.isDone() ? end.handle((how, thrown) -> "" + (thrown == null ? how : thrown)).join() : "open");
    }

    private Host host(Address device) {
        return hosts.computeIfAbsent(device, id -> {
            Time.Timer own = clock.timer("host", e -> {});
            BoardKeyAgreement agreement = new BoardKeyAgreement(folder, own, clock);
            Host host = new Host(new AgentHost(boards.get(id).port, id, time(), agreement), agreement,
                    own);
            if (!host.agent.isOnline()) {
                wrong.add(device + " is off");
            }
            // Its wish to hear the radio is behind what made it online.
            host.agent.awaitBoard();
            return host;
        });
    }

    private void stop(Address device) {
        Host host = hosts.remove(device);
        if (host != null) {
            host.clock.close();
            host.agent.close();
        }
    }

    private void provision(Address device, Path keys) {
        stop(device);
        steps.add(ProvisioningHost.provision(boards.get(device).port, device, keys, time()));
    }

    /** The time by the computers' clocks. */
    private BoundedClock time() {
        return BoundedClock.at(clock.instant().plus(wrongBy));
    }

    /** Lets that much time pass, and all that comes of it. */
    private void settle(long millis) throws InterruptedException {
        long until = clock.passed() + millis;
        do {
            clock.advance(until);
            boolean busy = true;
            while (busy) {
                for (Map.Entry<Address, Host> each : hosts.entrySet()) {
                    if (certified) {
                        each.getValue().agent.awaitBoard();
                    }
                    boards.get(each.getKey()).mail.awaitQuiet();
                }
                busy = clock.runDue();
            }
        } while (clock.passed() < until);
    }

    // On any thread, one after the other:

    @Override
    public void sealed(FakeAir.Sealed message) {
        recorded.add(message);
        Bytes before = sealed.putIfAbsent(
                List.of(message.key(), message.origin(), message.destination(), message.nonce()), message.content());
        if (before != null && !before.equals(message.content())) {
            wrong.add("a nonce twice: " + message + ", and " + before);
        }
    }

    @Override
    public void taken(FakeBoard board, FakeAir.Sealed message) {
        boolean isOlder = restored.getOrDefault(board.rfId(), Set.of()).contains(message.key());
        if (!taken.add(List.of(board.rfId(), message)) && !isOlder) {
            wrong.add(board.rfId() + " took twice " + message);
        }
    }

    @Override
    public void close() {
        List.copyOf(hosts.keySet()).forEach(this::stop);
        System.clearProperty(KeyringNotes.PROPERTY);
        System.setProperty(BoardKeyAgreement.FOLDER_PROPERTY, folderBefore.toString());
    }
}
