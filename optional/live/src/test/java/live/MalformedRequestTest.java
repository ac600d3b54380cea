package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Bytes that are no good request, sent as they are: the answer is that, and shows nothing of the server. */
@Timeout(120)
class MalformedRequestTest extends ServerFixture {

    private static final String END = "\r\n\r\n";
    /** Stands for this server's own name. */
    private static final String OWN = "Host: OWN";
    private static final String CLOSE = "\r\nConnection: close" + END;

    private String send(String request) throws IOException {
        try (Socket socket = new Socket("127.0.0.1", port())) {
            socket.setSoTimeout(20_000);
            socket.getOutputStream().write(request.replace("OWN", host()).replace("TOKEN", token())
                    .getBytes(StandardCharsets.ISO_8859_1));
            socket.shutdownOutput();
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    static Stream<String> malformed() {
        return Stream.of(
                // Without a host, or with several, or with what is none.
                "GET / HTTP/1.0" + END, "GET /about?token=TOKEN HTTP/1.0" + END, "GET / HTTP/1.1\r\nConnection: close"
                        + END,
                "GET / HTTP/1.1\r\n" + OWN + "\r\n" + OWN + CLOSE, "GET / HTTP/1.1\r\n" + OWN
                        + "\r\nHost: evil.example" + CLOSE,
                "GET / HTTP/1.1\r\nHost: evil.example\r\n" + OWN + CLOSE,
                "GET / HTTP/1.1\r\nHost:" + CLOSE, "GET / HTTP/1.1\r\nHost: a b" + CLOSE,
                "GET / HTTP/1.1\r\nHost: [::1" + CLOSE, "GET / HTTP/1.1\r\nHost: 127.0.0.1:x" + CLOSE,
                "GET / HTTP/1.1\r\nHost: 127.0.0.1:99999999999" + CLOSE,
                "GET / HTTP/1.1\r\nHost: OWN,evil.example" + CLOSE,
                "GET / HTTP/1.1\r\nHost: OWN@evil.example" + CLOSE, "GET / HTTP/1.0\r\nHost:" + END,
                // Another's name in the request line.
                "GET http://evil.example/ HTTP/1.1\r\nHost: evil.example" + CLOSE,
                "GET http://evil.example/ HTTP/1.1\r\n" + OWN + CLOSE, "GET http:///x HTTP/1.1\r\n" + OWN + CLOSE,
                "GET //evil.example/ HTTP/1.1\r\n" + OWN + CLOSE,
                "GET file:///etc/passwd HTTP/1.1\r\n" + OWN + CLOSE, "CONNECT OWN HTTP/1.1\r\n" + OWN + CLOSE,
                "OPTIONS * HTTP/1.1\r\n" + OWN + CLOSE, "GET * HTTP/1.1\r\n" + OWN + CLOSE,
                // Other versions, and what is none.
                "GET /\r\n", "GET /about?token=TOKEN\r\n", "GET / HTTP/0.9\r\n" + OWN + CLOSE,
                "GET / HTTP/2.0\r\n" + OWN + CLOSE, "GET / HTTP/9.9\r\n" + OWN + CLOSE,
                "GET / HTTQ/1.1\r\n" + OWN + CLOSE,
                "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", "\r\n\r\n", "x\r\n\r\n", "GET\r\n\r\n", "\0\1\2\3\r\n\r\n",
                "\u0016\u0003\u0001\u0002\u0000\u0001\u0000\u0001\u00fc\u0003\u0003\r\n\r\n",
                "{\"do\":\"plug\"}\r\n\r\n",
                "G\u00e4T / HTTP/1.1\r\n" + OWN + CLOSE,
                // Long ones.
                "GET /" + "x".repeat(100_000) + " HTTP/1.1\r\n" + OWN + CLOSE,
                "GET / HTTP/1.1\r\n" + OWN + "\r\nX: " + "x".repeat(100_000) + CLOSE,
                "GET / HTTP/1.1\r\n" + OWN + "\r\nX: y".repeat(50_000) + CLOSE,
                "GET /about?token=" + "0".repeat(100_000)
                        + " HTTP/1.1\r\n" + OWN + CLOSE,
                "X".repeat(100_000) + " / HTTP/1.1\r\n" + OWN + CLOSE,
                // Headers that are none.
                "GET / HTTP/1.1\r\n" + OWN + "\r\nno header" + CLOSE,
                "GET / HTTP/1.1\r\n" + OWN + "\r\n folded" + CLOSE,
                "GET / HTTP/1.1\r\n" + OWN + "\r\n: x" + CLOSE, "GET / HTTP/1.1\r\n" + OWN + "\r\nX\0: y" + CLOSE,
                "GET / HTTP/1.1\r\n" + OWN + "\r\nX: a\0b" + CLOSE, "GET / HTTP/1.1\r\nHost : OWN" + CLOSE,
                // Escapes and characters.
                "GET /%zz HTTP/1.1\r\n" + OWN + CLOSE, "GET /% HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /app/%c0%ae%c0%ae/x.js HTTP/1.1\r\n" + OWN + CLOSE, "GET /app/%ff%fe HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /app/%00 HTTP/1.1\r\n" + OWN + CLOSE, "GET /app/x%0d%0aSet-Cookie:x HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /\u00e4\u00ff HTTP/1.1\r\n" + OWN + CLOSE, "GET /app/..;/x.js HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /app/%u2e2e HTTP/1.1\r\n" + OWN + CLOSE, "GET /lib/%zz/%zz HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /about?token=%zz HTTP/1.1\r\n" + OWN + CLOSE, "GET /about?%=%&&&=& HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /about?token=%ff%fe HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /about?token=\u00ff HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /events?token=%zz HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /events?token=TOKEN&from=%zz HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /events?token=TOKEN&from=%ff HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /events?token=TOKEN HTTP/1.1\r\n" + OWN + "\r\nLast-Event-ID: x" + CLOSE,
                "GET /about?token=x&token=TOKEN HTTP/1.1\r\n" + OWN + CLOSE,
                "GET /about?token=TOKENTOKEN HTTP/1.1\r\n" + OWN + CLOSE,
                // Bodies that are not as the head says.
                post("Content-Length: x", "{}"), post("Content-Length: -1", "{}"),
                post("Content-Length: 99999999999999999999", "{}"),
                post("Content-Length: 2\r\nContent-Length: 3", "{}"),
                post("Content-Length: 50", "{}"), post("Transfer-Encoding: chunked", "zz\r\n{}\r\n0\r\n\r\n"),
                post("Transfer-Encoding: chunked", "5\r\n{}"),
                post("Transfer-Encoding: chunked", "ffffffffffffffff\r\n{}"),
                post("Transfer-Encoding: nonsense", "{}"),
                post("Transfer-Encoding: chunked\r\nContent-Length: 2", "2\r\n{}\r\n0\r\n\r\n"),
                post("Content-Encoding: gzip\r\nContent-Length: 2", "{}"),
                post("Content-Type: multipart/form-data; boundary=x\r\nContent-Length: 4", "--x\r"),
                post("Content-Type: application/x-www-form-urlencoded\r\nContent-Length: 3", "%zz"),
                post("Content-Type: text/plain; charset=nonsense\r\nContent-Length: 2", "{}"),
                post("Content-Type: \u00ff\r\nContent-Length: 2", "{}"),
                post("Expect: nonsense\r\nContent-Length: 2", "{}"),
                "POST /command HTTP/1.1\r\n" + OWN + "\r\nX-Javino-Token: \u00ff\r\nContent-Length: 2" + CLOSE + "{}",
                "POST /command HTTP/1.1\r\n" + OWN + "\r\nX-Javino-Token: TOKEN\r\nX-Javino-Token: x\r\n"
                        + "Content-Length: 2" + CLOSE + "{}",
                "GET /events?token=TOKEN HTTP/1.1\r\n" + OWN + "\r\nUpgrade: websocket\r\nLast-Event-ID: -1" + CLOSE,
                "GET / HTTP/1.1\r\n" + OWN + "\r\nOrigin: \u0001" + CLOSE, "TRACE / HTTP/1.1\r\n" + OWN + CLOSE,
                "BREW /command HTTP/1.1\r\n" + OWN + CLOSE, "get / HTTP/1.1\r\n" + OWN + CLOSE);
    }

    private static String post(String head, String body) {
        return "POST /command HTTP/1.1\r\n" + OWN + "\r\nX-Javino-Token: TOKEN\r\n" + head + CLOSE + body;
    }

    @ParameterizedTest
    @MethodSource("malformed")
    void request_malformed_isRefusedInALine(String request) throws IOException {
        String answer = send(request);

        // One that ends before its body does has nobody to be answered.
        assertTrue(answer.isEmpty() || answer.matches("(?s)HTTP/1\\.[01] (4\\d\\d|505) .*"), answer);
        for (String inside : List.of("Exception", "\tat ", "jetty", "Jetty", "javalin", "java.", "DOCTYPE")) {
            assertFalse(answer.contains(inside), answer);
        }
        assertEquals(List.of(), commands);
    }

    @Test
    void request_goodOfAnyForm_isServed() throws IOException {
        for (String request : List.of("GET / HTTP/1.1\r\n" + OWN + CLOSE, "GET / HTTP/1.0\r\n" + OWN + END,
                "GET http://OWN/ HTTP/1.1\r\n" + OWN + CLOSE, "GET /?x=%20 HTTP/1.1\r\nhost: OWN" + CLOSE,
                "GET  / HTTP/1.1\r\n" + OWN + CLOSE)) {
            assertTrue(send(request).matches("(?s)HTTP/1.1 200 .*"), request);
        }
    }
}
