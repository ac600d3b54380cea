package features;

import io.cucumber.java.ParameterType;

/** The parameters of steps. */
public final class Parameters {

    private static final String TIME = "\\d+(?:\\.\\d+)? (?:ms|s|min)";

    /** The pin of a board, by its number or the name that {@code board.json} watches it under. */
    record Pin(String board, String name) {

        @Override
        public String toString() {
            return board + "'s " + (name.matches("A?\\d+") ? "pin " : "") + name;
        }
    }

    /** The address that an agent gives its board. */
    record Peer(String address, String board) {}

    @ParameterType(value = "(\\w+) \\((\\w+)'s board\\)", useForSnippets = false)
    public Peer peer(String address, String board) {
        return new Peer(address, board);
    }

    @ParameterType(value = "delivered|undelivered|sent", useForSnippets = false)
    public String outcome(String text) {
        return text;
    }

    /** What a sensor senses; the type that {@code board.json} gives it. */
    @ParameterType(value = "light|distance|level", useForSnippets = false)
    public String quantity(String text) {
        return text.equals("light") ? "ldr" : text.equals("distance") ? "hc-sr04" : "digital";
    }

    /** A time, in ns. */
    @ParameterType(TIME)
    public Long time(String text) {
        return Window.nanos(text);
    }

    /** When something is expected; may be empty. */
    @ParameterType(value = "(?:(?:not )?within " + TIME + "(?: of its return)? |never )?", useForSnippets = false)
    public Window window(String text) {
        return Window.parse(text);
    }

    /** Of what came by radio: its sender, and that a key has proved it; may be empty. */
    @ParameterType(value = "(?: from \\w+)?(?:,? sealed)?", useForSnippets = false)
    public String marks(String text) {
        return text == null ? "" : text;
    }

    /** How often something is expected; may be empty, and is null then. */
    @ParameterType(value = "(?: exactly \\d+ times?| at most \\d+ a second)?", useForSnippets = false)
    public Window.Count often(String text) {
        return text == null || text.isEmpty() ? null
                : new Window.Count(Integer.parseInt(text.replaceAll("\\D", "")), text.endsWith("second"));
    }

    /** A board; {@code its} is that of the step before. */
    @ParameterType(value = "\\w+'s|its", useForSnippets = false)
    public String board(String text) {
        return Run.now().board(text);
    }

    @ParameterType(value = "(\\w+'s|its) (?:pin )?(\\w+)", useForSnippets = false)
    public Pin pin(String board, String name) {
        return new Pin(Run.now().board(board), name);
    }

    /** An agent; {@code it} is that of the step before. */
    @ParameterType(value = "the agent \\w+|it", useForSnippets = false)
    public String agent(String text) {
        return Run.now().agent(text);
    }

    /** A term of AgentSpeak. */
    @ParameterType(value = ".+?", useForSnippets = false)
    public String term(String text) {
        return text;
    }

    /** How a pin is. */
    @ParameterType(value = "on|off|high|low|at \\d+ %", useForSnippets = false)
    public String level(String text) {
        return text.startsWith("at") ? Account.state(Long.parseLong(text.replaceAll("\\D", "")))
                : text.replace("high", "on").replace("low", "off");
    }
}
