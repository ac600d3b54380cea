package lockstep.agents;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.stream.Stream;

import diffuser.Diffuser;
import diffuser.StartFailures;

import jason.JasonException;
import jason.architecture.AgArch;
import jason.asSemantics.Agent;
import jason.asSemantics.Circumstance;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.TransitionSystem;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Plan;
import jason.asSyntax.SourceInfo;
import jason.asSyntax.Trigger;
import jason.infra.local.LocalAgArch;
import jason.infra.local.LocalRuntimeServices;
import jason.infra.local.RunLocalMAS;
import jason.mas2j.AgentParameters;
import jason.mas2j.ClassParameters;
import jason.mas2j.parser.ParseException;
import jason.mas2j.parser.TokenMgrError;
import jason.mas2j.parser.mas2j;
import jason.runtime.RuntimeServicesFactory;
import jason.runtime.Settings;

import lockstep.AgentProgram;
import lockstep.AgentProgram.Observer;
import lockstep.Simulation;

/** Runs Jason's own launcher, but for its threads. */
public final class JasonRunner extends RunLocalMAS implements AgentProgram.Runner {

    private static final String FROM_A_BOARD_ACTION = "/javino/";

    private Simulation simulation;
    private Observer observer;

    /** Agents that come later have no thread either. */
    private final class Services extends LocalRuntimeServices {

        Services() {
            super(JasonRunner.this);
        }

        @Override
        protected LocalAgArch newAgInstance() {
            return new EmulatedAgent(simulation, observer);
        }

        /** Of the creator's architectures this one's are not named: it comes by itself. */
        @Override
        public String createAgent(String name, String source, String type, List<String> architectures,
                ClassParameters beliefs, Settings settings, Agent creator) throws Exception {
            List<String> all = architectures;
            if ((all == null || all.isEmpty()) && creator != null) {
                all = new ArrayList<>(List.of(AgArch.class.getName()));
                all.addAll(creator.getTS().getAgArch().getAgArchClassesChain());
                all.remove(EmulatedAgent.class.getName());
            }
            return super.createAgent(name, source, type, all, beliefs, settings, creator);
        }

        @Override
        public void startAgent(String name) {
            ((EmulatedAgent) getAg(name)).begin();
        }

        @Override
        public boolean killAgent(String name, String killer, int deadline) {
            LocalAgArch agent = getAg(name);
            if (agent == null || !agent.getTS().getAg().killAcc(killer)) {
                return false;
            }
            if (deadline != 0) {
                agent.getTS().getC().addExternalEv(new Trigger(Trigger.TEOperator.add, Trigger.TEType.achieve,
                        ASSyntax.createLiteral("jag_shutting_down", ASSyntax.createNumber(deadline))));
            }
            simulation.at(simulation.nanos() + 1_000_000L * deadline, () -> {
                agent.stopAg();
                delAg(name);
            });
            return true;
        }

        @Override
        public void stopMAS(int deadline, boolean stopJava, int exit) {
            List.copyOf(getAgs().keySet()).forEach(name -> killAgent(name, name, deadline));
        }
    }

    @Override
    public void start(Simulation time, Path program, Observer told) throws IOException, ReflectiveOperationException {
        simulation = time;
        observer = told;
        Field scheduler = Agent.class.getDeclaredField("scheduler");
        scheduler.setAccessible(true);
        scheduler.set(null, new EmulatedScheduler(simulation));
        Clock.set(simulation);
        RuntimeServicesFactory.set(new Services());
        parse(program);
        WrongPrograms wrong = new WrongPrograms();
        Logger.getLogger("").addHandler(wrong);
        try {
            init(new String[] {program.toString(), "--no-net"});
            project.getSourcePaths().addPath(program.getParent().toString());
            project.fixAgentsSrc();
            isRunning = true;
            createEnvironment();
            createAgs();
        } catch (JasonException e) {
            throw new IOException(program + ": " + e.getMessage(), e);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        } finally {
            Logger.getLogger("").removeHandler(wrong);
        }
        wrong.check();
        createdAgents.forEach(agent -> ((EmulatedAgent) agent).begin());
    }

    /** Parses the program beforehand, as Jason would end the virtual machine if it could not. */
    private static void parse(Path program) throws IOException {
        try (InputStream text = Files.newInputStream(program)) {
            new mas2j(text).mas();
        } catch (ParseException | TokenMgrError e) {
            throw wrong("Error parsing file " + program + "!", e);
        }
    }

    /** In the one line that a user's log would have. */
    private static IOException wrong(String message, Throwable thrown) {
        LogRecord logged = new LogRecord(Level.SEVERE, message);
        logged.setThrown(thrown);
        return new IOException(StartFailures.line(logged).orElse(message), thrown);
    }

    /** Keeps the first thing that is wrong with agents and that Jason tells to its log alone. */
    private static final class WrongPrograms extends Handler {

        private String line;

        @Override
        public void publish(LogRecord logged) {
            if (line == null && logged.getLevel() == Level.SEVERE
                    && Thread.currentThread().getContextClassLoader() == JasonRunner.class.getClassLoader()) {
                line = StartFailures.line(logged).orElse(null);
            }
        }

        void check() throws IOException {
            if (line != null) {
                throw new IOException(line);
            }
        }

        @Override
        public void flush() {}

        @Override
        public void close() {}
    }

    @Override
    public Set<String> agents() {
        return new TreeSet<>(getAgs().keySet());
    }

    private TransitionSystem of(String agent) {
        return getAg(agent).getTS();
    }

    @Override
    public Optional<String> busy(String agent) {
        Circumstance circumstance = of(agent).getC();
        Stream<String> asked = circumstance.getPendingIntentions().keySet().stream()
                .filter(key -> key.contains(FROM_A_BOARD_ACTION)).map(key -> "." + key.replaceFirst("/.*", ""));
        Stream<String> acting = circumstance.getPendingActions().values().stream()
                .map(action -> action.getActionTerm().toString());
        Optional<String> waiting = Stream.concat(asked, acting).sorted().findFirst().map(each -> each + " goes on");
        return waiting.isPresent() || of(agent).canSleep() ? waiting : Optional.of("its plans go on");
    }

    @Override
    public Map<String, String> planned(String agent) {
        Map<String, String> planned = new TreeMap<>();
        for (Plan plan : of(agent).getAg().getPL()) {
            Trigger trigger = plan.getTrigger();
            SourceInfo place = plan.getSrcInfo();
            if (trigger.getType() == Trigger.TEType.belief && trigger.isAddition() && place != null
                    && !trigger.getLiteral().isVar()) {
                planned.putIfAbsent(trigger.getLiteral().getPredicateIndicator().toString(),
                        place.getSrcFile().replaceFirst("^(.*/|file:)+", "") + ":" + place.getBeginSrcLine());
            }
        }
        return planned;
    }

    @Override
    public void give(String agent, String event) throws IOException {
        try {
            Trigger trigger = ASSyntax.parseTrigger(event);
            if (trigger.getType() == Trigger.TEType.achieve) {
                of(agent).getC().addEvent(new Event(trigger, Intention.EmptyInt));
            } else if (trigger.isAddition()) {
                of(agent).getAg().addBel(trigger.getLiteral());
            } else {
                of(agent).getAg().delBel(trigger.getLiteral());
            }
            getAg(agent).wake();
        } catch (JasonException | jason.asSyntax.parser.ParseException | jason.asSyntax.parser.TokenMgrError e) {
            throw new IOException(event + " is no goal or belief: " + e.getMessage().lines().findFirst().orElse(""), e);
        }
    }

    @Override
    public CompletableFuture<Map<String, Object>> counts(String agent) {
        Map<String, Object> counts = new TreeMap<>();
        Optional<Diffuser> diffuser = Diffuser.find(getAg(agent).getFirstAgArch());
        if (diffuser.isEmpty()) {
            return CompletableFuture.completedFuture(counts);
        }
        counts.putAll(diffuser.get().getStatus());
        return diffuser.get().counters().handle((board, none) -> {
            if (board != null) {
                board.forEach((counter, value) -> counts.put(counter.toString(), value));
            }
            return counts;
        });
    }

    @Override
    public synchronized void setupLogger(String file) {
        // Loggers are the test's.
    }

    @Override
    protected void createAgs() {
        for (AgentParameters agent : project.getAgents()) {
            for (int i = 1; i <= agent.getNbInstances(); i++) {
                create(agent, agent.getNbInstances() == 1 ? agent.name : agent.name + i);
            }
        }
    }

    private void create(AgentParameters parameters, String name) {
        try {
            EmulatedAgent agent = new EmulatedAgent(simulation, observer);
            agent.setAgName(name);
            agent.setEnvInfraTier(env);
            agent.createArchs(parameters.getAgArchClasses(), parameters.agClass.getClassName(),
                    parameters.getBBClass(), parameters.getSource().toString(), parameters.getAsSetts(debug, false));
            addAg(agent);
            createdAgents.add(agent);
        } catch (jason.asSyntax.parser.ParseException | jason.asSyntax.parser.TokenMgrError e) {
            throw new UncheckedIOException(wrong("Error parsing file " + parameters.getSource() + "!", e));
        } catch (Exception e) {
            throw new UncheckedIOException(wrong("Error creating agent " + name, e));
        }
    }

    @Override
    public void stop() {
        isRunning = false;
        List.copyOf(getAgs().values()).forEach(LocalAgArch::stopAg);
    }
}
