package mutation;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import uppaal.ModelException;
import uppaal.check.Property;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.document.DocumentReader;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

/**
 * A file with automata, and what is asked of them.
 *
 * @param name   of the file
 * @param xml    its text
 * @param scenes who runs together, with the queries about them; the quickest first
 */
record Model(String name, String xml, List<Model.Scene> scenes) {

    /** What became of a mutant. */
    enum Fate {
        /** It is outside what UPPAAL or our checker reads. */
        INVALID,
        /** It has the states and moves of the model. */
        EQUIVALENT,
        /** A verdict has changed, or a variable left its range. */
        KILLED,
        /** No property has noticed it. */
        SURVIVED
    }

    /**
     * What became of a mutant, and why.
     *
     * @param by what noticed it
     */
    record Verdict(Fate fate, String by) {}

    /**
     * The automata of a file as they run together.
     *
     * @param change  what is other than in the file
     * @param queries all that is asked
     */
    record Scene(UnaryOperator<String> change, List<Query> queries) {

        /** @throws ModelException where the model is none that our checker reads */
        Network network(String xml) {
            try {
                return NetworkBuilder.build(DocumentReader.read("",
                        new ByteArrayInputStream(change.apply(xml).getBytes(StandardCharsets.UTF_8))));
            } catch (IOException impossible) {
                throw new UncheckedIOException(impossible);
            }
        }
    }

    /** All models of a folder. */
    static List<Model> all(Path models) throws IOException {
        String quiet = Files.readString(models.resolve("quiet.xml"));
        Scene stays = new Scene(UnaryOperator.identity(), queries(models, "quiet.q", "stronger.q"));
        // What is wrong in the paper's automata may show only once their connection stays online.
        Scene withoutLoss = new Scene(xml -> xml.replace(template(xml, "Connection"), template(quiet, "Connection")),
                stays.queries);
        return List.of(
                read(models, "paper.xml",
                        new Scene(UnaryOperator.identity(), queries(models, "paper.q", "stronger.q")), withoutLoss),
                read(models, "quiet.xml", stays),
                read(models, "renewal.xml", new Scene(UnaryOperator.identity(), queries(models, "renewal.q"))),
                read(models, "delivery.xml", scene(models, "multicast", Map.of()),
                        scene(models, "crossing", Map.of("MESSAGES", 1, "ATTEMPTS", 3)),
                        scene(models, "bound", Map.of("MESSAGES", 1, "PATIENCE", 3, "DATA_TIME", 4, "ACK_TIME", 3)),
                        scene(models, "unicast", Map.of())));
    }

    private static Model read(Path models, String name, Scene... scenes) throws IOException {
        return new Model(name, Files.readString(models.resolve(name)), List.of(scenes));
    }

    private static List<Query> queries(Path models, String... files) {
        return Stream.of(files).flatMap(file -> QueryFile.read(models.resolve(file)).stream()).toList();
    }

    /** Who runs is in a file of the scene's name; some constants are other than in the file. */
    private static Scene scene(Path models, String name, Map<String, Integer> constants) throws IOException {
        String system = Files.readString(models.resolve(name + ".system"));
        return new Scene(xml -> {
            String scene = ModelMutants.with(xml, "system", any -> system);
            for (Map.Entry<String, Integer> constant : constants.entrySet()) {
                scene = ModelMutants.with(scene, "declaration", text -> text.replaceFirst(
                        "(const int " + constant.getKey() + " = )\\d+", "$1" + constant.getValue()));
            }
            return scene;
        }, queries(models, name + ".q"));
    }

    /** A template with all that is in it. */
    private static String template(String xml, String name) {
        int begin = xml.lastIndexOf("<template>", xml.indexOf(">" + name + "</name>"));
        return xml.substring(begin, xml.indexOf("</template>", begin));
    }

    /**
     * What each scene does as the model is.
     *
     * @throws IllegalStateException where a verdict is not as expected even so
     */
    List<Behaviour> sound() {
        return scenes.stream().map(scene -> {
            Behaviour behaviour = Behaviour.of(scene.network(xml), scene.queries(), Integer.MAX_VALUE);
            behaviour.wrong().ifPresent(query -> {
                throw new IllegalStateException(name + " without a mistake: " + query + " is not as expected");
            });
            return behaviour;
        }).toList();
    }

    /** @param sound what {@link #sound()} gives */
    Verdict judge(ModelMutant mutant, List<Behaviour> sound) {
        boolean same = true;
        for (int i = 0; i < scenes.size(); i++) {
            Network network;
            try {
                network = scenes.get(i).network(mutant.xml());
                for (Query query : scenes.get(i).queries()) {
                    Property.parse(query.text(), network, query.where());
                }
            } catch (ModelException unreadable) {
                return new Verdict(Fate.INVALID, unreadable.getMessage());
            }
            // A mutant with many more states is another one anyway.
            Behaviour behaviour = Behaviour.of(network, scenes.get(i).queries(), 4 * sound.get(i).states() + 1000);
            if (behaviour.wrong().isPresent()) {
                return new Verdict(Fate.KILLED, behaviour.wrong().get());
            }
            same &= behaviour.whole() && behaviour.print() == sound.get(i).print();
        }
        return new Verdict(same ? Fate.EQUIVALENT : Fate.SURVIVED, "");
    }
}
