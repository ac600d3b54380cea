package javino.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import javino.JavinoException;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** {@code javino new}: writes a project that runs at once. */
@Command(name = "new", description = {
        "Writes a new project: an agent, its board's sketch, and a build that runs them on an emulated board.",
        "Then call 'gradle run' in its folder. Its README says the rest."})
final class NewCommand implements Callable<Integer> {

    @Parameters(index = "0", paramLabel = "FOLDER",
            description = "The project's new folder; it must not exist yet. Its last part is the project's name: "
                    + "letters, digits, - and _, a letter first.")
    private Path folder;

    @ArgGroup
    private Which which = new Which();

    @Option(names = "--board", paramLabel = "BOARD", converter = ModelByName.class,
            description = "The board: mega (the default), uno, nano, nano-old (flashed at 57600 baud) or pro-mini.")
    private NewProject.Model model;

    @Option(names = "--boards", paramLabel = "1|2", defaultValue = "1",
            description = "How many boards the agent has: 1 (the default), or 2: a sensor (an Uno, unless --board says"
                    + " otherwise) and an arm (a Mega).")
    private int boards;

    @Spec
    private CommandSpec spec;

    /** The platform that runs the agent; Jason unless JaCaMo is chosen. */
    private static final class Which {

        @Option(names = "--jason", required = true, description = "Jason runs the agent; this is the default.")
        private boolean jason;

        @Option(names = "--jacamo", required = true, description = "JaCaMo runs the agent.")
        private boolean jacamo;
    }

    static final class ModelByName implements ITypeConverter<NewProject.Model> {

        @Override
        public NewProject.Model convert(String name) {
            return Stream.of(NewProject.Model.values()).filter(model -> model.toString().equals(name)).findFirst()
                    .orElseThrow(() -> new TypeConversionException(
                            "the boards are mega, uno, nano, nano-old and pro-mini, not " + name));
        }
    }

    @Override
    public Integer call() throws IOException, JavinoException {
        String name = ProjectFiles.nameOf(spec.commandLine(), folder);
        if (boards < 1 || boards > 2) {
            throw new ParameterException(spec.commandLine(), "a new project has 1 or 2 boards, not " + boards);
        }
        NewProject.Model usual = boards == 1 ? NewProject.Model.MEGA : NewProject.Model.UNO;
        NewProject.Kind kind = which.jacamo ? NewProject.Kind.JACAMO : NewProject.Kind.JASON;
        new NewProject(name, kind, model == null ? usual : model, boards == 2).write(folder);
        spec.commandLine().getOut().println("project " + name + " written; next: cd " + folder + " && gradle run");
        return 0;
    }
}
