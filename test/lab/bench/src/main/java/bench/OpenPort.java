package bench;

import harness.Emulator;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.link.SerialLink;
import javino.protocol.BoardInfo;

/** How long it takes until a board that is alive can be used. */
final class OpenPort implements Subject {

    private static final int TIMES = 20;

    @Override
    public String name() {
        return "open";
    }

    @Override
    public String method() {
        return """
            an emulated board with the sketch Station that is not reset by opening its port (`"resetOnOpen": false`):
            from `Board.open` to the listener's `online`, 20 times, after a first time in which Java loads its
            classes.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        Samples milliseconds = new Samples();
        try (Emulator emulator = new Emulator.Scenario().board("board", "Station", Map.of("resetOnOpen", false))
                .start(Files.createTempDirectory("javino-bench"))) {
            open(emulator);
            for (int i = 0; i < TIMES; i++) {
                milliseconds.add(open(emulator));
            }
        }
        return List.of(
                Row.cited("opening a live board's port, median", "%.0f ms", milliseconds.median(), 3036,
                        "the paper's software").goal("≤ 100 ms"),
                Row.cited("the same, longest", "%.0f ms", milliseconds.greatest(), 3036, "the paper's software")
                        .goal("≤ 100 ms"));
    }

    private static double open(Emulator emulator) throws InterruptedException {
        CountDownLatch online = new CountDownLatch(1);
        long begun = System.nanoTime();
        Board board = Board.open(SerialLink.opener(emulator.port("board")), BoardConfig.create(), new BoardListener() {
            @Override
            public void online(BoardInfo info) {
                online.countDown();
            }
        });
        online.await();
        double milliseconds = (System.nanoTime() - begun) / 1e6;
        board.close();
        return milliseconds;
    }
}
