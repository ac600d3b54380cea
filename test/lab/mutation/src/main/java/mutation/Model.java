package mutation;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import uppaal.ModelException;
import uppaal.check.Property;
import uppaal.check.Query;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;
import uppaal.report.Constants;
import uppaal.report.Firmware;
import uppaal.report.Scene;

/**
 * A file with automata, and the queries about them.
 *
 * @param name     the name of the file
 * @param xml      its text
 * @param settings the automata that run together, with the queries about them
 * @param firmware the sources whose numbers it must have
 */
record Model(String name, String xml, List<Model.Setting> settings, Firmware firmware) {

    /** The judge that kills a number that is no longer the firmware's. */
    static final String FIRMWARE = "firmware";

    /** Templates that only observe, and the rest of the world of a trace: mutants of these are none of boards. */
    private static final Set<String> BESIDE = Set.of("Witness", "Gap", "Pause", "Told", "Deadline", "Others");

    /** The fate of a mutant. */
    enum Fate {
        /** It is outside what UPPAAL or our checker reads. */
        INVALID,
        /** It has the states and moves of the model. */
        EQUIVALENT,
        /** A verdict has changed, a variable left its range, or a number is not the firmware's. */
        KILLED,
        /** No property kills it. */
        SURVIVED
    }

    /**
     * The fate of a mutant, and the reason.
     *
     * @param by the property or the check that killed it
     */
    record Verdict(Fate fate, String by) {}

    /**
     * The automata of a file as they run together.
     *
     * @param change  the difference from the file
     * @param queries all that is asked
     */
    record Setting(UnaryOperator<String> change, List<Query> queries) {

        /** A scene that `gradle model` checks, with small numbers. */
        static Setting of(Scene scene, Path models) {
            Scene small = scene.inSmall();
            return new Setting(xml -> small.text(xml, models), scene.queries(models));
        }

        /** @throws ModelException where the model is none that our checker reads */
        Network network(String xml) {
            return NetworkBuilder.build(document(change.apply(xml)));
        }

        /** Whether two models have the same automata that take part. */
        boolean same(String xml, String other) {
            return taking(document(change.apply(xml))).equals(taking(document(change.apply(other))));
        }

        private static Document taking(Document document) {
            return new Document(document.file(), document.declarations(), document.templates().stream()
                    .filter(template -> document.system().matches("(?s).*\\b" + template.name() + "\\b.*")).toList(),
                    document.system());
        }
    }

    /** All models. */
    static List<Model> all(Path root) throws IOException {
        Path models = root.resolve("uppaal/models");
        Firmware firmware = Firmware.of(root.resolve("javino-firmware/src"));
        String quiet = Files.readString(models.resolve(Scene.QUIET.model()));
        // A fault of the paper's automata may show only once their connection stays online; but nothing forces their
        // senders to go on.
        Setting withoutLoss = new Setting(
                xml -> xml.replace(template(xml, "Connection"), template(quiet, "Connection")),
                Scene.QUIET.queries(models).stream().filter(Behaviour::isSettledByStates).toList());
        Map<String, List<Setting>> settings = new LinkedHashMap<>();
        for (Scene scene : Scene.ALL) {
            settings.computeIfAbsent(scene.model(), any -> new ArrayList<>()).add(Setting.of(scene, models));
        }
        settings.get(Scene.PAPER.model()).add(withoutLoss);
        List<Model> all = new ArrayList<>();
        for (Map.Entry<String, List<Setting>> model : settings.entrySet()) {
            all.add(new Model(model.getKey(), Files.readString(models.resolve(model.getKey())), model.getValue(),
                    firmware));
        }
        return all;
    }

    /** Every small change of what it says of boards, keys and attackers. */
    List<ModelMutant> mutants() {
        return ModelMutants.of(xml).stream().filter(mutant -> !BESIDE.contains(mutant.place().split(",")[0])).toList();
    }

    /** The paper's network, asked nothing but what the paper asks. */
    static Model ofThePaperAlone(Path root) throws IOException {
        Path models = root.resolve("uppaal/models");
        Scene scene = new Scene("", "", Scene.PAPER.model(), Map.of(), Map.of(), List.of("paper.q"));
        return new Model("paper.xml, by the paper's eight properties alone",
                Files.readString(models.resolve(scene.model())), List.of(Setting.of(scene, models)),
                Firmware.of(root.resolve("javino-firmware/src")));
    }

    private static Document document(String xml) {
        try {
            return DocumentReader.read("", new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)));
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    /** A template with all that is in it. */
    private static String template(String xml, String name) {
        int begin = xml.lastIndexOf("<template>", xml.indexOf(">" + name + "</name>"));
        return xml.substring(begin, xml.indexOf("</template>", begin));
    }

    /**
     * The behaviour of each scene as the model is.
     *
     * @throws IllegalStateException where a verdict is not as expected even so
     */
    List<Behaviour> sound() {
        return settings.stream().map(setting -> {
            Behaviour behaviour = Behaviour.of(setting.network(xml), setting.queries(), Integer.MAX_VALUE);
            behaviour.wrong().ifPresent(query -> {
                throw new IllegalStateException(name + " unchanged: " + query + " is not as expected");
            });
            return behaviour;
        }).toList();
    }

    /** @param sound the result of {@link #sound()} */
    Verdict judge(ModelMutant mutant, List<Behaviour> sound) {
        try {
            if (!Constants.differences(document(mutant.xml()), firmware).isEmpty()) {
                return new Verdict(Fate.KILLED, FIRMWARE);
            }
        } catch (ModelException unreadable) {
            return new Verdict(Fate.INVALID, unreadable.getMessage());
        }
        boolean same = true;
        // The quickest first: most mutants need no other.
        List<Integer> order = IntStream.range(0, settings.size()).boxed()
                .sorted(Comparator.comparingInt(i -> sound.get(i).states())).toList();
        for (int i : order) {
            if (settings.get(i).same(xml, mutant.xml())) {
                continue;
            }
            Network network;
            try {
                network = settings.get(i).network(mutant.xml());
                for (Query query : settings.get(i).queries()) {
                    Property.parse(query.text(), network, query.where());
                }
            } catch (ModelException unreadable) {
                return new Verdict(Fate.INVALID, unreadable.getMessage());
            }
            // A mutant with many more states is another one anyway.
            Behaviour behaviour = Behaviour.of(network, settings.get(i).queries(), 10 * sound.get(i).states() + 1000);
            if (behaviour.wrong().isPresent()) {
                return new Verdict(Fate.KILLED, behaviour.wrong().get());
            }
            same &= behaviour.whole() && behaviour.print() == sound.get(i).print();
        }
        return new Verdict(same ? Fate.EQUIVALENT : Fate.SURVIVED, "");
    }
}
