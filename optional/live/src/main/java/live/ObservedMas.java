package live;

import diffuser.Diffuser;
import jason.JasonException;
import jason.asSemantics.TransitionSystem;
import jason.infra.local.LocalAgArch;
import jason.infra.local.RunLocalMAS;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * Jason's {@link RunLocalMAS} whose agents are observed: what they believe and intend, what their boards count and
 * print, and warnings come as events on standard output, each in a line that begins with a brace.
 */
public final class ObservedMas extends RunLocalMAS {

    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread thread = new Thread(task, "counters");
        thread.setDaemon(true);
        return thread;
    });
    private final Consumer<String> out;

    /** @param out takes each event. */
    ObservedMas(Consumer<String> out) {
        this.out = out;
    }

    /** Runs a MAS, with the arguments of {@link RunLocalMAS#main}. */
    public static void main(String[] arguments) throws JasonException {
        ObservedMas mas = new ObservedMas(System.out::println);
        mas.begin(arguments);
        mas.waitEnd();
        mas.finish(0, true, 0);
    }

    /** As Jason begins. */
    void begin(String... arguments) throws JasonException {
        runner = this;
        init(arguments);
        WarningEvents.instead(out);
        registerMBean();
        registerInRMI();
        registerWebMindInspector();
        create();
        start();
    }

    @Override
    protected void createAgs() throws JasonException {
        super.createAgs();
        getAgs().values().forEach(this::observe);
    }

    private void observe(LocalAgArch agent) {
        TransitionSystem ts = agent.getTS();
        ts.getAgArch().insertAgArch(new ObservedAgent(out));
        try {
            Diffuser diffuser = Diffuser.of(ts);
            diffuser.onPrinted(text -> out.accept(Events.json("event", "printed", "text", Events.shortened(text))));
            CountedBoard board = new CountedBoard(diffuser, out);
            clock.scheduleAtFixedRate(board::count, 0, 1, TimeUnit.SECONDS);
        } catch (JasonException withoutBoard) {
            // So there is nothing to be counted.
            return;
        }
    }
}
