package harness;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.logging.FileHandler;
import java.util.logging.Handler;
import java.util.logging.Logger;
import java.util.logging.SimpleFormatter;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ClassTemplateInvocationContext;
import org.junit.jupiter.api.extension.ClassTemplateInvocationContextProvider;
import org.junit.jupiter.api.extension.Extension;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.TestWatcher;
import lockstep.Simulation;

/** The runs of a class that is {@link InEmulatedTime}: by one seed or several, or one in real time. */
final class SeededRuns implements ClassTemplateInvocationContextProvider {

    /** Where a failed run leaves its traces, its log and what repeats it. */
    private static final Path FAILURES = Path.of("build/failures");
    private static final Logger ROOT = Logger.getLogger("");

    private boolean failed;

    @Override
    public boolean supportsClassTemplate(ExtensionContext context) {
        return true;
    }

    @Override
    public Stream<ClassTemplateInvocationContext> provideClassTemplateInvocationContexts(ExtensionContext context) {
        if (isSet(context, "realTime")) {
            return Stream.of(run("in real time", List.of()));
        }
        long first = number(context, "seed");
        return LongStream.range(first, first + number(context, "seeds")).takeWhile(seed -> !failed)
                .mapToObj(seed -> run("seed " + seed, List.of(new Seeded(seed))));
    }

    /** A property of the program, unless who launches the tests gives another value. */
    private static Optional<String> given(ExtensionContext context, String name) {
        return context.getConfigurationParameter("javino." + name);
    }

    private static boolean isSet(ExtensionContext context, String name) {
        return !given(context, name).orElse("false").equals("false"); // -Pkeep gives an empty value
    }

    private static long number(ExtensionContext context, String name) {
        return given(context, name).map(Long::parseLong).orElse(1L);
    }

    private static ClassTemplateInvocationContext run(String name, List<Extension> extensions) {
        return new ClassTemplateInvocationContext() {
            @Override
            public String getDisplayName(int index) {
                return name;
            }

            @Override
            public List<Extension> getAdditionalExtensions() {
                return extensions;
            }
        };
    }

    private final class Seeded implements BeforeEachCallback, TestWatcher {

        private final long seed;
        private EmulatedRun run;
        private FileHandler log;
        private Handler[] usual;

        Seeded(long seed) {
            this.seed = seed;
        }

        @Override
        public void beforeEach(ExtensionContext test) throws IOException {
            Path folder = FAILURES.resolve(name(test).replace('#', '.') + "-" + seed).toAbsolutePath();
            delete(folder);
            run = new EmulatedRun(seed, Files.createDirectories(folder));
            EmulatedRun.use(run);
            test.getStore(ExtensionContext.Namespace.create(Seeded.class)).put(run, (AutoCloseable) this::end);
            log = new FileHandler(folder.resolve("log").toString());
            log.setFormatter(new SimpleFormatter());
            // Nothing else tells what agents print.
            usual = ROOT.getHandlers();
            List.of(usual).forEach(ROOT::removeHandler);
            ROOT.addHandler(log);
        }

        private static String name(ExtensionContext test) {
            String method = test.getRequiredTestClass().getSimpleName() + "#" + test.getRequiredTestMethod().getName();
            // One of several runs of the method has a name of its own.
            String shown = test.getDisplayName();
            return shown.startsWith("[") ? method + shown.replaceAll("[^\\w]+", "_") : method;
        }

        /** Behind all that the test itself closes. */
        private void end() {
            EmulatedRun.use(null);
            ROOT.removeHandler(log);
            log.close();
            List.of(usual).forEach(ROOT::addHandler);
            if (Simulation.here() instanceof Simulation left) {
                left.close();
                throw new AssertionError("the test has not closed its emulator");
            }
        }

        @Override
        public void testSuccessful(ExtensionContext test) {
            if (!isSet(test, "keep")) {
                delete(run.folder());
            }
        }

        @Override
        public void testFailed(ExtensionContext test, Throwable cause) {
            failed = true;
            String again = "gradle " + given(test, "suite").orElse("test") + " --tests '"
                    + test.getRequiredTestClass().getSimpleName() + "." + test.getRequiredTestMethod().getName()
                    + "' -Pseed=" + seed;
            System.out.println(test.getDisplayName() + " has failed with seed " + seed + ": " + cause
                    + "\nits traces are in " + run.folder() + "\nthis runs it again: " + again);
            try {
                Files.writeString(run.folder().resolve("again"), again + "\n");
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        private static void delete(Path folder) {
            if (!Files.exists(folder)) {
                return;
            }
            try (Stream<Path> all = Files.walk(folder)) {
                for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(each);
                }
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }
}
