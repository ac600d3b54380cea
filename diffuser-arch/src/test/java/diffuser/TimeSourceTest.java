package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.function.Consumer;

import jason.architecture.AgArch;

import javino.board.BoardConfig;
import javino.fake.FakeBoard;
import javino.link.LinkOpener;
import javino.link.RealTime;
import javino.link.Time;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** An agent, its board and its libraries live in the time of an architecture behind the agent's. */
@Tag("newerJava")
class TimeSourceTest {

    /** Notes who asks for threads. */
    private static final class Noting extends RealTime {

        private final Set<String> names = new ConcurrentSkipListSet<>();

        @Override
        public Thread thread(String name, Runnable task) {
            names.add(name);
            return super.thread(name, task);
        }

        @Override
        public Timer timer(String name, Consumer<RuntimeException> failed) {
            names.add(name);
            return super.timer(name, failed);
        }

        @Override
        public LinkOpener port(String name) {
            return ScriptedDiffuser.linkTo(name);
        }
    }

    private static final Noting TIME = new Noting();

    /** Made by Jason. */
    public static final class Source extends AgArch implements TimeSource {

        private static final long serialVersionUID = 1L;

        @Override
        public Time time() {
            return TIME;
        }
    }

    /** A user's, which knows nothing of times. */
    public static final class OfUser extends Diffuser {

        private static final long serialVersionUID = 1L;

        @Override
        protected BoardConfig boardConfig() {
            return ScriptedDiffuser.quick();
        }
    }

    private static final String PROGRAM = "!start. +!start <- .port(left); .act(stop); diffuser.note(done).";

    @Test
    void time_ofAnArchitectureBehind_isThatOfTheBoardAndOfHosts() throws Exception {
        RunningAgent agent = RunningAgent.run(PROGRAM, null,
                List.of(OfUser.class.getName(), Source.class.getName()), new FakeBoard("left"));
        agent.notes("done");
        assertSame(TIME, agent.diffuser().time());
        assertEquals(Set.of("hosts of " + agent.name(), "javino left"), TIME.names);
    }

    @Test
    void time_withoutASource_isTheComputers() throws Exception {
        RunningAgent agent = RunningAgent.run(PROGRAM, new FakeBoard("left"));
        agent.notes("done");
        assertSame(Time.REAL, agent.diffuser().time());
    }
}
