package javino.cli;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NoSuchFileException;
import java.util.concurrent.Callable;
import javino.JavinoException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** The {@code javino} command. */
@Command(name = "javino", description = "Sets up, inspects and drives Javino boards.",
        subcommands = {ActCommand.class, DoctorCommand.class, ForgetCommand.class, InfoCommand.class,
            KeygenCommand.class, MonitorCommand.class, NewCommand.class, PerceptsCommand.class,
            PortsCommand.class, ProvisionCommand.class, SendCommand.class})
public final class Main implements Callable<Integer> {

    @Option(names = {"-h", "--help"}, usageHelp = true, scope = ScopeType.INHERIT, description = "Shows this help.")
    private boolean help;

    @Spec
    private CommandSpec spec;

    private Main() {
    }

    /** Without a subcommand: says which there are. */
    @Override
    public Integer call() {
        spec.commandLine().usage(spec.commandLine().getErr());
        return CommandLine.ExitCode.USAGE;
    }

    /** Runs a subcommand and exits with its code. */
    public static void main(String[] args) {
        System.exit(commandLine(PortOption.serial()).execute(args));
    }

    /** The command, whose errors are one line each. */
    static CommandLine commandLine(CommandLine.IFactory factory) {
        CommandLine commandLine = new CommandLine(new Main(), factory);
        commandLine.setParameterExceptionHandler((e, args) -> {
            e.getCommandLine().getErr().println("javino: " + e.getMessage() + " (try --help)");
            return CommandLine.ExitCode.USAGE;
        });
        commandLine.setExecutionExceptionHandler((e, command, parsed) -> {
            if (!(e instanceof JavinoException || e instanceof IOException || e instanceof IllegalArgumentException)) {
                throw e;
            }
            command.getErr().println("javino: " + describe(e));
            return CommandLine.ExitCode.SOFTWARE;
        });
        return commandLine;
    }

    /** Exceptions about files often say no more than the file's name. */
    private static String describe(Exception e) {
        if (e instanceof NoSuchFileException) {
            return e.getMessage() + ": there is no such file";
        }
        if (e instanceof FileAlreadyExistsException) {
            return e.getMessage() + ": it is there already; move it away first";
        }
        return e instanceof IOException ? e.getClass().getSimpleName() + ": " + e.getMessage() : e.getMessage();
    }
}
