package javino.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import javino.JavinoException;
import javino.Printable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** The {@code javino} command. */
@Command(name = "javino", description = "Sets up, inspects and controls Javino boards.",
        versionProvider = Main.Version.class,
        subcommands = {ActCommand.class, DoctorCommand.class, ForgetCommand.class, InfoCommand.class,
                KeygenCommand.class, MonitorCommand.class, NewCommand.class, PerceptsCommand.class,
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

    /** As the jar has it. */
    static final class Version implements CommandLine.IVersionProvider {
        @Override
        public String[] getVersion() {
            return new String[] {"javino " + Main.class.getPackage().getImplementationVersion()};
        }
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
        ServiceLoader.load(CommandPlugin.class).forEach(commandLine::addSubcommand);
        commandLine.setParameterExceptionHandler((e, args) -> {
            e.getCommandLine().getErr().println("javino: " + describe(e) + " (try --help)");
            return CommandLine.ExitCode.USAGE;
        });
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

    /** Which word is too much, and one that is near to it. */
    private static String describe(ParameterException e) {
        if (e instanceof MissingParameterException missing) {
            boolean oneOf = missing.getMissing().stream().anyMatch(each -> each.group() != null);
            return missing.getMissing().stream().map(Main::describe)
                    .collect(Collectors.joining(oneOf ? " or " : ", ", "missing: ", ""));
        }
        if (!(e instanceof UnmatchedArgumentException unmatched)) {
            // What is wrong with a value a converter of ours says.
            boolean ours = e.getCause() instanceof TypeConversionException && e.getArgSpec() != null;
            return ours ? name(e.getArgSpec()) + ": " + e.getCause().getMessage() : e.getMessage();
        }
        String kind = unmatched.isUnknownOption() ? "there is no option "
                : e.getCommandLine().getSubcommands().isEmpty() ? "there is no place for " : "there is no command ";
        String near =
                unmatched.getSuggestions().stream().findFirst().map(name -> "; did you mean " + name + "?").orElse("");
        return kind + Printable.of(unmatched.getUnmatched().get(0)) + near;
    }

    private static String describe(ArgSpec missing) {
        return missing.isOption() ? name(missing) + " " + missing.paramLabel() : name(missing);
    }

    private static String name(ArgSpec argument) {
        return argument instanceof OptionSpec option ? option.longestName() : argument.paramLabel();
    }

    /** Exceptions about files often say no more than the file's name. */
    private static String describe(Exception e) {
        if (e instanceof NoSuchFileException) {
            return e.getMessage() + ": there is no such file";
        }
        if (e instanceof FileAlreadyExistsException) {
            return e.getMessage() + ": it is there already; move it away first";
        }
        if (e instanceof AccessDeniedException) {
            return e.getMessage() + ": you may not read and write it";
        }
        if (e instanceof FileSystemException) {
            return e.getMessage();
        }
        return e instanceof IOException ? e.getClass().getSimpleName() + ": " + e.getMessage() : e.getMessage();
    }
}
