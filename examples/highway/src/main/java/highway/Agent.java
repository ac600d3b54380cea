package highway;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import jason.JasonException;
import jason.infra.local.RunLocalMAS;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import keyagreement.BoardKeyAgreement;

/** {@code gradle agent}: runs one agent of this folder on its board, by Jason. */
@Command(name = "agent")
public final class Agent implements Callable<Integer> {

    private static final String MAS = ".mas2j";

    @Option(names = "--agent")
    private String name;

    @Spec
    private CommandSpec spec;

    Agent() {}

    /** Runs the agent until it or the user ends it. */
    public static void main(String[] arguments) {
        System.exit(Highway.commandLine(new Agent()).execute(arguments));
    }

    @Override
    public Integer call() throws IOException, JasonException {
        try (Stream<Path> files = Files.list(Path.of(""))) {
            List<String> names = files.map(Path::toString).filter(file -> file.endsWith(MAS))
                    .map(file -> file.substring(0, file.length() - MAS.length())).sorted().toList();
            if (!names.contains(name)) {
                throw new ParameterException(spec.commandLine(),
                        (name == null ? "" : "there is no " + name + MAS + "; ")
                                + "--agent=NAME names the agent: one of " + String.join(", ", names));
            }
        }
        System.setProperty(BoardKeyAgreement.FOLDER_PROPERTY, Options.IDENTITIES.toString());
        RunLocalMAS.main(new String[] {name + MAS, "--log-conf", "logging.properties", "--no-net"});
        return CommandLine.ExitCode.OK;
    }
}
