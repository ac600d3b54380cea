package campaign;

import harness.Certificates;
import harness.Stranger;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import javino.protocol.Address;
import javino.protocol.Content;

/** Two hosts that have certificates and no common key. */
final class StrangerPair implements AutoCloseable {

    /** In emulated seconds: what takes longer counts as lost. */
    static final double PATIENCE = 90;

    private static final double REST = 6;

    private final Field field;
    private final Timetable time;
    private final Field.Post one;
    private final Field.Post other;
    private final EmulatedClock firstClock;
    private final EmulatedClock secondClock;
    private final Stranger first;
    private final Stranger second;
    private final Map<String, Double> came = new ConcurrentHashMap<>();
    private int count;
    private CompletableFuture<Void> fault;

    StrangerPair(Field field, Timetable time, Field.Post one, Field.Post other, Certificates authority)
            throws IOException {
        this.field = field;
        this.time = time;
        this.one = one;
        this.other = other;
        Path identities = field.folder().resolve("identities");
        authority.enroll(one.address().toString(), identities);
        authority.enroll(other.address().toString(), identities);
        firstClock = new EmulatedClock(time);
        secondClock = new EmulatedClock(time);
        first = new Stranger(field.link(one), one.address(), identities, firstClock, this::take);
        second = new Stranger(field.link(other), other.address(), identities, secondClock, this::take);
    }

    private synchronized void take(Content content) {
        came.putIfAbsent(content.toString(), time.now());
        notifyAll();
    }

    /** Nothing is under way, and a host answers the other one again: it does so once in 5 s (SPEC 11.4). */
    void rest() throws InterruptedException {
        time.await(time.now() + REST, field.emulator().process());
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

    /** That befalls one of the two boards in so many emulated seconds. */
    void later(double seconds, String what, boolean toFirst) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        fault = done;
        time.at(time.now() + seconds, () -> {
            befall(what, toFirst);
            done.complete(null);
        });
    }

    /** It has befallen. */
    void awaitFault() {
        fault.join();
    }

    /** Says something, until it has come; nothing if it does not. How long it took, in emulated seconds. */
    OptionalDouble speak() throws InterruptedException {
        double begun = time.now();
        while (time.now() < begun + PATIENCE) {
            OptionalDouble took = speakOnce(begun + PATIENCE);
            if (took.isPresent()) {
                return OptionalDouble.of(took.getAsDouble() - begun);
            }
        }
        return OptionalDouble.empty();
    }

    private OptionalDouble speakOnce(double end) throws InterruptedException {
        Content content = Content.parse("tell;hello(" + count++ + ")");
        Address to = other.address();
        try {
            first.say(to, content).end().get();
        } catch (ExecutionException failed) {
            return OptionalDouble.empty();
        }
        return await(content.toString(), end);
    }

    /** What ends as undelivered may have come all the same. */
    private synchronized OptionalDouble await(String content, double end) throws InterruptedException {
        double soon = Math.min(end, time.now() + 0.5);
        while (!came.containsKey(content) && time.now() < soon) {
            wait(20);
        }
        Double when = came.get(content);
        return when == null ? OptionalDouble.empty() : OptionalDouble.of(when);
    }

    /** Keys that both hosts have given their boards. */
    long keysSet() {
        return first.count("strangersKeysSet") + second.count("strangersKeysSet");
    }

    /** Milliseconds of the CPU that both hosts' threads have used. */
    double cpu() {
        return firstClock.used() + secondClock.used();
    }

    String warnings() {
        return first.warnings() + " " + second.warnings();
    }

    @Override
    public void close() {
        first.close();
        second.close();
        firstClock.close();
        secondClock.close();
    }
}
