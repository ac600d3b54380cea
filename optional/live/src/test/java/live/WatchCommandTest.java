package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ServiceLoader;
import javino.cli.CommandPlugin;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

class WatchCommandTest {

    @Test
    void javino_findsTheCommand() {
        assertTrue(ServiceLoader.load(CommandPlugin.class).stream().map(ServiceLoader.Provider::type)
                .anyMatch(WatchCommand.class::equals));
    }

    @ParameterizedTest
    @CsvSource({"'', watch takes either", "--port a --trace b, watch takes either",
            "--trace b --control c, --control needs --trace -", "--port a --control c, --control needs --trace -",
            "--trace b --http-port 65536, '--http-port takes 0 to 65535, not 65536'"})
    void options_wrong_areRefused(String options, String reason) {
        StringWriter errors = new StringWriter();
        CommandLine command = new CommandLine(new WatchCommand()).setErr(new PrintWriter(errors, true));

        int status = command.execute(options.isEmpty() ? new String[0] : options.split(" "));

        assertEquals(CommandLine.ExitCode.USAGE, status);
        assertTrue(errors.toString().startsWith(reason), errors.toString());
    }
}
