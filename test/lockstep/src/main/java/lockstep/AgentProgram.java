package lockstep;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.stream.Stream;

/**
 * A {@code .mas2j} in the time of a simulation: its agents' cycles are done by the coordinator. Jason and all that
 * knows it are loaded anew for each program, as a process of its own would.
 */
public final class AgentProgram implements AutoCloseable {

    /** Is told what agents do, on the coordinator, in the order in which they do it. */
    public interface Observer {

        /** An agent printed, or was warned. */
        void printed(String agent, String line);

        /** A cycle of an agent has added a belief, with its annotations, to its belief base, or removed it. */
        default void believes(String agent, String belief, boolean added) {}

        /** An agent asks its board for an action. */
        default void asksFor(String agent, String action) {}

        /** The action has ended. @param error the atom of its failure; empty if the board has performed it. */
        default void performed(String agent, String action, String error) {}

        /** What an agent decided, and by what: a line of JSON, whose text is made where it is read. */
        default void recorded(Supplier<String> line) {}

        /** Whether {@link #recorded} is to be called. */
        default boolean records() {
            return false;
        }
    }

    /** What a running program says of itself, and is given. */
    public interface Agents {

        /** The agents that there are now. */
        Set<String> agents();

        /** What keeps an agent's plans from being done or waiting; empty if they are. */
        String busy(String agent);

        /** The functors of beliefs for whose addition an agent has plans, with their places. */
        Map<String, String> planned(String agent);

        /** Gives an agent an event, as {@code +!go(home)} or {@code +dark}. */
        void give(String agent, String event) throws IOException;

        /** What an agent's board counts and how its architecture fares, as far as there is any. */
        CompletableFuture<Map<String, Object>> counts(String agent);
    }

    /** What runs the program, loaded with it. It has a constructor without parameters. */
    public interface Runner {

        /**
         * Creates and starts the agents.
         *
         * @throws IOException what is wrong with the program, with file and line, in one line.
         */
        Agents start(Simulation simulation, Path program, Observer observer)
                throws IOException, ReflectiveOperationException;

        /** Stops them. */
        void stop();
    }

    private static final String RUNNER = "lockstep.agents.JasonRunner";
    /** What the programs share with the simulation; Java has its own nowhere else. */
    private static final List<String> SHARED = List.of("java.", "javino.", "lockstep.");
    private static final String OWN = "lockstep.agents.";
    /** The classes of Jason's library that ask Java for time or chance, and what they ask in the place of what. */
    static final Set<String> ASKING = Set.of("jason.functions.Random", "jason.functions.time", "jason.stdlib.date",
            "jason.stdlib.nano_time", "jason.stdlib.random", "jason.stdlib.random$1", "jason.stdlib.set_random_seed",
            "jason.stdlib.shuffle", "jason.stdlib.time", "jason.stdlib.wait$WaitEvent");
    static final Map<String, String> ASKED = Map.of("java/lang/System", "lockstep/agents/Clock",
            "java/util/GregorianCalendar", "lockstep/agents/Clock$Date",
            "java/util/Random", "lockstep/agents/Dice", "java/util/Collections", "lockstep/agents/Dice");
    /** Above the loggers of all agents; a field, as nobody else keeps it. */
    private static final Logger AGENTS = Logger.getLogger("jason");

    private static final class Loader extends URLClassLoader {

        Loader(List<URL> classPath) {
            super("program", classPath.toArray(URL[]::new), AgentProgram.class.getClassLoader());
        }

        @Override
        protected Class<?> findClass(String name) throws ClassNotFoundException {
            if (!ASKING.contains(name)) {
                return super.findClass(name);
            }
            try (InputStream file = findResource(name.replace('.', '/') + ".class").openStream()) {
                byte[] patched = ClassPatch.replace(file.readAllBytes(), ASKED);
                return defineClass(name, patched, 0, patched.length);
            } catch (IOException e) {
                throw new ClassNotFoundException(name, e);
            }
        }

        @Override
        protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
            synchronized (getClassLoadingLock(name)) {
                Class<?> loaded = findLoadedClass(name);
                if (loaded != null) {
                    return loaded;
                }
                if (name.startsWith(OWN) || SHARED.stream().noneMatch(name::startsWith)) {
                    try {
                        return findClass(name);
                    } catch (ClassNotFoundException notHere) {
                        // It is one of Java's.
                    }
                }
                return super.loadClass(name, resolve);
            }
        }
    }

    private final Simulation simulation;
    private final Handler printing;
    private final Loader loader;
    private final Runner runner;
    private Agents agents;

    private AgentProgram(Simulation simulation, Observer observer) throws IOException, ReflectiveOperationException {
        this.simulation = simulation;
        loader = new Loader(classPath());
        printing = new Handler() {
            @Override
            public void publish(LogRecord line) {
                if (Thread.currentThread().getContextClassLoader() == loader) {
                    String logger = line.getLoggerName();
                    observer.printed(logger.substring(logger.lastIndexOf('.') + 1), line.getMessage());
                }
            }

            @Override
            public void flush() {}

            @Override
            public void close() {}
        };
        AGENTS.addHandler(printing);
        runner = (Runner) loader.loadClass(RUNNER).getConstructor().newInstance();
    }

    /**
     * Starts a program.
     *
     * @param program its {@code .mas2j}, which has its sources beside it.
     * @param printed is told each line that an agent prints, behind its name in brackets.
     * @throws IOException why its agents cannot be made.
     */
    public static AgentProgram start(Simulation simulation, Path program, Consumer<String> printed)
            throws IOException {
        return observe(simulation, program, (agent, line) -> printed.accept("[" + agent + "] " + line));
    }

    /** The same with one who is told all that the agents do. */
    public static AgentProgram observe(Simulation simulation, Path program, Observer observer) throws IOException {
        try {
            AgentProgram started = new AgentProgram(simulation, observer);
            try {
                started.inIts(
                        () -> started.agents = started.runner.start(simulation, program.toAbsolutePath(), observer));
                return started;
            } catch (IOException | RuntimeException failed) {
                started.close();
                throw failed;
            }
        } catch (ReflectiveOperationException failed) {
            throw new IOException(program + ": " + failed.getMessage(), failed);
        }
    }

    /** The agents; their methods are called as one of the program's threads would. */
    public Agents agents() {
        return (Agents) Proxy.newProxyInstance(AgentProgram.class.getClassLoader(), new Class<?>[] {Agents.class},
                (proxy, method, arguments) -> {
                    Object[] result = new Object[1];
                    try {
                        inIts(() -> result[0] = method.invoke(agents, arguments));
                    } catch (InvocationTargetException failed) {
                        throw failed.getCause();
                    }
                    return result[0];
                });
    }

    private interface Task {
        void run() throws IOException, ReflectiveOperationException;
    }

    /** Does something as one of the program's threads would. */
    private void inIts(Task task) throws IOException, ReflectiveOperationException {
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        Thread.currentThread().setContextClassLoader(loader);
        try {
            task.run();
        } finally {
            Thread.currentThread().setContextClassLoader(before);
        }
    }

    private static List<URL> classPath() throws MalformedURLException {
        List<URL> urls = new ArrayList<>();
        for (String entry : Stream.of(System.getProperty("java.class.path").split(File.pathSeparator)).toList()) {
            urls.add(Path.of(entry).toUri().toURL());
        }
        return urls;
    }

    /** Ends it where it stands, as SIGKILL does; so it leaves its locks. */
    public void kill() {
        simulation.kill(loader);
        close();
    }

    @Override
    public void close() {
        try (loader) {
            inIts(runner::stop);
            simulation.pause(1);  // What it has left to do at this moment.
            simulation.kill(loader);
        } catch (IOException | ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        } finally {
            AGENTS.removeHandler(printing);
        }
    }
}
