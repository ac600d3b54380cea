package bench;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;

import harness.Table;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.fake.FakeBoard;
import javino.protocol.BoardInfo;

/** The CPU time and the threads that a hundred idle boards in one program take. */
public final class ManyBoards implements Subject {

    private static final int BOARDS = 100;
    private static final Duration WARM_UP = Duration.ofSeconds(20);
    private static final Duration MEASURED = Duration.ofSeconds(20);

    @Override
    public String name() {
        return "many";
    }

    @Override
    public String method() {
        return """
            a program with 100 sessions (`Board`), percepts switched on, and one with a single session, each in a Java
            virtual machine of its own; the boards are in memory, and one thread plays them all, which counts too. CPU
            time over 20 s after 20 s in which Java compiles; threads of the whole program less those of one without
            boards. With Java 21 and newer, sessions run on virtual threads; `-PvirtualThreads=HOME` measures a Java of
            that folder too.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        List<Row> rows = new ArrayList<>(measure(System.getProperty("java.home")));
        String newer = System.getProperty("bench.virtualThreads");
        if (newer != null) {
            rows.addAll(measure(newer));
        }
        return rows;
    }

    private static List<Row> measure(String home) throws Exception {
        String[] none = run(home, 0);
        String[] one = run(home, 1);
        String[] many = run(home, BOARDS);
        double forOne = Double.parseDouble(one[0]) - Double.parseDouble(none[0]);
        double forMany = Double.parseDouble(many[0]) - Double.parseDouble(none[0]);
        String with = "100 idle boards in one program, Java " + none[2];
        return List.of(
                Row.against(with + ", CPU", "%.2f %% of a core", forMany, BOARDS * forOne, "100 × one")
                        .goal("≤ 1").claim(),
                Row.of(with + ", threads",
                        Integer.toString(Integer.parseInt(many[1]) - Integer.parseInt(none[1])))
                        .goal("≤ 20").claim());
    }

    private static String[] run(String home, int boards) throws Exception {
        String java = Path.of(home, "bin", "java").toString();
        List<String> lines = Command.run(java, "-cp", System.getProperty("java.class.path"), ManyBoards.class.getName(),
                boards);
        return lines.get(lines.size() - 1).split(" ");
    }

    /** Prints the CPU's share in percent, the number of threads and Java's version. */
    public static void main(String[] count) throws Exception {
        int boards = Integer.parseInt(count[0]);
        CountDownLatch online = new CountDownLatch(boards);
        for (int i = 0; i < boards; i++) {
            Board.open(new FakeBoard().perceive("light(1)").port, BoardConfig.create(), new BoardListener() {
                @Override
                public void online(BoardInfo info) {
                    online.countDown();
                }
            }).percepts(true);
        }
        online.await();
        Thread.sleep(WARM_UP.toMillis());
        ProcessHandle self = ProcessHandle.current();
        long before = Threads.cpuNanos(self);
        Thread.sleep(MEASURED.toMillis());
        long used = Threads.cpuNanos(self) - before;
        System.out.println(Table.text("%.4f", 100.0 * used / MEASURED.toNanos()) + " " + Threads.count(self)
                + " " + Runtime.version().feature());
        System.exit(0);
    }
}
