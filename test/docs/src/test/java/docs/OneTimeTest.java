package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.LocalDate;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Hosts ask their {@code Time}, and not the computer, for time, random numbers, threads and waits: a simulation could
 * not give them else, and tests in emulated time could not wait for them. What asks the computer all the same is in a
 * table, with the reason.
 */
class OneTimeTest {

    private static final String TABLE = "test/docs/src/test/resources/docs/real-time.txt";

    /** Of the other modules only what tests use with boards. */
    private static final Pattern ALL_BUT =
            Pattern.compile("gateway/(Broker|Gateway|GatewayCommand)\\b.*");

    /** What asks the computer: owner, member and descriptor; or a class alone. */
    private static final Pattern REAL = Pattern.compile(String.join("|",
            "java/lang/System\\.(nanoTime|currentTimeMillis) .*", "java/util/Date\\.<init> \\(\\)V",
            "java/time/\\w+\\.now .*", "java/time/(Clock|InstantSource)\\.(system|tick).*",
            "java/security/SecureRandom\\.(<init>|getInstance).*", "java/util/Random\\.<init> .*",
            "java/util/concurrent/ThreadLocalRandom.*", "java/util/SplittableRandom.*", "java/lang/Math\\.random .*",
            "java/util/random/RandomGenerator\\.(of|getDefault) .*", "java/util/UUID\\.randomUUID .*",
            "(java/security/KeyPairGenerator\\.initialize|javax/crypto/KeyGenerator\\.init"
                    + "|java/security/Signature\\.initSign) (?!.*SecureRandom).*",
            "java/lang/Thread\\.(<init>|sleep|of\\w+|startVirtualThread|join|yield|onSpinWait) .*",
            "java/lang/Object\\.(wait|notify|notifyAll) .*",
            "java/util/concurrent/TimeUnit\\.(timedWait|timedJoin|sleep) .*",
            "java/util/concurrent/locks/(LockSupport\\.park|Condition\\.await).*",
            "java/util/concurrent/CompletableFuture\\.(orTimeout|completeOnTimeout|delayedExecutor|join|get) .*",
            "java/util/concurrent/\\w+\\.\\w+Async (?!.*/Executor;).*", "java/util/concurrent/(\\w*Future)\\.get .*",
            "java/util/[\\w/]+\\.(parallel|parallelStream) .*", "java/util/Timer\\w*",
            "java/util/concurrent/(Executors|\\w+PoolExecutor|ForkJoin\\w+|ExecutorCompletionService)",
            "java/util/concurrent/(\\w*Blocking\\w+|SynchronousQueue|\\w*TransferQueue|DelayQueue)",
            "java/util/concurrent/(Semaphore|CountDownLatch|CyclicBarrier|Phaser|Exchanger)",
            "javino/link/Time\\.REAL .*", "javino/keyring/BoundedClock\\.SYSTEM .*"));

    private static final int CLASS = 7;

    /** What a class names: classes, and members with their owners and descriptors. */
    private static Stream<String> named(InputStream bytes) throws IOException {
        DataInputStream in = new DataInputStream(bytes);
        in.skipNBytes(8);
        int count = in.readUnsignedShort();
        int[] tags = new int[count];
        int[] first = new int[count];
        int[] second = new int[count];
        String[] texts = new String[count];
        for (int i = 1; i < count; i++) {
            tags[i] = in.readUnsignedByte();
            switch (tags[i]) {
                case 1 -> texts[i] = in.readUTF();
                case 3, 4 -> in.skipNBytes(4);
                case 5, 6 -> {
                    in.skipNBytes(8);
                    i++;
                }
                case CLASS, 8, 16, 19, 20 -> first[i] = in.readUnsignedShort();
                case 15 -> in.skipNBytes(3);
                case 9, 10, 11, 12, 17, 18 -> {
                    first[i] = in.readUnsignedShort();
                    second[i] = in.readUnsignedShort();
                }
                default -> throw new IOException("no constant has the tag " + tags[i]);
            }
        }
        return IntStream.range(1, count).mapToObj(i -> switch (tags[i]) {
            case CLASS -> texts[first[i]];
            case 9, 10, 11 -> texts[first[first[i]]] + "." + texts[first[second[i]]] + " " + texts[second[second[i]]];
            default -> null;
        }).filter(Objects::nonNull);
    }

    /** What a class asks of the computer: the name of the class, and what it asks, as the table has both. */
    private static Set<String> real(String file, InputStream bytes) throws IOException {
        String outermost = file.replaceFirst("([$].*)?\\.class$", "").replace('/', '.');
        return named(bytes).filter(each -> REAL.matcher(each).matches())
                .map(each -> outermost + "  " + each.replaceFirst(" .*", "").replaceFirst(".*/", ""))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    @Test
    void hostsAndTestsInEmulatedTime_askTheirTimeOnly_butForWhatIsInTheTable() throws IOException {
        Set<String> found = new TreeSet<>(ofTestsInEmulatedTime());
        for (String jar : System.getProperty("javino.hosts").split(File.pathSeparator)) {
            try (JarFile classes = new JarFile(jar)) {
                for (JarEntry each : classes.stream().filter(entry -> entry.getName().endsWith(".class"))
                        .filter(entry -> !ALL_BUT.matcher(entry.getName()).matches()).toList()) {
                    found.addAll(real(each.getName(), classes.getInputStream(each)));
                }
            }
        }
        List<String[]> rows = Repository.text(TABLE).lines().filter(line -> !line.startsWith("#"))
                .map(line -> line.split(" {2,}")).toList();
        assertEquals(List.of(), rows.stream().filter(row -> row.length != 3).map(row -> row[0]).toList(),
                "each row has a class, what it asks, and the reason");
        assertEquals(rows.stream().map(row -> row[0] + "  " + row[1]).collect(Collectors.joining("\n")),
                String.join("\n", found), "ask javino.link.Time, or give a reason in " + TABLE);
    }

    /** What the tests ask that are in emulated time, and all classes of tests that they name, and so on. */
    private static Set<String> ofTestsInEmulatedTime() throws IOException {
        List<Path> folders = Stream.of(System.getProperty("javino.emulated").split(File.pathSeparator)).map(Path::of)
                .filter(Files::isDirectory).toList();
        Set<String> seen = new TreeSet<>();
        Deque<Path> left = new ArrayDeque<>();
        for (Path folder : folders) {
            for (Path each : Repository.files(folder.toString(), ".class")) {
                if (Files.readString(each, StandardCharsets.ISO_8859_1).contains("Lharness/InEmulatedTime;")) {
                    left.add(each);
                }
            }
        }
        assertFalse(left.isEmpty());
        Set<String> asked = new TreeSet<>();
        for (Path next = left.poll(); next != null; next = left.poll()) {
            String name = next.getParent().getFileName() + "/" + next.getFileName();
            if (seen.add(name)) {
                try (InputStream bytes = Files.newInputStream(next)) {
                    asked.addAll(real(name, bytes));
                }
                try (InputStream bytes = Files.newInputStream(next)) {
                    for (String named : named(bytes).toList()) {
                        folders.stream().map(folder -> folder.resolve(named + ".class")).filter(Files::exists)
                                .forEach(left::add);
                    }
                }
            }
        }
        return asked;
    }

    /** In emulated time no threads race. */
    @Test
    void testsInEmulatedTime_runOneInRealTime_unlessAllAreTooLong() {
        List<String> others = new ArrayList<>();
        for (Path file : Repository.files("test", "Test.java")) {
            String text = Repository.text(file);
            if (text.contains("\n@InEmulatedTime\n") && !text.contains("\n@Tag(\"soak\")\n")) {
                long all = count(text, "    @(Parameterized|Repeated)?Test\\b");
                long tooLong = count(text, "    @Tag\\(\"soak\"\\)");
                if (count(text, "    @Tag\\(\"verify\"\\)") != (all == tooLong ? 0 : 1)) {
                    others.add(file.getFileName().toString());
                }
            }
        }
        assertEquals(List.of(), others, "one of its methods has @Tag(\"verify\")");
    }

    private static long count(String text, String pattern) {
        return Pattern.compile("(?m)^" + pattern).matcher(text).results().count();
    }

    /** Asks in each way. */
    private static final class Asking {

        private final LinkedBlockingQueue<Object> queue = new LinkedBlockingQueue<>();

        synchronized void ask(CompletableFuture<Object> future) throws Exception {
            queue.add(System.nanoTime() + System.currentTimeMillis());
            queue.add(List.of(LocalDate.now(), new SecureRandom(), new Thread(this::notifyAll)));
            CompletableFuture.supplyAsync(queue::poll).orTimeout(1, TimeUnit.SECONDS).join();
            CompletableFuture.runAsync(() -> {}, Runnable::run);
            future.completeOnTimeout(null, 1, TimeUnit.SECONDS).get();
            Thread.currentThread().interrupt();
            wait();
        }
    }

    /** What of a class path has the seeded time. */
    private static List<URL> seeded(String classPath) throws IOException {
        List<URL> urls = new ArrayList<>();
        for (String entry : classPath.split(File.pathSeparator)) {
            urls.add(Path.of(entry).toUri().toURL());
        }
        try (URLClassLoader all = new URLClassLoader(urls.toArray(URL[]::new), null)) {
            return Collections.list(all.findResources("lockstep/Simulation.class"));
        }
    }

    private static List<String> buildFilesWith(String words) {
        return Stream.of("build.gradle", "javino.gradle").flatMap(name -> Repository.files("", name).stream())
                .filter(file -> Repository.text(file).contains(words))
                .map(file -> Repository.ROOT.relativize(file).toString()).sorted().toList();
    }

    /** Keys of the seeded time can be guessed. */
    @Test
    void seededTime_isPartOfTestsAlone() throws IOException {
        assertEquals(1, seeded(System.getProperty("javino.seeded")).size());
        assertEquals(List.of(), seeded(System.getProperty("javino.products")));
        assertEquals(List.of("optional/features/build.gradle", "test/harness/build.gradle"),
                buildFilesWith("':test:lockstep'").stream().filter(file -> !file.startsWith("test/docs/")).toList());
        // Of a project that javino new writes, its tests alone.
        List<String> projects = Stream.of("imported", "jacamo", "jason")
                .map(kind -> "javino-java/cli/src/main/resources/javino/cli/project/" + kind + "/build.gradle")
                .toList();
        assertEquals(projects, buildFilesWith("org.javino:features"));
        projects.stream().flatMap(file -> Repository.text(file).lines())
                .filter(line -> line.contains("org.javino:features"))
                .forEach(line -> assertTrue(line.strip().startsWith("testImplementation "), line));
        Pattern times = Pattern.compile("(implements|extends) (\\w+, )*(Time|RealTime)\\b(?!\\.)");
        List<String> kinds = Repository.files(".", ".java").stream()
                .map(file -> file.normalize()).filter(file -> !file.toString().contains("/src/test/"))
                .filter(file -> times.matcher(Repository.text(file)).find())
                .map(file -> Repository.ROOT.relativize(file).toString()).sorted().toList();
        assertEquals(List.of("javino-java/board/src/main/java/javino/link/RealTime.java",
                "test/lockstep/src/main/java/lockstep/Simulation.java"), kinds);
    }

    @Test
    void real_ofAClassThatAsks_tellsAllThatItAsks() throws IOException {
        String file = Asking.class.getName().replace('.', '/') + ".class";
        try (InputStream bytes = Asking.class.getClassLoader().getResourceAsStream(file)) {
            assertEquals(Stream.of("CompletableFuture.completeOnTimeout", "CompletableFuture.get",
                    "CompletableFuture.join", "CompletableFuture.orTimeout", "CompletableFuture.supplyAsync",
                    "LinkedBlockingQueue", "LocalDate.now", "Object.notifyAll", "Object.wait", "SecureRandom.<init>",
                    "System.currentTimeMillis", "System.nanoTime", "Thread.<init>")
                    .map(each -> "docs.OneTimeTest  " + each).collect(Collectors.toCollection(TreeSet::new)),
                    real(file, bytes));
        }
    }
}
