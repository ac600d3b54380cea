package lockstep.agents;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

import diffuser.StartFailures;

import jason.JasonException;
import jason.architecture.AgArch;
import jason.asSemantics.Agent;
import jason.asSyntax.ASSyntax;
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
import lockstep.AgentProgram.Agents;
import lockstep.AgentProgram.Observer;
import lockstep.Simulation;

/** Runs Jason's own launcher, but for its threads. */
public final class JasonRunner extends RunLocalMAS implements AgentProgram.Runner {

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
    public Agents start(Simulation time, Path program, Observer told) throws IOException, ReflectiveOperationException {
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
        return new RunningAgents(this);
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
