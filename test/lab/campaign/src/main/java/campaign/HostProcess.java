package campaign;

import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A {@link HostProgram} in a Java virtual machine of its own. */
final class HostProcess implements AutoCloseable {

    private static final long PATIENCE_SECONDS = 300;

    private final List<String> command;
    private Process process;

    /** Starts it; the arguments are those of {@link HostProgram#main}. */
    HostProcess(String port, Field.Post to, String spare, String log) throws IOException {
        String java = System.getProperty("java.home") + File.separator + "bin" + File.separator + "java";
        // Small and quick to start: there are dozens.
        command = List.of(java, "-Xmx64m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-cp",
                System.getProperty("java.class.path"),
                HostProgram.class.getName(), port, to.address().toString(), spare, log);
        start();
    }

    private void start() throws IOException {
        process = new ProcessBuilder(command).redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
    }

    /** Kills it as it stands, with SIGKILL, and starts it anew. */
    synchronized void killAndRestart() throws IOException, InterruptedException {
        process.destroyForcibly().waitFor();
        start();
    }

    /** Asks it to end; {@link #close} waits for that. */
    synchronized void finish() throws IOException {
        process.getOutputStream().close();
    }

    @Override
    public synchronized void close() throws IOException {
        finish();
        try {
            if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                throw new IOException("a host did not end: " + command);
            }
            if (process.exitValue() != 0) {
                throw new IOException("a host ended with " + process.exitValue() + ": " + command);
            }
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        } finally {
            process.destroyForcibly();
        }
    }
}
