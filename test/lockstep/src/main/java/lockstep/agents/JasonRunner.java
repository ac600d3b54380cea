package lockstep.agents;

import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

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
import jason.runtime.RuntimeServicesFactory;
import jason.runtime.Settings;

import lockstep.AgentProgram;
import lockstep.Simulation;

/** Runs Jason's own launcher, but for its threads. */
public final class JasonRunner extends RunLocalMAS implements AgentProgram.Runner {

    private Simulation simulation;

    /** Agents that come later have no thread either. */
    private final class Services extends LocalRuntimeServices {

        Services() {
            super(JasonRunner.this);
        }

        @Override
        protected LocalAgArch newAgInstance() {
            return new EmulatedAgent(simulation);
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
    public void start(Simulation time, Path program) throws IOException, ReflectiveOperationException {
        simulation = time;
        Field scheduler = Agent.class.getDeclaredField("scheduler");
        scheduler.setAccessible(true);
        scheduler.set(null, new EmulatedScheduler(simulation));
        Clock.set(simulation);
        RuntimeServicesFactory.set(new Services());
        init(new String[] {program.toString(), "--no-net"});
        project.getSourcePaths().addPath(program.getParent().toString());
        project.fixAgentsSrc();
        isRunning = true;
        try {
            createEnvironment();
        } catch (JasonException e) {
            throw new IOException(program + ": " + e.getMessage(), e);
        }
        createAgs();
        createdAgents.forEach(agent -> ((EmulatedAgent) agent).begin());
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
            EmulatedAgent agent = new EmulatedAgent(simulation);
            agent.setAgName(name);
            agent.setEnvInfraTier(env);
            agent.createArchs(parameters.getAgArchClasses(), parameters.agClass.getClassName(),
                    parameters.getBBClass(), parameters.getSource().toString(), parameters.getAsSetts(debug, false));
            addAg(agent);
            createdAgents.add(agent);
        } catch (Exception e) {
            throw new IllegalStateException("the agent " + name + " cannot be made: " + e.getMessage(), e);
        }
    }

    @Override
    public void stop() {
        isRunning = false;
        List.copyOf(getAgs().values()).forEach(LocalAgArch::stopAg);
    }
}
