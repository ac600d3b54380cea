package javino.cli;

import java.io.IOException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardState;

/** Work that goes on until the user ends it. */
public final class UntilInterrupted {

    private static final int SECONDS_TO_END = 3;

    private UntilInterrupted() {
    }

    /** Ends by an interrupt, if by nothing else. */
    public interface Work {
        /** @throws InterruptedException when it is to end. */
        void run() throws JavinoException, IOException, InterruptedException;
    }

    /**
     * Does the work until the thread is interrupted, or Ctrl-C or a kill ends the program; that then waits until the
     * work has closed what it opened.
     */
    public static void run(Work work) throws JavinoException, IOException {
        Thread worker = Thread.currentThread();
        CountDownLatch ended = new CountDownLatch(1);
        // It stays until the program ends, and by then may find nothing left to interrupt.
        Runtime.getRuntime().addShutdownHook(new Thread(() -> interrupt(worker, ended)));
        try {
            work.run();
        } catch (InterruptedException e) {
            // The user wanted it so.
            return;
        } finally {
            ended.countDown();
        }
    }

    /**
     * Does the work with the board's radio open, if it has one, and blocks it then, so that no message waits for a
     * program that has ended.
     */
    static void listen(Board board, Work work) throws JavinoException, IOException, InterruptedException {
        if (board.info().filter(info -> !info.hasRadio() && !info.isLegacy()).isPresent()) {
            work.run();
            return;
        }
        try {
            Await.result(board, board.radio(true));
            work.run();
        } finally {
            blockRadio(board);
        }
    }

    private static void blockRadio(Board board) throws InterruptedException {
        try {
            if (board.state() == BoardState.ONLINE) {
                Await.result(board, board.radio(false));
            }
        } catch (JavinoException e) {
            // The board went at the same time.
            return;
        }
    }

    private static void interrupt(Thread worker, CountDownLatch ended) {
        if (ended.getCount() > 0) {
            worker.interrupt();
        }
        try {
            ended.await(SECONDS_TO_END, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            // Nobody interrupts this thread; if so, the program ends all the same.
            return;
        }
    }
}
