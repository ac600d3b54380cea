package javino.cli;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.TextFile;

/**
 * What a {@code .chon} file of ChonIDE has: a multi-agent system and the sketches of its boards.
 *
 * @param agents   its agents, in their order.
 * @param sketches its sketches, in their order.
 */
record ChonProject(List<Agent> agents, List<Sketch> sketches) {

    /** Where Gson says that a fault is. */
    private static final Pattern PLACE = Pattern.compile("at line \\d+ column \\d+");
    private static final Pattern AGENT = Pattern.compile("[a-z]\\w*");

    /** An agent. @param architecture as ChonIDE names it. */
    record Agent(String name, String architecture, String program) {

        private static final Pattern COMMENT = Pattern.compile("//[^\n]*|/\\*.*?\\*/", Pattern.DOTALL);
        /** The atoms that name ports, as in {@code serialPort(ttyUSB0)} or {@code .argo.port(ttyACM0)}. */
        private static final Pattern PORT = Pattern.compile("\\b\\w*[pP]ort\\(\\s*\"?(tty\\w+|COM\\d+)\"?\\s*[,)]");
        /** What is perceived, as {@code ledStatus(on)} or {@code +distance(D)}. */
        private static final Pattern PERCEPT = Pattern.compile("(?<![.!?\\w])([a-z]\\w*)\\(\\s*(\\w+)\\s*\\)");
        private static final Set<String> NO_PERCEPTS = Set.of("port", "serialPort", "not");
        /** The package of an internal action, as in {@code .velluscinum.buildWallet(W)}. */
        private static final Pattern PACKAGE = Pattern.compile("(?<!\\w)\\.(\\w+)\\.\\w+\\(");
        private static final Set<String> OURS = Set.of("argo", "difuser");
        private static final Pattern ACTION = Pattern.compile("\\.(?:argo\\.)?act\\(\\s*([a-z]\\w*)\\s*\\)");

        /** Whether it has a board, by Argo. */
        boolean isArgo() {
            return architecture.equals("Argo") || architecture.equals("jason.Argo");
        }

        /** Whether it is one of Jason's own. */
        boolean isPlain() {
            return architecture.isEmpty() || architecture.equals("Jason");
        }

        private Stream<MatchResult> code(Pattern what) {
            return what.matcher(COMMENT.matcher(program).replaceAll(" ")).results();
        }

        private Set<String> found(Pattern what) {
            return code(what).map(match -> match.group(1)).collect(Collectors.toCollection(LinkedHashSet::new));
        }

        /**
         * What its program seems to perceive: a percept's name, and its values there, which are none where it has a
         * number.
         */
        Map<String, Set<String>> percepts() {
            Map<String, Set<String>> percepts = new LinkedHashMap<>();
            code(PERCEPT).filter(match -> !NO_PERCEPTS.contains(match.group(1))).forEach(match -> {
                Set<String> values = percepts.computeIfAbsent(match.group(1), name -> new LinkedHashSet<>());
                if (Character.isLowerCase(match.group(2).charAt(0))) {
                    values.add(match.group(2));
                }
            });
            return percepts;
        }

        /** Packages of internal actions that neither Jason nor Javino has. */
        Set<String> packages() {
            Set<String> packages = found(PACKAGE);
            packages.removeAll(OURS);
            return packages;
        }

        /** The ports that its program names. */
        Set<String> ports() {
            return found(PORT);
        }

        /** The actions that its program asks a board for. */
        Set<String> actions() {
            return found(ACTION);
        }
    }

    /** A sketch. @param program its one file. */
    record Sketch(String name, String program) {

        private static final Pattern INCLUDE = Pattern.compile("(?m)^\\s*#\\s*include\\s*[<\"]([\\w/]+)\\.h[>\"]");
        /** What comes with the core or with Javino. */
        private static final Set<String> KNOWN = Set.of("Arduino", "Javino", "JavinoBDI", "JavinoEeprom", "EEPROM",
                "Wire", "SPI", "SoftwareSerial", "HID");

        /** The libraries that it includes beside Javino and what each core has. */
        Set<String> libraries() {
            return INCLUDE.matcher(program).results().map(match -> match.group(1))
                    .filter(name -> !KNOWN.contains(name) && !name.contains("/"))
                    .collect(Collectors.toCollection(LinkedHashSet::new));
        }
    }

    /** A file that is JSON, but no project. */
    private static final class Refused extends RuntimeException {

        private static final long serialVersionUID = 1;

        Refused(String why) {
            super(why);
        }
    }

    /**
     * Reads a file.
     *
     * @throws JavinoException if it is none of ChonIDE's, or has a name that no file can have.
     */
    static ChonProject read(Path file) throws IOException, JavinoException {
        JsonReader reader = new JsonReader(new StringReader(TextFile.read(file)));
        reader.setStrictness(Strictness.STRICT);
        try {
            JsonElement whole = JsonParser.parseReader(reader);
            if (!whole.isJsonObject()) {
                throw new Refused("it is no JSON object");
            }
            JsonObject project = whole.getAsJsonObject();
            List<Agent> agents = new ArrayList<>();
            for (JsonElement agent : list(project, "agents")) {
                agents.add(new Agent(text(agent, "name"), text(agent, "archClass"), text(agent, "sourceCode")));
            }
            List<Sketch> sketches = new ArrayList<>();
            for (JsonElement sketch : list(project, "firmwares")) {
                sketches.add(new Sketch(text(sketch, "name"), text(sketch, "sourceCode")));
            }
            check(agents.stream().map(Agent::name).toList(), "an agent", AGENT);
            check(sketches.stream().map(Sketch::name).toList(), "a sketch", ProjectFiles.NAME);
            return new ChonProject(agents, sketches);
        } catch (Refused e) {
            throw refused(file, e.getMessage());
        } catch (JsonParseException e) {
            Matcher place = PLACE.matcher(String.valueOf(e.getMessage()));
            throw refused(file, place.find() ? "no JSON " + place.group() : "no JSON");
        }
    }

    private static JavinoException refused(Path file, String why) {
        return new JavinoException(file + ": no project of ChonIDE: " + why);
    }

    private static JsonArray list(JsonObject project, String name) {
        if (!project.has(name) || !project.get(name).isJsonArray()) {
            throw new Refused("it has no list \"" + name + "\"");
        }
        return project.getAsJsonArray(name);
    }

    private static String text(JsonElement of, String name) {
        JsonElement text = of.isJsonObject() ? of.getAsJsonObject().get(name) : null;
        if (text == null || !text.isJsonPrimitive()) {
            throw new Refused("something in it has no \"" + name + "\"");
        }
        return text.getAsString();
    }

    private static void check(List<String> names, String what, Pattern right) {
        for (int i = 0; i < names.size(); i++) {
            if (!right.matcher(names.get(i)).matches()) {
                throw new Refused(what + " cannot be named " + names.get(i));
            }
            if (names.indexOf(names.get(i)) != i) {
                throw new Refused("two have the name " + names.get(i));
            }
        }
    }
}
