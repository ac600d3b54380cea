package diffuser;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.StreamHandler;

import jason.asSemantics.ActionExec;
import jason.asSemantics.Agent;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;
import jason.infra.local.LocalAgArch;
import jason.infra.local.RunLocalMAS;
import jason.runtime.Settings;
import jason.util.Config;

import diffuser.gate.TrustLevel;

import javino.board.ReceivedMessage;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.ProtocolException;

/**
 * Messages of all casts against an agent that runs. Each line of the input is one: a letter for its cast (b, m, u), one
 * for its sender, and its content, in which bytes of 0x80 and more are whole words. Whatever they say: no plan of the
 * agent's goes, and none comes but by a sealed tellHow; its beliefs stay, and new ones have the sender as source and
 * the cast that they came by; of its plans for goals a broadcast runs those only that ask for it; no action is
 * performed but by a sealed goal; and each message of the log is one line, with an exception only where a plan that
 * was taught goes wrong.
 */
public final class GateTarget {

    private static final String PROGRAM = """
            own(1).
            trusted("SUPO").
            +!go(X) <- danger.
            +!go <- danger.
            +!opened(X)[cast(broadcast,_)] <- +ran(opened).
            +!opened(X) <- danger.
            +!guarded(X)[cast(unicast,S)] : .term2string(S,T) & trusted(T)[source(self)] <- +ran(guarded).
            +!any(X)[cast(_,_)] <- danger.
            +!held(X)[source(self)] <- +ran(forged).
            +!held(X)[source(percept)] <- +ran(forged).
            +x(Y)[source(percept)] <- +ran(forged).
            +x(Y)[source(self)] <- +ran(forged).
            +x(Y) <- .print(Y).
            +x <- +ran(belief).
            +jag_shutting_down(X) <- +ran(forged).
            """;
    /** Bytes of 0x80 and more stand for these, so that the fuzzer writes messages rather than noise. */
    private static final List<String> WORDS = List.of("tell;", "untell;", "achieve;", "unachieve;", "signal;",
            "tellHow;", "untellHow;", "askOne#AbC;", "askAll#AbC;", "askHow#AbC;", "tell#AbC;", "kqml_received(",
            "add_all_kqml_achieve(", "kqml::", "default::", "jag_shutting_down(", "source(", "cast(", "unicast,",
            "percept",
            "self", "'SUPO'", "\"SUPO\"", "x(", "own(", "trusted(", "go(", "opened(", "guarded(", "held(", "any(",
            "{ +!e", "{ @l +!go(X)", " : true <- ", " <- danger }", "\"+!e <- danger.\"", "[|T]", "|T]", "[", "]", "(",
            ")",
            ",", "X", "_", "1", "-", "+", "\"", "\\n", "math.sqrt(", ".print(", "~", "x", "a", "tellHow,", "achieve,",
            "m)",
            "start", "\u202e", "NS::");
    private static final int MOST_LINES = 6;
    private static final int MOST_CYCLES = 60;
    private static final List<String> SENDERS = List.of("ROMB", "SUPO", "SUAM");
    private static final Path FILE = program();
    private static final List<LogRecord> LOGGED = new ArrayList<>();

    static {
        Config.get().setProperty(Config.START_WEB_MI, "false");
        new RunLocalMAS();
        Logger root = Logger.getLogger("");
        Arrays.stream(root.getHandlers()).forEach(root::removeHandler);
        root.addHandler(new StreamHandler() {
            @Override
            public void publish(LogRecord line) {
                getFormatter().format(line);
                LOGGED.add(line);
            }
        });
        PlainLines.of("me");
    }

    private GateTarget() {
    }

    /** A Diffuser that notes what it is to perform. */
    public static final class Watched extends Diffuser {

        private static final long serialVersionUID = 1L;

        private boolean acted;

        @Override
        public void act(ActionExec action) {
            acted = true;
            action.setResult(true);
            actionExecuted(action);
        }
    }

    /** An agent whose cycles are this program's to run. */
    private static final class Body extends LocalAgArch {

        private static final long serialVersionUID = 1L;

        void cycle() {
            reasoningCycle();
        }
    }

    /** One line of the input. */
    private record Line(Address to, Address from, TrustLevel peer, Bytes content) {

        static Line of(byte[] bytes) {
            Address to = switch (bytes[0]) {
                case 'u', 's' -> Address.parse("CAFE");
                case 'm' -> Address.parse("//CA");
                default -> Address.BROADCAST;
            };
            String from = SENDERS.get(Math.floorMod(bytes[1], SENDERS.size()));
            StringBuilder content = new StringBuilder();
            for (int i = 2; i < bytes.length; i++) {
                content.append(bytes[i] < 0 ? WORDS.get((bytes[i] & 0x7F) % WORDS.size()) : (char) bytes[i]);
            }
            return new Line(to, Address.parse(from), bytes[0] == 's' ? TrustLevel.CERTIFIED : TrustLevel.PROVISIONED,
                    Bytes.ofText(content.toString()));
        }

        boolean isSealed() {
            return to.kind() != Address.Kind.BROADCAST;
        }

        /** Whether it may teach, where no plan asks for that. */
        boolean teaches() {
            return isSealed() && peer == TrustLevel.PROVISIONED && has("tellHow");
        }

        boolean has(String performative) {
            return new String(content.toArray(), StandardCharsets.UTF_8).startsWith(performative);
        }

        /** The mark of what it says, as Jason writes it. */
        String mark() {
            String cast = isSealed() ? to.kind() == Address.Kind.DEVICE ? "unicast" : "multicast" : "broadcast";
            return "cast(" + cast + "," + from + ")";
        }
    }

    public static void fuzzerTestOneInput(byte[] data) throws Exception {
        List<Line> lines = lines(data);
        LOGGED.clear();
        Body body = agent();
        Watched diffuser = (Watched) Diffuser.of(body.getTS());
        run(body, diffuser);
        List<String> plans = plans(body);
        Set<String> beliefs = beliefs(body);
        for (Line line : lines) {
            try {
                diffuser.inbox().put(new ReceivedMessage(line.from(), line.to(), 0, Content.decode(line.content())),
                        line.peer(), "me");
            } catch (ProtocolException e) {
                continue;  // The session drops and counts it.
            }
            run(body, diffuser);
        }
        check(lines, body, diffuser, plans, beliefs);
        body.stopAg();
    }

    private static void check(List<Line> lines, LocalAgArch body, Watched diffuser, List<String> plans,
            Set<String> beliefs) {
        List<String> plansNow = plans(body);
        holds(plansNow.containsAll(plans), "no plan is lost", plansNow);
        boolean taught = lines.stream().anyMatch(Line::teaches);
        holds(taught || plansNow.size() == plans.size(), "plans come by a sealed tellHow only", plansNow);
        holds(taught || lines.stream().anyMatch(line -> line.isSealed() && line.has("achieve")) || !diffuser.acted,
                "actions come by a sealed goal only", lines);
        Set<String> beliefsNow = beliefs(body);
        holds(beliefsNow.containsAll(beliefs), "no belief is lost", beliefsNow);
        holds(beliefsNow.stream().noneMatch(belief -> belief.equals("ran(forged)[source(self)]")),
                "no source is forged", beliefsNow);
        for (Literal belief : body.getTS().getAg().getBB()) {
            boolean ran = belief.toString().matches("ran\\(\\w+\\)\\[source\\(self\\)]");
            if (!taught && !ran) {
                checkTold(belief, beliefs.contains(untold(belief)), lines);
            }
        }
        for (LogRecord line : LOGGED) {
            String text = line.getMessage() + (line.getThrown() == null ? "" : " " + line.getThrown());
            holds(text.codePoints().noneMatch(Character::isISOControl), "a log's message is one line", text);
            holds(taught || line.getThrown() == null, "an exception comes of a taught plan only", text);
        }
    }

    /** Jason keeps one belief for all who say the same, also for the agent itself: it may have several sources. */
    private static void checkTold(Literal belief, boolean own, List<Line> lines) {
        holds(belief.hasSource(), "a belief has a source", belief);
        for (Term source : belief.getSources()) {
            boolean sender = lines.stream().anyMatch(line -> line.from().toString().equals(source.toString()));
            holds(sender || own, "the source is a sender", belief);
        }
        holds(own || !belief.getAnnots("cast").isEmpty(), "what is told is marked", belief);
        for (Term mark : belief.getAnnots("cast")) {
            holds(lines.stream().anyMatch(line -> line.mark().equals(mark.toString())), "the mark is its cast", belief);
        }
        for (Term mark : belief.getAnnots("peer")) {
            holds(lines.stream().anyMatch(line -> line.to().kind() == Address.Kind.DEVICE
                    && line.peer().mark(line.from().toString()).equals(mark)), "the mark is that of its key", belief);
        }
        holds(belief.getAnnots().stream().noneMatch(Term::isVar) && belief.getAnnots().getTail() == null,
                "no annotation stands for all", belief);
    }

    /** A belief without what the senders have added to it. */
    private static String untold(Literal belief) {
        Literal own = belief.copy();
        own.delAnnots(own.getAnnots("cast"));
        own.delAnnots(own.getAnnots("peer"));
        own.delAnnots(own.getAnnots("source").stream()
                .filter(source -> SENDERS.stream()
                        .anyMatch(sender -> source.toString().equals("source(" + sender + ")")))
                .toList());
        return own.toString();
    }

    private static void holds(boolean condition, String what, Object found) {
        if (!condition) {
            throw new AssertionError(what + ": " + found);
        }
    }

    private static List<Line> lines(byte[] data) {
        List<Line> lines = new ArrayList<>();
        int start = 0;
        for (int i = 0; i <= data.length && lines.size() < MOST_LINES; i++) {
            if (i == data.length || data[i] == '\n') {
                if (i - start > 2) {
                    lines.add(Line.of(Arrays.copyOfRange(data, start, i)));
                }
                start = i + 1;
            }
        }
        return lines;
    }

    private static void run(Body body, Diffuser diffuser) {
        int cycles = 0;
        do {
            body.cycle();
            cycles++;
        } while (cycles < MOST_CYCLES && !body.getTS().canSleep());
        holds(diffuser.inbox().isEmpty(), "the inbox is emptied", cycles);
    }

    private static Body agent() throws Exception {
        Body body = new Body();
        body.setAgName("me");
        body.createArchs(List.of(Watched.class.getName()), Agent.class.getName(), null, FILE.toString(),
                new Settings());
        return body;
    }

    private static List<String> plans(LocalAgArch body) {
        try {
            List<String> plans = new ArrayList<>();
            Object library = Agent.class.getMethod("getPL").invoke(body.getTS().getAg());
            ((Iterable<?>) library).forEach(plan -> plans.add(plan.toString()));
            return plans;
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Set<String> beliefs(LocalAgArch body) {
        Set<String> beliefs = new HashSet<>();
        body.getTS().getAg().getBB().forEach(belief -> beliefs.add(untold(belief)));
        return beliefs;
    }

    private static Path program() {
        try {
            Path file = Files.createTempFile("agent", ".asl");
            file.toFile().deleteOnExit();
            return Files.writeString(file, PROGRAM);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
