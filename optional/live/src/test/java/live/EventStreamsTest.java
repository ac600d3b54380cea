package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.Socket;
import java.net.URI;
import java.net.URLConnection;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Pages that read at once, late, or never. */
@Tag("newerJava")
@Timeout(120)
class EventStreamsTest extends ServerFixture {

    private static final String SKIPPED = "[{\"event\":\"skipped\",\"count\":";
    private static final int PATIENCE_MILLIS = 60_000;

    /** The stream that a page reads. */
    private BufferedReader page(String more, String... header) throws IOException {
        URLConnection page = URI.create("http://" + host() + "/events?token=" + token() + more).toURL()
                .openConnection();
        page.setReadTimeout(PATIENCE_MILLIS);
        if (header.length > 0) {
            page.setRequestProperty(header[0], header[1]);
        }
        return new BufferedReader(new InputStreamReader(page.getInputStream(), StandardCharsets.UTF_8));
    }

    /** A page that leaves it to its caller to read. */
    private Socket silentPage() throws IOException {
        Socket page = connect("GET /events?token=" + token(), "Host: " + host());
        page.setSoTimeout(PATIENCE_MILLIS);
        return page;
    }

    /** The beginning of the answer to a page. */
    private static String status(Socket page) throws IOException {
        return new BufferedReader(new InputStreamReader(page.getInputStream(), StandardCharsets.UTF_8)).readLine();
    }

    /** The next line that begins so, without the beginning. */
    private static String next(BufferedReader page, String beginning) throws IOException {
        String line = page.readLine();
        while (!line.startsWith(beginning)) {
            line = page.readLine();
        }
        return line.substring(beginning.length());
    }

    @Test
    void page_getsWhatWasAndWhatComes() throws IOException {
        hub.add("{\"t\":1}");
        hub.add("{\"t\":2}");
        try (BufferedReader page = page("")) {
            assertEquals("2", next(page, "id: "));
            assertEquals("[{\"t\":1},{\"t\":2}]", next(page, "data: "));
            hub.add("{\"t\":3}");
            assertEquals("3", next(page, "id: "));
            assertEquals("[{\"t\":3}]", next(page, "data: "));
        }
    }

    @Test
    void page_thatComesAgain_goesOnWhereItWas() throws IOException {
        hub.add("{\"t\":1}");
        hub.add("{\"t\":2}");
        try (BufferedReader page = page("&from=1")) {
            assertEquals("[{\"t\":2}]", next(page, "data: "));
        }
        try (BufferedReader page = page("&from=0", "Last-Event-ID", "1")) {
            assertEquals("[{\"t\":2}]", next(page, "data: "));
        }
    }

    @Test
    void pages_ten_getTheSame() throws IOException {
        List<BufferedReader> pages = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            pages.add(page(""));
        }
        hub.add("{\"t\":1}");
        for (BufferedReader page : pages) {
            assertEquals("[{\"t\":1}]", next(page, "data: "));
            page.close();
        }
    }

    @Test
    void page_thatNeverReads_stopsNobody() throws IOException {
        String event = "{\"t\":1,\"event\":\"note\",\"text\":\"" + "x".repeat(1000) + "\"}";
        try (Socket stalled = silentPage(); BufferedReader page = page("")) {
            assertTrue(status(stalled).contains(" 200 "));
            // Far more than the buffers between the two ends take.
            for (int i = 0; i < 50_000; i++) {
                hub.add(event);
            }
            hub.add("{\"t\":2}");
            String data = next(page, "data: ");
            while (!data.endsWith("{\"t\":2}]")) {
                data = next(page, "data: ");
            }
        }
    }

    @Test
    void pages_gone_makeRoomForOthers() throws IOException, InterruptedException {
        List<Socket> pages = new ArrayList<>();
        for (int i = 0; i < EventStreams.MOST_PAGES; i++) {
            pages.add(silentPage());
            assertTrue(status(pages.get(i)).contains(" 200 "));
        }
        try (Socket tooMany = silentPage()) {
            assertTrue(status(tooMany).contains(" 503 "));
        }
        for (Socket page : pages) {
            page.close();
        }
        String answer = "";
        while (!answer.contains(" 200 ")) {
            hub.add("{\"t\":1}");
            Thread.sleep(20);
            try (Socket one = silentPage()) {
                answer = status(one);
            }
        }
    }

    @Test
    void flood_slowPage_isToldHowManyWereSkipped() throws IOException {
        int flood = 10 * Hub.FAR_BEHIND;
        try (BufferedReader page = page("")) {
            hub.add("{\"t\":1}");
            next(page, "data: ");
            for (int i = 0; i < flood; i++) {
                hub.add("{\"t\":2}");
            }
            long got = 0;
            long skipped = 0;
            while (got + skipped < flood) {
                String data = next(page, "data: ");
                if (data.startsWith(SKIPPED)) {
                    skipped += Long.parseLong(data.substring(SKIPPED.length()).replaceFirst("}.*", ""));
                }
                got += data.split("\"t\":2", -1).length - 1;
            }
            assertTrue(skipped > 0);
            assertEquals(flood, got + skipped);
        }
    }
}
