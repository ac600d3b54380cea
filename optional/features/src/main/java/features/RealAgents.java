package features;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.UncheckedIOException;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import java.util.stream.Stream;

import jason.architecture.AgArch;
import jason.infra.local.BaseLocalMAS;
import jason.infra.local.LocalAgArch;
import jason.infra.local.RunLocalMAS;

import javino.link.Time;

import lockstep.AgentProgram.Agents;
import lockstep.AgentProgram.Observer;
import lockstep.agents.RunningAgents;
import lockstep.agents.Watch;

/**
 * The program of the virtual machine in which agents run in real time, by their platform's launcher. On standard output
 * it tells the test of them, in arrays that begin with a method of {@link Observer}; on standard input it is asked, in
 * arrays that begin with a method of {@link Agents}.
 */
public final class RealAgents {

    /** What an answer begins with; the first is there when all agents are. */
    static final String ANSWER = "answer";
    /** What is recorded of an agent, as text. */
    static final String LINE = "line";
    private static final long LOOK_NANOS = 5 * Window.MILLI;
    private static final int LONGEST_SECONDS = 10;

    private static final Observer OBSERVER = (Observer) Proxy.newProxyInstance(RealAgents.class.getClassLoader(),
            new Class<?>[] {Observer.class}, (proxy, method, words) -> {
                if (method.getReturnType() == boolean.class) {
                    return true;
                }
                boolean line = words[0] instanceof Supplier<?>;
                tell(line ? new Object[] {LINE, ((Supplier<?>) words[0]).get()} : message(method.getName(), words));
                return null;
            });
    private static ObjectOutputStream out;

    private RealAgents() {}

    /** Watches an agent; the agents that it creates have this architecture, too. */
    public static final class Watching extends AgArch {

        private static final long serialVersionUID = 1;

        private transient Watch watch;

        @Override
        public void reasoningCycleFinished() {
            super.reasoningCycleFinished();
            watch = watch == null ? new Watch(this, OBSERVER) : watch;
            watch.cycled();
        }
    }

    /** @param arguments the launcher's class, and its arguments. */
    public static void main(String[] arguments) throws Throwable {
        out = new ObjectOutputStream(new FileOutputStream(FileDescriptor.out));
        System.setOut(System.err);
        Time.REAL.thread("test", RealAgents::watchAll).start();
        MethodHandles.lookup()
                .findStatic(Class.forName(arguments[0]), "main", MethodType.methodType(void.class, String[].class))
                .invoke(Arrays.copyOfRange(arguments, 1, arguments.length));
    }

    static Object[] message(String name, Object[] words) {
        return Stream.concat(Stream.of(name), words == null ? Stream.of() : Stream.of(words)).toArray();
    }

    private static synchronized void tell(Object[] message) {
        try {
            out.writeObject(message);
            out.reset();
            out.flush();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Watches all agents, also those that come later. */
    private static void watchAll() {
        Thread answers = null;
        while (true) {
            if (BaseLocalMAS.getRunner() instanceof RunLocalMAS mas && mas.isRunning()) {
                mas.getAgs().values().forEach(RealAgents::watch);
                if (answers == null) {
                    answers = Time.REAL.thread("test", () -> answer(new RunningAgents(mas)));
                    answers.start();
                }
            }
            Time.REAL.pause(LOOK_NANOS);
        }
    }

    private static void watch(LocalAgArch agent) {
        if (!isWatched(agent)) {
            agent.getTS().runAtBeginOfNextCycle(() -> {
                if (!isWatched(agent)) {
                    agent.insertAgArch(new Watching());
                }
            });
            agent.wake();
        }
    }

    private static boolean isWatched(LocalAgArch agent) {
        return agent.getFirstAgArch().getAgArchClassesChain().contains(Watching.class.getName());
    }

    private static void answer(Agents agents) {
        tell(new Object[] {ANSWER, Set.of()});
        try (ObjectInputStream in = new ObjectInputStream(System.in)) {
            while (true) {
                tell(new Object[] {ANSWER, answer(agents, (Object[]) in.readObject())});
            }
        } catch (IOException | ReflectiveOperationException ended) {
            Runtime.getRuntime().halt(0);  // The test has ended.
        }
    }

    private static Object answer(Agents agents, Object[] question) throws ReflectiveOperationException {
        try {
            Object answer = call(Agents.class, agents, question);
            if (!(answer instanceof CompletableFuture<?> later)) {
                return answer;
            }
            Map<?, ?> counts = (Map<?, ?>) later.get(LONGEST_SECONDS, TimeUnit.SECONDS);
            counts.values().removeIf(each -> !(each instanceof Number));
            return counts;
        } catch (InvocationTargetException | ExecutionException failed) {
            return failed.getCause();
        } catch (TimeoutException | InterruptedException failed) {
            return failed;
        }
    }

    /** Calls the method that a message names. */
    static Object call(Class<?> of, Object object, Object[] message) throws ReflectiveOperationException {
        return Stream.of(of.getMethods()).filter(each -> each.getName().equals(message[0])).findFirst().orElseThrow()
                .invoke(object, Arrays.copyOfRange(message, 1, message.length));
    }
}
