package javino.cli;

import java.util.Locale;
import java.util.concurrent.Callable;
import javino.JavinoException;
import javino.Printable;
import javino.board.Board;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Outcome;
import javino.protocol.ProtocolError;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** {@code javino send}: sends a message by radio. */
@Command(name = "send", description = {"Sends a message by radio, and prints its outcome.",
        "To a device this is delivered, or undelivered with exit status 1; to a group or to all it is sent."})
final class SendCommand implements Callable<Integer> {

    @Mixin
    private PortOption port;

    @Parameters(index = "0", paramLabel = "TO", converter = AddressOption.Destination.class,
            description = "A device such as SUPO, a group such as //SU, or all in range: ////.")
    private Address to;

    @Parameters(index = "1", paramLabel = "CONTENT", converter = ContentText.class,
            description = "A performative and a term of AgentSpeak, as in 'tell;help'; a question or an answer has "
                    + "three characters for the conversation too, such as 'askOne#AbC;speed(X)'.")
    private Content content;

    @Spec
    private CommandSpec spec;

    /** Reads a content, so that a wrong one is wrong usage. */
    private static final class ContentText implements ITypeConverter<Content> {
        @Override
        public Content convert(String text) {
            try {
                Content content = Content.parse(text);
                TermText.mistake(content).ifPresent(what -> {
                    throw new TypeConversionException("this is no AgentSpeak: " + what);
                });
                return content;
            } catch (IllegalArgumentException e) {
                boolean noContent = e.getMessage().startsWith(ProtocolError.BAD_CONTENT.name());
                String found = Printable.of(text);
                throw new TypeConversionException(!noContent ? e.getMessage()
                        : text.contains(";") ? "a performative, ; and a term were expected, such as 'tell;help', not "
                                + found : "'" + found + "' has no performative: write 'tell;" + found + "'");
            }
        }
    }

    @Override
    public Integer call() throws JavinoException, InterruptedException {
        if (to.equals(Address.BROADCAST) && content.performative().requiresSeal()) {
            throw new ParameterException(spec.commandLine(), content.performative()
                    + " goes to a device or a group, not to all: no agent accepts it from a broadcast");
        }
        SilenceCheck check = new SilenceCheck(to);
        try (Board board = port.open(check)) {
            check.begin(board);
            Outcome outcome = Await.result(board, board.transmit(to, content).end());
            spec.commandLine().getOut().println(outcome.toString().toLowerCase(Locale.ROOT));
            if (outcome == Outcome.UNDELIVERED) {
                spec.commandLine().getErr().println("javino: " + check.end(board) + "; the message may have arrived: "
                        + "docs/how-to/debug-a-silent-radio.md goes on");
            }
            return outcome == Outcome.UNDELIVERED ? 1 : 0;
        }
    }
}
