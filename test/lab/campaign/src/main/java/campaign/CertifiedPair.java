package campaign;

import harness.Certificates;
import harness.CertifiedHost;
import harness.Host;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Frame;
import javino.protocol.ProtocolException;
import javino.protocol.HostMessage;
import simulation.Attacker;
import trace.TraceEvent;

/** Two hosts that have certificates and no common key. */
final class CertifiedPair implements AutoCloseable {

    /** Emulated seconds after which a message counts as lost. */
    static final double PATIENCE = 90;

    private static final double REST = 6;
    /** Seconds from packet to packet, of which the air takes no more. */
    private static final double EVERY = 0.7;

    private final Field field;
    private final EmulatedTime time;
    private final int cell;
    private final Field.Post one;
    private final Field.Post other;
    private final MeasuredSteps steps = new MeasuredSteps();
    private final CertifiedHost first;
    private final CertifiedHost second;
    private final Map<String, Double> came = new HashMap<>();
    private final List<Frame> heard = new ArrayList<>();
    private final Set<String> said = new HashSet<>();
    private double faultAt;

    /** @param number the pair's in its cell, from 0. */
    CertifiedPair(Field field, EmulatedTime time, int cell, int number, Certificates authority) throws IOException {
        this.field = field;
        this.time = time;
        this.cell = cell;
        one = field.cell(cell).get(2 * number);
        other = field.cell(cell).get(2 * number + 1);
        Path identities = field.folder().resolve("identities");
        authority.enroll(one.address().toString(), identities);
        authority.enroll(other.address().toString(), identities);
        first = new CertifiedHost(field.link(one), one.address(), identities, steps, this::take);
        second = new CertifiedHost(field.link(other), other.address(), identities, steps, this::take);
    }

    private void take(Content content) {
        came.putIfAbsent(content.toString(), time.now());
    }

    /** An attacker hears what its boards send, too. */
    void traced(TraceEvent event) {
        if (event.is("rf-tx", one.name()) || event.is("rf-tx", other.name())) {
            try {
                heard.add(Frame.decode(Bytes.ofHex(event.text("payload"))));
            } catch (ProtocolException fragment) {
                // None of their words is as long.
            }
        }
    }

    /**
     * An attacker who has heard all so far has his say: in the names of both hosts, and of others.
     *
     * @param messages the number of messages that he sends.
     */
    void besiege(Random random, int messages) {
        List<Frame> sealed = heard.stream().filter(frame -> !frame.destination().equals(Address.BROADCAST)).toList();
        Attacker attacker = new Attacker(random, List.of(one.address(), other.address()), (from, to, word) -> {
            boolean replays = !to.equals(Address.BROADCAST) && random.nextBoolean();
            send(replays ? sealed.get(random.nextInt(sealed.size())) : new Frame(to, from, word));
        });
        heard.stream().filter(frame -> HostMessage.isHostMessage(frame.message()))
                .forEach(frame -> attacker.hear(frame.origin(), frame.message()));
        for (int i = 0; i < messages; i++) {
            attacker.act();
            time.pause(EVERY);
        }
    }

    private void send(Frame frame) {
        field.emulator().command(Map.of("do", "send", "position", Field.position(cell), "payload",
                frame.encode().hex()));
    }

    /** The contents of both boards' EEPROMs. */
    List<Bytes> eeproms() {
        List<Bytes> all = new ArrayList<>();
        for (Field.Post post : List.of(one, other)) {
            try {
                all.add(Bytes.copyOf(Files.readAllBytes(field.folder().resolve("eeprom/" + post.name() + ".bin"))));
            } catch (IOException failed) {
                throw new UncheckedIOException(failed);
            }
        }
        return all;
    }

    /** The number of contents that have come and that nobody has said. */
    long strange() {
        return came.keySet().stream().filter(content -> !said.contains(content)).count();
    }

    /** Nothing is under way, and a host answers the other one again: it does so once in 5 s (SPEC 11.3). */
    void rest() {
        time.pause(REST);
        first.awaitQuiet();
        second.awaitQuiet();
    }

    /** Both know nothing of each other any more. */
    void forget() {
        first.forget();
        second.forget();
    }

    /** Something befalls one of the two boards: "reset" or "power-cut". */
    void befall(String what, boolean toFirst) {
        String board = (toFirst ? one : other).name();
        field.emulator().command(what.equals("reset") ? Map.of("do", what, "board", board)
                : Map.of("do", what, "board", board, "duration", 0.3));
    }

    /** The sender's board is reset, and there again. */
    void reset() {
        befall("reset", true);
        first.awaitOnline();
    }

    /** A fault befalls one of the two boards in so many emulated seconds. */
    void later(double seconds, String what, boolean toFirst) {
        faultAt = time.now() + seconds;
        time.at(faultAt, () -> befall(what, toFirst));
    }

    /** The fault has befallen. */
    void awaitFault() {
        time.pause(Math.max(0, faultAt - time.now()));
    }

    /** Sends messages until one has come; nothing if none does. How long it took, in emulated seconds. */
    OptionalDouble deliver() {
        double begun = time.now();
        while (time.now() < begun + PATIENCE) {
            OptionalDouble took = deliverOnce(begun + PATIENCE);
            if (took.isPresent()) {
                return OptionalDouble.of(took.getAsDouble() - begun);
            }
        }
        return OptionalDouble.empty();
    }

    private OptionalDouble deliverOnce(double end) {
        Content content = Content.parse("tell;hello(" + said.size() + ")");
        said.add(content.toString());
        Address to = other.address();
        try {
            Host.await(first.send(to, content).end());
        } catch (ExecutionException failed) {
            return OptionalDouble.empty();
        }
        return await(content.toString(), end);
    }

    /** A message that ends as undelivered may have come all the same. */
    private OptionalDouble await(String content, double end) {
        double soon = Math.min(end, time.now() + 0.5);
        while (!came.containsKey(content) && time.now() < soon) {
            time.pause(0.02);
        }
        Double when = came.get(content);
        return when == null ? OptionalDouble.empty() : OptionalDouble.of(when);
    }

    /** Keys that both hosts have given their boards. */
    long keysSet() {
        return first.count("keyAgreementKeysSet") + second.count("keyAgreementKeysSet");
    }

    /** Milliseconds of the CPU that both hosts have used. */
    double cpu() {
        return steps.used();
    }

    String warnings() {
        return first.warnings() + " " + second.warnings() + " " + steps.failed();
    }

    @Override
    public void close() {
        first.close();
        second.close();
        steps.close();
    }
}
