package diffuser;

import static org.junit.jupiter.api.Assertions.assertFalse;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

import javino.board.BoardConfig;
import javino.fake.FakeBoard;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/** A Diffuser whose ports are fake boards; Jason makes it by its name, so the boards are found by theirs. */
public class ScriptedDiffuser extends Diffuser {

    private static final long serialVersionUID = 1L;

    private static final Map<String, FakeBoard> BOARDS = new ConcurrentHashMap<>();
    /** The thread that has opened each port last; a link is opened on its session's thread. */
    private static final Map<String, Thread> SESSIONS = new ConcurrentHashMap<>();

    static void plug(FakeBoard board) {
        BOARDS.put(board.port.name(), board);
    }

    @Override
    protected LinkOpener link(String port) {
        return linkTo(port);
    }

    @Override
    protected BoardConfig boardConfig() {
        return quick();
    }

    /** The thread of the session that has opened a port last. */
    static Thread session(String port) {
        return SESSIONS.get(port);
    }

    /** Ends all sessions that are left, and unplugs all boards. */
    static void endAll() throws InterruptedException {
        Map<String, FakeBoard> boards = Map.copyOf(BOARDS);
        BOARDS.clear();
        for (FakeBoard board : boards.values()) {
            board.port.blockClosing(false);
            board.unplug();
        }
        for (Thread session : SESSIONS.values()) {
            join(session);
        }
        SESSIONS.clear();
    }

    /** Waits until a session has ended. */
    static void join(Thread session) throws InterruptedException {
        Patience patience = new Patience();
        while (session.isAlive() && patience.lasts()) {
            session.join(Patience.STEP.toMillis());
        }
        assertFalse(session.isAlive(), "the session goes on");
    }

    /** To the fake board of that name, or to a port that is missing. */
    static LinkOpener linkTo(String port) {
        FakeBoard board = BOARDS.get(port);
        Object test = ClosedAgents.test();
        return new LinkOpener() {
            @Override
            public Link open() throws LinkException {
                SESSIONS.put(port, Thread.currentThread());
                if (test != ClosedAgents.test()) {
                    throw new IllegalStateException(port + ": a session goes on that another test has left behind");
                }
                if (board == null) {
                    throw new LinkException(port, "there is no such port");
                }
                return board.port.open();
            }

            @Override
            public String name() {
                return port;
            }
        };
    }

    /** Settings with which little is waited for. */
    static BoardConfig quick() {
        return quick(Duration.ofSeconds(1));
    }

    /** The same, with another time for a request that the board has taken. */
    static BoardConfig quick(Duration actionTime) {
        return BoardConfig.create(config -> config
                .setHold(Duration.ofMillis(50))
                .setReplyTimeout(Duration.ofMillis(50))
                .setActionTime(actionTime)
                .setHelloInterval(Duration.ofMillis(10))
                .setReopenInterval(Duration.ofMillis(10))
                .setPatience(Duration.ofSeconds(5)).setAttempts(20));
    }
}
