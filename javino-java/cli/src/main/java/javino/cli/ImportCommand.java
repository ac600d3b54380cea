package javino.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import javino.JavinoException;
import javino.cli.ChonProject.Agent;
import javino.cli.ChonProject.Sketch;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code javino import}: writes a project of ChonIDE as one that runs here. */
@Command(name = "import", description = {
        "Writes a project of ChonIDE (FILE.chon) as a project that runs here, its boards emulated.",
        "Says, a line each, what of it will not run here, and what to write instead."})
final class ImportCommand implements Callable<Integer> {

    /** The port of a board whose agent names none. */
    private static final String PORT = "ttyUSB0";

    @Parameters(index = "0", paramLabel = "FILE", description = "The file of ChonIDE.")
    private Path file;

    @Parameters(index = "1", paramLabel = "FOLDER",
            description = "The project's new folder; it must not exist yet. Its last part is the project's name.")
    private Path folder;

    @Option(names = "--board", paramLabel = "BOARD", defaultValue = "uno", converter = NewCommand.ModelByName.class,
            description = "The boards: mega, uno (the default), nano, nano-old or pro-mini.")
    private NewProject.Model model;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException, JavinoException {
        String name = ProjectFiles.nameOf(spec.commandLine(), folder);
        ChonProject project = ChonProject.read(file);
        String home = ProjectFiles.installed();
        List<String> remarks = new ArrayList<>();
        List<Agent> agents = running(project, remarks);
        List<Sketch> sketches = sketches(project, remarks);
        Map<String, String> words = Map.of("name", name, "javinoHome", home, "masFile", name + ".mas2j",
                "fqbn", model.fqbn, "sketches", sketches.stream().map(Sketch::name).collect(Collectors.joining(" ")));
        ProjectFiles files = ProjectFiles.in(folder, words);
        for (String each : NewProject.BUILD) {
            files.copy("common", each);
        }
        files.copy("imported", "build.gradle");
        files.write(name + ".mas2j", mas(name, agents));
        for (Agent agent : project.agents()) {
            files.write("src/agt/" + agent.name() + ".asl", agent.program());
        }
        for (Sketch sketch : sketches) {
            files.write("sketch/" + sketch.name() + "/" + sketch.name() + ".ino", sketch.program());
        }
        if (!sketches.isEmpty()) {
            files.write("board.json", boards(agents, sketches, remarks));
        }
        remarks.forEach(spec.commandLine().getOut()::println);
        spec.commandLine().getOut().println("project " + name + " written; "
                + (agents.isEmpty() ? "none of its agents runs here" : "next: cd " + folder + " && gradle run"));
        return 0;
    }

    /** The agents that run here. */
    private static List<Agent> running(ChonProject project, List<String> remarks) {
        List<Agent> running = new ArrayList<>();
        for (Agent agent : project.agents()) {
            if (agent.isPlain() || agent.isArgo()) {
                running.add(agent);
                agent.packages().forEach(name -> remarks.add("agent " + agent.name() + " uses ." + name
                        + ", which is not here: put its classes into src/java, its jar into build.gradle"));
            } else {
                remarks.add("agent " + agent.name() + " is left out: " + (agent.architecture().contains("Communicator")
                        ? "its Communicator needs a server on the Internet; write agentArchClass diffuser.Diffuser and"
                                + " .diffuse (radio), or join cells by javino gateway"
                        : "no architecture " + agent.architecture() + " is here; write one of yours, or Jason"));
            }
        }
        return running;
    }

    /** The file's sketches; for agents with a board but without a sketch one that has their actions. */
    private static List<Sketch> sketches(ChonProject project, List<String> remarks) {
        List<Sketch> sketches = new ArrayList<>(project.sketches());
        for (Sketch sketch : sketches) {
            for (String library : sketch.libraries()) {
                remarks.add("sketch " + sketch.name() + " includes " + library
                        + ".h: put that library into libraries/, unless your Arduino sketchbook has it");
            }
        }
        List<Agent> argos = project.agents().stream().filter(Agent::isArgo).toList();
        if (sketches.isEmpty() && !argos.isEmpty()) {
            Set<String> actions = argos.stream().flatMap(agent -> agent.actions().stream())
                    .collect(Collectors.toCollection(LinkedHashSet::new));
            Map<String, Set<String>> percepts = new LinkedHashMap<>();
            argos.forEach(agent -> percepts.putAll(agent.percepts()));
            sketches.add(new Sketch("Robot", robot(actions, percepts)));
            remarks.add(
                    "there is no sketch for " + argos.get(0).name() + ": sketch/Robot/Robot.ino is one of ours, with "
                            + String.join(", ", actions) + (actions.isEmpty() ? "no action" : "") + "; its percepts ("
                            + String.join(", ", percepts.keySet()) + ") are guesses, which you correct");
        }
        return sketches;
    }

    private static String robot(Set<String> actions, Map<String, Set<String>> percepts) {
        StringBuilder sketch = new StringBuilder("""
                // The actions that the agent asks for: each switches the board's lamp. The percepts are guesses.
                #include <JavinoBDI.h>

                JavinoBoard board(Serial, "robot 1.0");
                bool lampIsOn = false;

                void perceive(JavinoPercepts &percepts) {
                """);
        percepts.forEach((name, values) -> {
            List<String> all = List.copyOf(values);
            sketch.append(all.isEmpty() ? "  percepts.add(F(\"" + name + "\"), 50);\n"
                    : "  percepts.literal(lampIsOn ? F(\"" + name + "(" + all.get(all.size() - 1) + ")\") : F(\"" + name
                            + "(" + all.get(0) + ")\"));\n");
        });
        sketch.append("""
                }

                bool act(const JavinoArguments &) {
                  lampIsOn = !lampIsOn;
                  digitalWrite(LED_BUILTIN, lampIsOn);
                  return true;
                }

                void setup() {
                  pinMode(LED_BUILTIN, OUTPUT);
                  board.onPercepts(perceive);
                """);
        actions.forEach(action -> sketch.append("  board.action(F(\"").append(action).append("\"), act);\n"));
        return sketch.append("  board.begin(115200);\n}\n\nvoid loop() { board.run(); }\n").toString();
    }

    private static String mas(String name, List<Agent> agents) {
        return "MAS " + name.replace('-', '_') + " {\n    agents:\n"
                + agents.stream().map(agent -> "        " + agent.name()
                        + (agent.isArgo() ? " agentArchClass jason.Argo" : "") + ";\n").collect(Collectors.joining())
                + "    aslSourcePath: \"src/agt\";\n}\n";
    }

    /** The scenario: each sketch's board is at the port that an agent names. */
    private String boards(List<Agent> agents, List<Sketch> sketches, List<String> remarks) {
        List<String> ports = new ArrayList<>();
        for (Agent agent : agents) {
            if (agent.isArgo() && agent.ports().isEmpty()) {
                remarks.add(
                        "agent " + agent.name() + " names no port: write serialPort(" + PORT + "). into its program");
            }
            agent.ports().stream().filter(port -> !ports.contains(port)).forEach(ports::add);
        }
        List<String> boards = new ArrayList<>();
        for (Sketch sketch : sketches) {
            int number = boards.size();
            String name = sketch.name();
            String port = number < ports.size() ? ports.get(number) : number == 0 ? PORT : "ttyBoard" + number;
            String built = "build/" + (number == 0 ? "sketch" : name.toLowerCase(Locale.ROOT));
            boards.add("    { \"name\": \"" + name + "\", \"model\": \"" + model.emulated + "\", \"firmware\": \""
                    + built + "/" + name + ".ino.elf\",\n      \"port\": \"" + port
                    + "\", \"eeprom\": \"build/eeprom-" + name + ".bin\" }");
        }
        return "{\n  \"boards\": [\n" + String.join(",\n", boards) + "\n  ]\n}\n";
    }
}
