package bench;

import jason.asSemantics.Agent;
import jason.infra.local.BaseLocalMAS;
import jason.infra.local.LocalAgArch;
import jason.infra.local.RunLocalMAS;
import jason.runtime.Settings;
import jason.util.Config;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Jason agents in this process. */
final class Agents {

    static {
        Config.get().setProperty(Config.START_WEB_MI, "false");
        new RunLocalMAS();
    }

    private Agents() {}

    /** Starts an agent on a thread of its own. */
    static LocalAgArch start(String name, String program, Class<?>... architectures) throws Exception {
        Path source = Files.writeString(Files.createTempFile(name, ".asl"), program);
        LocalAgArch body = new LocalAgArch();
        body.setAgName(name);
        body.createArchs(List.of(architectures).stream().map(Class::getName).toList(), Agent.class.getName(), null,
                source.toString(), new Settings());
        BaseLocalMAS.getRunner().addAg(body);
        Thread thread = new Thread(body, name);
        thread.setDaemon(true);
        body.setThread(thread);
        body.startThread();
        return body;
    }
}
