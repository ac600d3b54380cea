package harness;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;

/**
 * An MQTT broker on this computer, with TLS by a CA of its own. Each cell is a user that publishes for itself only, as
 * docs/how-to/join-two-cells.md has it; only {@link #OWNER} may do all.
 */
public final class Mosquitto implements AutoCloseable {

    public static final String OWNER = "owner";
    private static final int FIRST_PORT = 20_000;
    private static final int LAST_PORT = 30_000;
    /** The password of all users. */
    public static final String PASSWORD = "together";
    /** The topics that a user named as its cell may write and read (docs/mqtt.md). */
    private static final String ACCESS = """
            pattern write javino/+/+/from/%u/#
            pattern read javino/to/%u/from/#
            pattern read javino/gateway/+/from/%u
            pattern read javino/group/#
            pattern read javino/search/#
            pattern read javino/seek/#
            pattern read javino/broadcast/#
            """;
    private static final long PATIENCE_SECONDS = 240;
    private static final long PAUSE_MILLIS = 20;

    private final Path folder;
    private int port;
    private Process process;

    private Mosquitto(Path folder) {
        this.folder = folder;
    }

    /** Starts one whose files are in that folder, for its owner and these cells. */
    public static Mosquitto start(Path folder, String... cells) throws IOException, InterruptedException {
        Files.createDirectories(folder);
        Mosquitto broker = new Mosquitto(folder);
        broker.certify();
        broker.run("mosquitto_passwd", "-b", "-c", broker.path("passwords"), OWNER, PASSWORD);
        for (String cell : cells) {
            broker.run("mosquitto_passwd", "-b", broker.path("passwords"), cell, PASSWORD);
        }
        Files.writeString(folder.resolve("acl"), "user " + OWNER + "\ntopic readwrite #\ntopic read $SYS/#\n" + ACCESS);
        // Only now: another program may take a port that is free before this one does.
        broker.port = freePort();
        Files.writeString(folder.resolve("mosquitto.conf"),
                """
                user %s
                listener %d 127.0.0.1
                allow_anonymous false
                password_file %s
                acl_file %s
                certfile %s
                keyfile %s
                sys_interval 1
                persistence true
                persistence_location %s/
                """.formatted(System.getProperty("user.name"), broker.port, broker.path("passwords"),
                        broker.path("acl"),
                        broker.path("broker.pem"), broker.path("broker.key"), folder));
        broker.start();
        return broker;
    }

    /** A port of this computer that nobody uses; below those that systems give to whoever asks for any meanwhile. */
    public static int freePort() throws IOException {
        while (true) {
            int port = ThreadLocalRandom.current().nextInt(FIRST_PORT, LAST_PORT);
            try (ServerSocket socket = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
                return socket.getLocalPort();
            } catch (BindException taken) {
                // Another one, then.
            }
        }
    }

    private void certify() throws IOException, InterruptedException {
        run("openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=CA of a test",
                "-keyout", path("ca.key"), "-out", path("ca.pem"));
        run("openssl", "req", "-newkey", "rsa:2048", "-nodes", "-subj", "/CN=localhost", "-keyout",
                path("broker.key"), "-out", path("broker.csr"));
        Files.writeString(folder.resolve("names"), "subjectAltName=DNS:localhost,IP:127.0.0.1\n");
        run("openssl", "x509", "-req", "-in", path("broker.csr"), "-CA", path("ca.pem"), "-CAkey", path("ca.key"),
                "-CAcreateserial", "-days", "2", "-extfile", path("names"), "-out", path("broker.pem"));
    }

    private String path(String file) {
        return folder.resolve(file).toString();
    }

    private void run(String... command) throws IOException, InterruptedException {
        Process run = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
                .redirectOutput(folder.resolve("setup.log").toFile()).start();
        if (run.waitFor() != 0) {
            throw new AssertionError(List.of(command) + ": " + Files.readString(folder.resolve("setup.log")));
        }
    }

    /** Starts it, again after {@link #stop}. */
    public void start() throws IOException, InterruptedException {
        process = new ProcessBuilder("/usr/sbin/mosquitto", "-c", path("mosquitto.conf"))
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.appendTo(folder.resolve("mosquitto.log").toFile())).start();
        // A run that is broken off leaves no process behind.
        Runtime.getRuntime().addShutdownHook(new Thread(process::destroy));
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!answers()) {
            if (!process.isAlive() || System.nanoTime() > end) {
                throw new AssertionError(Files.readString(folder.resolve("mosquitto.log")));
            }
            TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
        }
    }

    private boolean answers() {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            return socket.isConnected();
        } catch (IOException nobody) {
            return false;
        }
    }

    /**
     * Joins it, as a region with these cells, to a broker that may be reached by another port (docs/mqtt.md). The first
     * cell names the connection.
     */
    public void bridge(Mosquitto middle, int port, String... cells) throws IOException, InterruptedException {
        stop();
        StringBuilder bridge = new StringBuilder("""
                connection %s
                address localhost:%d
                bridge_protocol_version mqttv50
                remote_username %s
                remote_password %s
                bridge_cafile %s
                restart_timeout 1 2
                topic javino/to/# out 0
                topic javino/group/# both 0
                topic javino/search/# both 0
                topic javino/seek/# both 0
                topic javino/broadcast/# both 0
                """.formatted(cells[0], port, OWNER, PASSWORD, middle.ca()));
        for (String cell : cells) {
            bridge.append("topic javino/to/" + cell + "/# in 0\n");
        }
        Files.writeString(folder.resolve("mosquitto.conf"), bridge, StandardOpenOption.APPEND);
        start();
    }

    /** Ends it as a loss of power does. */
    public void kill() throws InterruptedException {
        process.destroyForcibly();
        process.waitFor();
    }

    /** Stops it; what it has kept stays in its folder. */
    public void stop() throws InterruptedException {
        process.destroy();
        process.waitFor();
    }

    /** Removes what it has kept, as if it kept nothing over its end. */
    public void forget() throws IOException {
        Files.deleteIfExists(folder.resolve("mosquitto.db"));
    }

    /** The ids of a user's clients, in the order in which they came: only the broker's owner sees them. */
    public List<String> ids(String user) throws IOException {
        return Files.readString(folder.resolve("mosquitto.log")).lines()
                .filter(line -> line.contains("connected from ") && line.contains("u'" + user + "'"))
                .map(line -> line.replaceFirst(".* as (\\S+) \\(.*", "$1")).toList();
    }

    /** The process, to see how much it takes. */
    public ProcessHandle process() {
        return process.toHandle();
    }

    public int port() {
        return port;
    }

    /** The certificate of its CA. */
    public Path ca() {
        return folder.resolve("ca.pem");
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
