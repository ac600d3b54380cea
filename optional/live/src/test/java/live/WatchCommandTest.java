package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.ServiceLoader;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javino.cli.CommandPlugin;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

class WatchCommandTest {

    @Test
    void javino_findsTheCommand() {
        assertTrue(ServiceLoader.load(CommandPlugin.class).stream().map(ServiceLoader.Provider::type)
                .anyMatch(WatchCommand.class::equals));
    }

    @Test
    @Timeout(60)
    void address_standsAloneOnTheLastLine(@TempDir Path folder) throws Exception {
        Path trace = Files.writeString(folder.resolve("trace"), "{\"t\":0,\"event\":\"note\"}\n");
        StringWriter out = new StringWriter();
        CommandLine command = new CommandLine(new WatchCommand()).setOut(new PrintWriter(out, true));
        CompletableFuture<Integer> status = new CompletableFuture<>();
        Thread thread = new Thread(() -> status.complete(
                command.execute("--trace", trace.toString(), "--no-browser")));
        thread.start();
        while (!out.toString().contains("token=")) {
            Thread.sleep(2);
        }
        thread.interrupt();

        assertEquals(0, status.get());
        List<String> lines = out.toString().lines().toList();
        Matcher address = Pattern.compile("http://127\\.0\\.0\\.1:(\\d+)/\\?token=\\p{XDigit}{32}")
                .matcher(lines.get(lines.size() - 1));
        assertTrue(address.matches(), out.toString());
        assertEquals(!Browser.hasScreen(), out.toString()
                .contains("ssh -L " + address.group(1) + ":127.0.0.1:" + address.group(1) + " "), out.toString());
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
