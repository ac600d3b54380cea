package javino.cli;

import java.time.LocalDate;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.Printable;
import picocli.CommandLine;
import picocli.CommandLine.MaxValuesExceededException;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.MutuallyExclusiveArgsException;
import picocli.CommandLine.OverwrittenOptionException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Tells wrong usage in the words of the help. */
public final class WrongUsage {

    private static final Map<Class<?>, String> EXPECTED = Map.of(int.class, "a whole number", Integer.class,
            "a whole number", long.class, "a whole number", Double.class, "a number such as 0.01", LocalDate.class,
            "a day such as 2027-11-30");

    private WrongUsage() {
    }

    /** Has a command tell wrong usage in one line, and take no empty values: a shell makes them of unset variables. */
    static void configure(CommandLine commandLine) {
        commandLine.setParameterExceptionHandler((e, args) -> {
            e.getCommandLine().getErr().println("javino: " + describe(e) + " (try --help)");
            return CommandLine.ExitCode.USAGE;
        });
        commandLine.setExecutionStrategy(parsed -> {
            refuseEmpty(parsed);
            return new CommandLine.RunLast().execute(parsed);
        });
    }

    /** @throws ParameterException if any value, or a part of one, is empty. */
    public static void refuseEmpty(ParseResult parsed) {
        for (ParseResult each = parsed; each != null; each = each.subcommand()) {
            CommandLine command = each.commandSpec().commandLine();
            each.matchedArgs().stream().filter(argument -> argument.originalStringValues().stream()
                    .anyMatch(value -> isEmpty(argument, value))).findFirst().ifPresent(argument -> {
                        throw new ParameterException(command, missing(List.of(argument)), argument, "");
                    });
        }
    }

    private static boolean isEmpty(ArgSpec argument, String value) {
        return value.isEmpty() || argument.typeInfo().isMap() && value.endsWith("=");
    }

    /** One line, which names what is wrong. */
    public static String describe(ParameterException e) {
        ArgSpec argument = e.getArgSpec();
        if (e instanceof MissingParameterException missing) {
            return unmatched(e.getCommandLine()).map(WrongUsage::describe)
                    .orElseGet(() -> missing(missing.getMissing()));
        }
        if (e instanceof UnmatchedArgumentException unmatched) {
            return describe(unmatched);
        }
        if (e instanceof MutuallyExclusiveArgsException || e instanceof MaxValuesExceededException) {
            return oneOf(e.getCommandLine().getCommandSpec());
        }
        if (e instanceof OverwrittenOptionException twice) {
            return name(twice.getOverwritten()) + " is given more than once";
        }
        if (argument == null || e.getValue() == null) {
            return e.getMessage();
        }
        return e.getValue().isEmpty() ? missing(List.of(argument)) : name(argument) + ": " + whatIsWrong(e, argument);
    }

    private static String whatIsWrong(ParameterException e, ArgSpec argument) {
        if (e.getCause() instanceof TypeConversionException ours && argument.converters().length > 0) {
            return ours.getMessage();
        }
        String value = Printable.of(e.getValue());
        return argument.arity().max() == 0 ? "takes no value, not " + value
                : expected(argument) + " was expected, not " + value;
    }

    private static String expected(ArgSpec argument) {
        Class<?> type = argument.typeInfo().getType();
        return type.isEnum() ? Stream.of(type.getEnumConstants()).map(Object::toString)
                .collect(Collectors.joining(" or ")) : EXPECTED.getOrDefault(type, argument.paramLabel());
    }

    /** The first word that has no place, which may be why another place is empty. */
    private static Optional<UnmatchedArgumentException> unmatched(CommandLine command) {
        return Stream.iterate(command, Objects::nonNull, CommandLine::getParent)
                .filter(each -> !each.getUnmatchedArguments().isEmpty()).reduce((lower, upper) -> upper)
                .map(each -> new UnmatchedArgumentException(each, each.getUnmatchedArguments()));
    }

    /** Names the word that is too much, and one that is near to it. */
    private static String describe(UnmatchedArgumentException unmatched) {
        String kind = unmatched.isUnknownOption() ? "there is no option "
                : unmatched.getCommandLine().getSubcommands().isEmpty() ? "there is no place for "
                        : "there is no command ";
        String near =
                near(unmatched).map(name -> "; did you mean " + name + "?").orElse("");
        return kind + Printable.of(unmatched.getUnmatched().get(0)) + near;
    }

    /** An option that differs by its dashes or capitals alone, or begins so; else what picocli finds. */
    private static Optional<String> near(UnmatchedArgumentException unmatched) {
        String word = unmatched.getUnmatched().get(0).replaceFirst("^-+", "").replaceFirst("=.*", "");
        Stream<String> options = !unmatched.isUnknownOption() || word.isEmpty() ? Stream.of()
                : unmatched.getCommandLine().getCommandSpec().options().stream().map(OptionSpec::longestName)
                        .filter(name -> name.replaceFirst("^-+", "").regionMatches(true, 0, word, 0, word.length()));
        return Stream.concat(options, unmatched.getSuggestions().stream()).findFirst();
    }

    private static String oneOf(CommandSpec command) {
        return command.argGroups().stream().map(group -> group.args().stream().map(WrongUsage::name)
                .collect(Collectors.joining(", ", "give one of ", ", and once"))).collect(Collectors.joining("; "));
    }

    private static String missing(List<ArgSpec> missing) {
        boolean oneOf = missing.stream().anyMatch(each -> each.group() != null);
        return missing.stream()
                .map(each -> each.isOption() && each.arity().max() > 0 ? name(each) + " " + each.paramLabel()
                        : name(each))
                .collect(Collectors.joining(oneOf ? " or " : ", ", "missing: ", ""));
    }

    private static String name(ArgSpec argument) {
        return argument instanceof OptionSpec option ? option.longestName() : argument.paramLabel();
    }
}
