package javino.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import javino.JavinoException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** The {@code javino} command. */
@Command(name = "javino", description = "Sets up, inspects and controls Javino boards.",
        versionProvider = Main.Version.class,
        subcommands = {ActCommand.class, DoctorCommand.class, ForgetCommand.class, HelpCommand.class,
                ImportCommand.class, InfoCommand.class, KeygenCommand.class, MonitorCommand.class, NewCommand.class,
                PerceptsCommand.class,
                PortsCommand.class, ProvisionCommand.class, RelayCommand.class, SendCommand.class})
public final class Main implements Callable<Integer> {

    @Option(names = {"-h", "--help"}, usageHelp = true, scope = ScopeType.INHERIT, description = "Shows this help.")
    private boolean help;

    @Option(names = "--version", versionHelp = true, description = "Shows the version.")
    private boolean version;

    @Spec
    private CommandSpec spec;

    private Main() {
    }

    /** The version that the jar has. */
    static final class Version implements CommandLine.IVersionProvider {
        @Override
        public String[] getVersion() {
            return new String[] {"javino " + Main.class.getPackage().getImplementationVersion()};
        }
    }

    /** Says which subcommands there are, if none was given. */
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
        ServiceLoader.load(CommandPlugin.class).forEach(commandLine::addSubcommand);
        WrongUsage.configure(commandLine);
        commandLine.setExecutionExceptionHandler((thrown, command, parsed) -> {
            Exception e = thrown instanceof UncheckedIOException unchecked ? unchecked.getCause() : thrown;
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
        if (e instanceof NoSuchFileException missing) {
            Path folder = Path.of(missing.getFile()).toAbsolutePath().getParent();
            return e.getMessage() + ": there is no " + (Files.isDirectory(folder) ? "such file" : "folder " + folder);
        }
        if (e instanceof FileAlreadyExistsException) {
            return e.getMessage() + ": it is there already; move it away first";
        }
        if (e instanceof AccessDeniedException) {
            return e.getMessage() + ": you may not read and write it";
        }
        return e instanceof IOException && !(e instanceof FileSystemException)
                ? "a file cannot be read or written: " + e.getMessage() : e.getMessage();
    }
}
