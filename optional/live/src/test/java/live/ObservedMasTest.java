package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import jason.JasonException;
import jason.asSemantics.Message;
import jason.infra.local.LocalRuntimeServices;
import jason.infra.local.RunLocalMAS;
import jason.runtime.RuntimeServicesFactory;
import jason.util.Config;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A MAS of one agent, run by Jason. */
@Tag("newerJava")
@Timeout(120)
class ObservedMasTest {

    private static final int PATIENCE_SECONDS = 60;

    @TempDir
    private Path folder;
    private final BlockingQueue<String> told = new LinkedBlockingQueue<>();
    private final ObservedMas observer = new ObservedMas(told::add);
    private final Mas mas = new Mas();
    private final Set<String> beliefs = new LinkedHashSet<>();
    private String intentions = "[]";

    /** As its {@code main}, which would not return. */
    private static final class Mas extends RunLocalMAS {
        void begin(ObservedMas observer, String... arguments) throws JasonException {
            runner = this;
            RuntimeServicesFactory.set(new LocalRuntimeServices(this));
            init(arguments);
            LogEvents.beside(observer.out());
            observer.begin();
            create();
            start();
        }
    }

    private void run(String program) throws Exception {
        // Jason's own would open a window.
        run(program, "");
    }

    private void run(String program, Map<String, String> others) throws Exception {
        for (Map.Entry<String, String> other : others.entrySet()) {
            Files.writeString(folder.resolve(other.getKey()), other.getValue());
        }
        run(program, "");
    }

    private void run(String program, String log) throws Exception {
        Config.get().setProperty(Config.START_WEB_MI, "false");
        Files.writeString(folder.resolve("tester.asl"), program);
        Path project = Files.writeString(folder.resolve("tester.mas2j"),
                "MAS tester { agents: tester agentArchClass " + PrintingBoard.class.getName()
                        + "; aslSourcePath: \"" + folder + "\"; }");
        Path logging = Files.writeString(folder.resolve("logging.properties"), log);
        mas.begin(observer, project.toString(), "--log-conf", logging.toString(), "--no-net");
    }

    @AfterEach
    void stop() {
        observer.end();
        mas.getAgs().values().forEach(agent -> agent.stopAg());
    }

    /** Follows what is told until beliefs and intentions are as wanted. */
    private void await(Set<String> wantedBeliefs, String wantedIntentions) throws InterruptedException {
        while (!beliefs.containsAll(wantedBeliefs) || !intentions.equals(wantedIntentions)) {
            String line = told.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
            assertNotNull(line, "beliefs " + beliefs + ", intentions " + intentions);
            JsonObject event = JsonParser.parseString(line).getAsJsonObject();
            assertEquals("tester", event.get("agent").getAsString());
            if (event.get("event").getAsString().equals("intentions")) {
                intentions = event.get("intentions").toString();
            } else if (event.get("event").getAsString().equals("beliefs")) {
                texts(event.get("remove")).forEach(beliefs::remove);
                beliefs.addAll(texts(event.get("add")));
            }
            assertTrue(line.getBytes(StandardCharsets.UTF_8).length < 4096, line);
        }
    }

    private static List<String> texts(JsonElement array) {
        List<String> texts = new ArrayList<>();
        array.getAsJsonArray().forEach(text -> texts.add(text.getAsString()));
        return texts;
    }

    @Test
    void agent_thatThenSleeps_hasToldAll() throws Exception {
        run("!go. +!go <- +light(1); -+light(2); .wait({+never}).");

        await(Set.of("light(2)[source(self)]", "openness(totallyClosed)[source(percept)]"),
                "[\"+!go[source(self)] / .wait({ +never })\"]");
        assertEquals(2, beliefs.size(), beliefs.toString());
    }

    @Test
    void belief_goneAndIntentionEnded_areTold() throws Exception {
        run("!go. +!go <- +light(1); .wait({+over}); -light(1); +dark.");

        await(Set.of("light(1)[source(self)]"), "[\"+!go[source(self)] / .wait({ +over })\"]");
        mas.getAgs().values().forEach(agent -> agent.receiveMsg(new Message("tell", "test", "tester", "over")));
        await(Set.of("dark[source(self)]"), "[]");
        assertTrue(beliefs.stream().noneMatch(belief -> belief.startsWith("light")), beliefs.toString());
    }

    @Test
    void beliefs_veryMany_areToldUpToANumberInShortLines() throws Exception {
        run("!go. +!go <- for (.range(I,1,800)) { +number(I,\"äääääääääääääääääääää\") }; +z; .wait({+never}).");

        await(Set.of(), "[\"+!go[source(self)] / .wait({ +never })\"]");
        assertEquals(ObservedAgent.MOST_BELIEFS, beliefs.size());
    }

    @Test
    void agent_madeLater_isObservedUnderItsNameToItsEnd() throws Exception {
        run("!go. +!go <- .create_agent(helper, \"" + folder + "/helper.asl\"). +over <- .kill_agent(helper).",
                Map.of("helper.asl", "help."));

        awaitLine("\"agent\":\"helper\",\"event\":\"beliefs\",\"add\":[\"help[source(self)]\"");
        mas.getAgs().get("tester").receiveMsg(new Message("tell", "test", "tester", "over"));
        awaitLine("\"event\":\"agent\",\"agent\":\"helper\",\"ended\":true");
    }

    private String awaitLine(String part) throws InterruptedException {
        List<String> lines = new ArrayList<>(List.of(""));
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!lines.get(lines.size() - 1).contains(part)) {
            String line = told.poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
            assertNotNull(line, () -> part + " is not among " + lines);
            lines.add(line);
        }
        return lines.get(lines.size() - 1);
    }

    @Test
    void commands_giveGoals_andHaveTheBoardAct() throws Exception {
        run("!go. +!go <- .port(x); .wait({+never}). +!light(N)[source(page)] <- +lit(N). +!use <- .act(lampOn(3)).");

        awaitLine("\"event\":\"board\",\"port\":\"fake\",\"online\":true,\"address\":\"\",\"firmware\":\"fake\","
                + "\"radio\":false,\"actions\":[\"lampOn\"],\"arguments\":{\"lampOn\":\"3\"}");
        perform("do", "goal", "goal", "light(2)");
        awaitLine("\"add\":[\"lit(2)[source(self)]\"]");
        perform("do", "act", "action", "lampOn(1)");
        awaitLine("\"event\":\"acted\",\"action\":\"lampOn(1)\"");
        assertEquals("light( is no goal; write one such as patrol(3)",
                assertThrows(IllegalArgumentException.class, () -> perform("do", "goal", "goal", "light("))
                        .getMessage());
        assertThrows(ExecutionException.class,
                () -> perform("do", "say", "to", "SUPO", "performative", "tell", "content", "dark"));
        assertEquals("there is no agent nobody", assertThrows(IllegalArgumentException.class,
                () -> observer.perform(Events.object("{\"agent\":\"nobody\"}"))).getMessage());
    }

    @Test
    void decisions_areToldWhileTheyAreWanted() throws Exception {
        observer.perform(Events.object("{\"do\":\"record\",\"on\":true}")).get();
        run("!go. +!go <- +light(1); .port(x); .wait({+never}). +!light(N) : N > 9 <- true. +!use <- .act(lampOn(3)).");

        awaitLine("\"event\":\"agent-event\",\"agent\":\"tester\",\"number\":1,\"trigger\":\"+!go[source(self)]\","
                + "\"origin\":\"program\"");
        awaitLine("\"trigger\":\"+light(1)[source(self)]\",\"intention\":");
        awaitLine("\"event\":\"board\"");
        perform("do", "act", "action", "lampOn(1)");
        awaitLine("\"event\":\"acted\",\"action\":\"lampOn(1)\",\"request\":1");
        awaitLine("\"event\":\"agent-performed\",\"agent\":\"tester\",\"request\":1");
        observer.perform(Events.object("{\"do\":\"record\",\"on\":false}")).get();
        // The cycle that is under way still tells.
        for (int lamp = 2; !act(lamp).contains("\"request\":0"); lamp++) {
            assertTrue(lamp < 100, told::toString);
        }
        assertTrue(told.stream().noneMatch(line -> line.contains("agent-action")), told.toString());
    }

    private String act(int lamp) throws Exception {
        told.clear();
        perform("do", "act", "action", "lampOn(" + lamp + ")");
        return awaitLine("\"event\":\"acted\",\"action\":\"lampOn(" + lamp + ")\"");
    }

    private void perform(Object... command) throws Exception {
        JsonObject all = Events.object(Events.json(command));
        all.addProperty("agent", "tester");
        observer.perform(all).get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    }

    @Test
    void warning_isAnEvent_andNotAmongWhatTheAgentPrints() throws Exception {
        PrintStream console = System.err;
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        System.setErr(new PrintStream(said, true, StandardCharsets.UTF_8));
        try {
            run("!go. +!go <- .print(hello); .port(x); .wait({+never}).",
                    "handlers = java.util.logging.ConsoleHandler");

            assertEquals("t = 20.99", awaitText("printed").strip());
            assertTrue(awaitText("warned").contains("the sketch prints"));
        } finally {
            System.setErr(console);
        }
        assertTrue(said.toString(StandardCharsets.UTF_8).contains("hello"));
    }

    private String awaitText(String event) throws InterruptedException {
        while (true) {
            String line = told.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
            assertNotNull(line, event);
            JsonObject next = JsonParser.parseString(line).getAsJsonObject();
            if (next.get("event").getAsString().equals(event)) {
                return next.get("text").getAsString();
            }
        }
    }
}
