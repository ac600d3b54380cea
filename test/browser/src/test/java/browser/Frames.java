package browser;

import java.io.IOException;
import java.net.Socket;
import java.net.StandardProtocolFamily;
import java.net.URI;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Measures what the page shows beside the emulation: frames a second with 5 and 32 boards, all of which move, while a
 * injector sends; and how much of real time the run reaches without a page, with one, and with ten of which nine
 * ask for the events and read none.
 */
public final class Frames {

    private static final int SECONDS = 15;
    /** Tenths of a second until all has begun. */
    private static final int WARM_UP = 30;
    private static final int STALLED = 9;
    private static final String HELLO = "2f2f2f2f4556494c" + "74656c6c3b68656c70";

    private final Path folder;

    private Frames(Path folder) {
        this.folder = folder;
    }

    /** Prints a row for each number of boards. */
    public static void main(String[] arguments) throws Exception {
        System.out.println("boards  pages  frames a second (median, least)  emulated seconds a second");
        for (int boards : new int[] {5, 32}) {
            for (int pages : new int[] {0, 1, 1 + STALLED}) {
                new Frames(Files.createTempDirectory("frames")).measure(boards, pages);
            }
        }
        System.exit(0);
    }

    private void measure(int boards, int pages) throws Exception {
        Files.writeString(folder.resolve("many.json"), scenario(boards));
        List<Socket> stalled = new ArrayList<>();
        Page page = null;
        try (LiveRun run = LiveRun.piped(folder, "many.json");
                SocketChannel control = SocketChannel.open(StandardProtocolFamily.UNIX)) {
            URI address = URI.create(run.address());
            control.connect(UnixDomainSocketAddress.of(folder.resolve("control")));
            control.configureBlocking(false);
            for (int i = 1; i < pages; i++) {
                stalled.add(stalled(address));
            }
            if (pages > 0) {
                page = Page.open(address.toString());
                page.await("section.agent", boards);
            }
            List<Long> frames = new ArrayList<>();
            double from = 0;
            long begun = 0;
            for (int i = -WARM_UP; i < 10 * SECONDS; i++) {
                if (i == 0) {
                    from = run.seconds();
                    begun = System.nanoTime();
                }
                disturb(control, i, boards);
                TimeUnit.MILLISECONDS.sleep(100);
                if (i > 0 && i % 10 == 9 && pages > 0) {
                    frames.add(Long.parseLong(page.attribute("html", "data-fps")));
                }
            }
            double speed = (run.seconds() - from) / ((System.nanoTime() - begun) / 1e9);
            frames.sort(null);
            System.out.println(String.format(Locale.ROOT, "%6d  %5d  %31s  %.2f", boards, pages,
                    pages == 0 ? "" : frames.get(frames.size() / 2) + ", " + frames.get(0), speed));
        } finally {
            for (Socket socket : stalled) {
                socket.close();
            }
            if (page != null) {
                page.close();
            }
        }
    }

    private static Socket stalled(URI address) throws IOException {
        Socket socket = new Socket(address.getHost(), address.getPort());
        socket.getOutputStream()
                .write(("GET /events?" + address.getQuery() + " HTTP/1.1\r\nHost: " + address.getAuthority()
                        + "\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
        return socket;
    }

    private static void disturb(SocketChannel control, int tenths, int boards) throws IOException {
        StringBuilder commands = new StringBuilder();
        for (int board = 0; board < boards; board++) {
            commands.append(
                    String.format(Locale.ROOT, "{\"do\":\"move\",\"board\":\"b%d\",\"position\":[%.2f,%d]}%n", board,
                            10 * Math.sin(tenths / 10.0 + board), 5 * board));
        }
        if (tenths % 5 == 0) {
            commands.append("{\"do\":\"send\",\"position\":[0,0],\"payload\":\"" + HELLO + "\"}\n");
        }
        control.write(ByteBuffer.wrap(commands.toString().getBytes(StandardCharsets.UTF_8)));
        control.read(ByteBuffer.allocate(1 << 16));
    }

    private static String scenario(int boards) {
        return IntStream.range(0, boards).mapToObj(board -> String.format("""
                {"name": "b%d", "firmware": "%s/javino-firmware/build/station/Station.ino.elf", "position": [0, %d]}""",
                board, LiveRun.ROOT, 5 * board)).collect(Collectors.joining(",\n", "{\"boards\": [\n", "]}\n"));
    }
}
