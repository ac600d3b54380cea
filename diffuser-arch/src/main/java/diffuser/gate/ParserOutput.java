package diffuser.gate;

import java.io.OutputStream;
import java.io.PrintStream;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Takes what Jason's parser prints on the standard error where it has failed without saying so to its caller. What
 * other threads print meanwhile is printed.
 */
final class ParserOutput extends OutputStream {

    private static final ReentrantLock ONE_AT_A_TIME = new ReentrantLock();

    private final Thread parsing = Thread.currentThread();
    private final PrintStream before;
    private boolean empty = true;

    /** Begins with the calling thread. */
    ParserOutput() {
        ONE_AT_A_TIME.lock();
        before = System.err;
        System.setErr(new PrintStream(this, true));
    }

    @Override
    public void write(int octet) {
        if (Thread.currentThread() == parsing) {
            empty = false;
        } else {
            before.write(octet);
        }
    }

    /** Whether nothing was printed. */
    boolean isEmpty() {
        return empty;
    }

    @Override
    public void close() {
        System.setErr(before);
        ONE_AT_A_TIME.unlock();
    }
}
