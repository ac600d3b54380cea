package live;

import com.google.gson.JsonObject;
import jason.runtime.RuntimeServicesFactory;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.logging.LogManager;

/**
 * Runs a MAS by its platform, Jason's or JaCaMo's, with all of its agents observed, also those that are made or arrive
 * later: what they believe and intend, what their boards do, count and print, their words and warnings are events, and
 * while somebody watches what they decide. They go to the page's server, which listens at the socket that the property
 * {@code javino.live} names.
 */
public final class ObservedMas {

    private static final String SOCKET = "javino.live";
    /** The field of the command {@code record}. */
    private static final String ON = "on";
    private static volatile ObservedMas current;

    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread thread = new Thread(task, "observer");
        thread.setDaemon(true);
        return thread;
    });
    private final Consumer<String> out;
    private final Map<String, ObservedAgent> agents = new ConcurrentHashMap<>();
    private volatile boolean records;

    /** @param out takes each event. */
    ObservedMas(Consumer<String> out) {
        this.out = out;
    }

    /** The one that observes the agents of this program. */
    static ObservedMas current() {
        return current;
    }

    /**
     * Runs a MAS.
     *
     * @param arguments the main class of the platform, such as {@code jason.infra.local.RunLocalMAS} or
     *                  {@code jacamo.infra.JaCaMoLauncher}, and its arguments.
     */
    public static void main(String[] arguments) throws Exception {
        observeBy(Path.of(System.getProperty(SOCKET, "build/live")));
        try {
            Class.forName(arguments[0]).getMethod("main", String[].class).invoke(null,
                    (Object) Arrays.copyOfRange(arguments, 1, arguments.length));
        } catch (InvocationTargetException e) {
            throw e.getCause() instanceof Exception cause ? cause : e;
        }
    }

    private static void observeBy(Path socket) {
        try {
            CompletableFuture<ObservedMas> mas = new CompletableFuture<>();
            PageLink page = PageLink.connect(socket, command -> mas.thenCompose(made -> made.perform(command)));
            ObservedMas made = new ObservedMas(page::tell);
            // The platform has its services when it configures its log, and no agents yet.
            LogManager.getLogManager().addConfigurationListener(() -> {
                LogEvents.beside(page::tell);
                made.begin();
            });
            mas.complete(made);
            page.read();
        } catch (IOException e) {
            System.err.println("the page cannot be told of the agents, as nobody listens at " + socket + ": "
                    + e.getMessage());
        }
    }

    /** Has the platform make an {@link ObservedAgent} for each agent from now on. */
    void begin() {
        if (current == this) {
            return;
        }
        current = this;
        try {
            RuntimeServicesFactory.get().registerDefaultAgArch(ObservedAgent.class.getName());
        } catch (RemoteException none) {
            throw new IllegalStateException(none);
        }
        clock.scheduleWithFixedDelay(() -> agents.values().forEach(ObservedAgent::count), 1, 1, TimeUnit.SECONDS);
    }

    /** Ends what {@link #begin} has begun. */
    void end() {
        clock.shutdownNow();
    }

    Consumer<String> out() {
        return out;
    }

    /** Whether what agents decide is told. */
    boolean records() {
        return records;
    }

    void begun(ObservedAgent agent) {
        agents.put(agent.getAgName(), agent);
        out.accept(Events.json("event", "agent", "agent", agent.getAgName()));
    }

    void ended(ObservedAgent agent) {
        if (agents.remove(agent.getAgName(), agent)) {
            out.accept(Events.json("event", "agent", "agent", agent.getAgName(), "ended", true));
        }
    }

    /** Does what the page asks of an agent, or of its board. */
    CompletableFuture<?> perform(JsonObject command) {
        if (command.has(ON)) {
            records = command.get(ON).getAsBoolean();
            agents.values().forEach(each -> each.getTS().getAgArch().wakeUpSense());
            return CompletableFuture.completedFuture(null);
        }
        String name = Events.text(command, "agent");
        ObservedAgent agent = agents.get(name);
        if (agent == null) {
            throw new IllegalArgumentException("there is no agent " + name);
        }
        return PageCommands.perform(command, agent.getTS());
    }
}
