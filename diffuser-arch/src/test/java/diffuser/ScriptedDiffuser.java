package diffuser;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

import javino.board.BoardConfig;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/** A Diffuser whose ports are fake boards; Jason makes it by its name, so the boards are found by theirs. */
public class ScriptedDiffuser extends Diffuser {

    private static final long serialVersionUID = 1L;

    private static final Map<String, FakeBoard> BOARDS = new ConcurrentHashMap<>();

    static void plug(FakeBoard board) {
        BOARDS.put(board.name(), board);
    }

    @Override
    protected LinkOpener link(String port) {
        return linkTo(port);
    }

    @Override
    protected BoardConfig boardConfig() {
        return quick();
    }

    /** To the fake board of that name, or to a port that is missing. */
    static LinkOpener linkTo(String port) {
        FakeBoard board = BOARDS.get(port);
        return board != null ? board : new LinkOpener() {
            @Override
            public Link open() throws LinkException {
                throw new LinkException(port, "there is no such port");
            }

            @Override
            public String name() {
                return port;
            }
        };
    }

    /** Settings with which little is waited for. */
    static BoardConfig quick() {
        return BoardConfig.create(config -> config
                .setHold(Duration.ofMillis(50))
                .setReplyTimeout(Duration.ofMillis(50))
                .setHelloInterval(Duration.ofMillis(10))
                .setReopenInterval(Duration.ofMillis(10))
                .setPatience(Duration.ofSeconds(5)).setAttempts(20));
    }
}
