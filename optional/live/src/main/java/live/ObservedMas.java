package live;

import com.google.gson.JsonObject;
import diffuser.Diffuser;
import jason.asSemantics.TransitionSystem;
import jason.infra.local.BaseLocalMAS;
import jason.infra.local.LocalAgArch;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.logging.LogManager;

/**
 * Runs a MAS by its platform, Jason's or JaCaMo's, with all of its agents observed, also those that are made or arrive
 * later: what they believe and intend, what their boards do, count and print, and warnings are events. They go to the
 * page's server, which listens at the socket that the property {@code javino.live} names; without it to standard
 * output, each in a line that begins with a brace.
 */
public final class ObservedMas {

    private static final String SOCKET = "javino.live";
    private static final long MILLIS_FROM_LOOK_TO_LOOK = 50;
    private static final int LOOKS_A_COUNT = 20;

    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread thread = new Thread(task, "observer");
        thread.setDaemon(true);
        return thread;
    });
    private final Consumer<String> out;
    private final Map<LocalAgArch, ObservedAgent> observed = new HashMap<>();
    private final Map<String, ObservedAgent> byName = new ConcurrentHashMap<>();
    private int looks;

    /** @param out takes each event. */
    ObservedMas(Consumer<String> out) {
        this.out = out;
    }

    /**
     * Runs a MAS.
     *
     * @param arguments the main class of the platform, such as {@code jason.infra.local.RunLocalMAS} or
     *                  {@code jacamo.infra.JaCaMoLauncher}, and its arguments.
     */
    public static void main(String[] arguments) throws Exception {
        String socket = System.getProperty(SOCKET);
        if (socket == null) {
            ObservedMas mas = new ObservedMas(System.out::println);
            LogManager.getLogManager().addConfigurationListener(() -> LogEvents.instead(mas.out));
            mas.begin();
        } else {
            observeBy(Path.of(socket));
        }
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
            mas.complete(new ObservedMas(page::tell));
            LogManager.getLogManager().addConfigurationListener(() -> LogEvents.beside(page::tell));
            mas.join().begin();
        } catch (IOException e) {
            System.err.println("the page cannot be told of the agents, as nobody listens at " + socket + ": "
                    + e.getMessage());
        }
    }

    /** Begins to look for agents. */
    void begin() {
        clock.scheduleWithFixedDelay(this::look, 0, MILLIS_FROM_LOOK_TO_LOOK, TimeUnit.MILLISECONDS);
    }

    /** Ends what {@link #begin} has begun. */
    void end() {
        clock.shutdownNow();
    }

    private void look() {
        BaseLocalMAS mas = BaseLocalMAS.getRunner();
        if (mas == null) {
            return;
        }
        Map<String, LocalAgArch> all = Map.copyOf(mas.getAgs());
        for (LocalAgArch agent : all.values()) {
            if (agent.getTS() != null && !observed.containsKey(agent)) {
                observed.put(agent, observe(agent.getTS()));
            }
        }
        for (Iterator<LocalAgArch> each = observed.keySet().iterator(); each.hasNext();) {
            LocalAgArch agent = each.next();
            if (all.get(agent.getAgName()) != agent) {
                byName.remove(agent.getAgName(), observed.get(agent));
                out.accept(Events.json("event", "agent", "agent", agent.getAgName(), "ended", true));
                each.remove();
            }
        }
        if (looks++ % LOOKS_A_COUNT == 0) {
            observed.values().forEach(ObservedAgent::count);
        }
    }

    private ObservedAgent observe(TransitionSystem ts) {
        String name = ts.getAgArch().getAgName();
        Optional<Diffuser> diffuser = Diffuser.find(ts.getAgArch());
        ObservedAgent agent = new ObservedAgent(name, diffuser, out);
        byName.put(name, agent);
        out.accept(Events.json("event", "agent", "agent", name));
        ts.runAtBeginOfNextCycle(() -> ts.getAgArch().insertAgArch(agent));
        ts.getAgArch().wakeUpSense();
        return agent;
    }

    /** Does what the page asks of an agent, or of its board. */
    CompletableFuture<?> perform(JsonObject command) {
        String name = Events.text(command, "agent");
        ObservedAgent agent = byName.get(name);
        if (agent == null) {
            throw new IllegalArgumentException("there is no agent " + name);
        }
        return PageCommands.perform(command, agent.getTS());
    }
}
