package lockstep;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.util.HexFormat;
import java.util.List;
import java.util.StringTokenizer;

/** An emulator whose time goes on only as far as it is told (emulator/README.md, Lock-step). */
final class Lockstep extends EmulatorProcess {

    /** Nanoseconds of two cycles at 16 MHz. */
    private static final int TWO_CYCLES = 125;
    private static final String UNPLUGGED = "unplugged";
    private static final String DONE = "ok";
    private static final String PERFORMED = "{\"ok\":true}";
    /** The most bytes that a line may hold. */
    private static final int MOST_BYTES = 4096;

    /** What has happened at the boards' ports. */
    interface News {
        void bytes(int board, byte[] bytes);

        void unplugged(int board);

        void plugged(int board);
    }

    private final BufferedReader answers;
    private final Writer lines;

    Lockstep(List<String> command) throws IOException {
        super(new ProcessBuilder(command));
        answers = process.inputReader();
        lines = process.outputWriter();
    }

    private String ask(String line) {
        String answer = answer(line);
        if (answer == null) {
            awaitEnd();
            throw new IllegalStateException("the emulator has ended: " + complaints());
        }
        return answer;
    }

    private String answer(String line) {
        try {
            lines.write(line);
            lines.write('\n');
            lines.flush();
            return answers.readLine();
        } catch (IOException ended) {
            return null;  // Its complaints say why.
        }
    }

    /** Runs on to a time in ns, or until there are news. @return the time that was reached. */
    long run(long nanos, News news) {
        StringTokenizer words = new StringTokenizer(ask("run " + (2 * nanos + TWO_CYCLES - 1) / TWO_CYCLES), " ");
        long now = Long.parseLong(words.nextToken()) * TWO_CYCLES / 2;
        while (words.hasMoreTokens()) {
            int board = Integer.parseInt(words.nextToken());
            String what = words.nextToken();
            switch (what) {
                case UNPLUGGED -> news.unplugged(board);
                case "plugged" -> news.plugged(board);
                default -> news.bytes(board, HexFormat.of().parseHex(what));
            }
        }
        return now;
    }

    /** Opens a board's port. @return whether there is one. */
    boolean open(int board) {
        return DONE.equals(ask("open " + board));
    }

    void close(int board) {
        ask("close " + board);
    }

    /** Writes bytes to a board's port. @return how many it took; -1 if there is no port. */
    int write(int board, byte[] bytes, int from) {
        int to = Math.min(bytes.length, from + MOST_BYTES);
        String answer = ask("write " + board + " " + HexFormat.of().formatHex(bytes, from, to));
        return answer.equals(UNPLUGGED) ? -1 : Integer.parseInt(answer);
    }

    /** Gives a command, in the words of emulator/README.md. */
    void command(String json) throws IOException {
        String answer = ask(json);
        if (!answer.equals(PERFORMED)) {
            throw new IOException(json + ": " + answer);
        }
    }

    /** Ends it. @return its exit status. */
    int end() {
        try {
            lines.close();
        } catch (IOException ended) {
            // Its exit status says why.
        }
        return awaitEnd();
    }
}
