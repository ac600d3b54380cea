package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import javino.JavinoException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import trace.TraceEvent;

@Tag("newerJava")
@Timeout(120)
class ServerTest extends ServerFixture {

    private static void assertStatus(int status, String answer) {
        assertTrue(answer.startsWith("HTTP/1.1 " + status + " "), answer);
        if (status >= 400) {
            assertEquals(1, body(answer).strip().lines().count(), answer);
        }
    }

    private static String body(String answer) {
        return answer.substring(answer.indexOf("\r\n\r\n") + 4);
    }

    @Test
    void page_anybodyHere_isSent() throws IOException {
        String answer = ask("GET /");

        assertStatus(200, answer);
        assertTrue(body(answer).startsWith("<!doctype html>"), answer);
        assertTrue(answer.contains("Content-Security-Policy: default-src 'self';"), answer);
        assertTrue(answer.contains("X-Content-Type-Options: nosniff"), answer);
        assertTrue(answer.contains("Cache-Control: no-store"), answer);
        assertStatus(200, ask("GET /", "Host: localhost:" + port()));
    }

    @Test
    void address_ofEachServer_hasATokenOfItsOwn() throws JavinoException {
        assertTrue(server.address().matches("http://127\\.0\\.0\\.1:\\d+/\\?token=[0-9a-f]{32}"), server.address());
        try (Server other = Server.start(hub, TraceSourceTest.NOTHING, 0)) {
            assertNotEquals(token(), other.address().replaceFirst(".*token=", ""));
        }
    }

    @Test
    void port_taken_isSaidInOneLine() {
        String message =
                assertThrows(JavinoException.class, () -> Server.start(hub, TraceSourceTest.NOTHING, port()))
                        .getMessage();

        assertTrue(message.contains("at port " + port()), message);
        assertEquals(1, message.lines().count());
    }

    @ParameterizedTest
    @ValueSource(strings = {"evil.example", "127.0.0.1", "127.0.0.1:1", "[::1]:80", "localhost.evil.example:80"})
    void host_another_isRefused(String host) throws IOException {
        assertStatus(403, ask("GET /", "Host: " + host));
        assertStatus(403, ask("GET /about?token=" + token(), "Host: " + host));
    }

    @ParameterizedTest
    @ValueSource(strings = {"http://evil.example", "null", "https://127.0.0.1", "http://127.0.0.1:1", "file://"})
    void origin_another_isRefused(String origin) throws IOException {
        assertStatus(403, ask("GET /about?token=" + token(), "Origin: " + origin));
        assertStatus(403, command("{\"do\":\"plug\",\"board\":\"bus\"}", "Origin: " + origin,
                Server.TOKEN_HEADER + ": " + token()));
        assertEquals(List.of(), commands);
    }

    @Test
    void origin_own_isServed() throws IOException {
        assertStatus(200, ask("GET /about?token=" + token(), "Origin: http://" + host()));
        assertStatus(200, ask("GET /about?token=" + token(), "Origin: http://localhost:" + port()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "0", "00000000000000000000000000000000", "ä"})
    void token_wrong_isRefused(String token) throws IOException {
        assertStatus(403, ask("GET /about?token=" + token));
        assertStatus(403, ask("GET /events?token=" + token));
        assertStatus(403, command("{\"do\":\"plug\",\"board\":\"bus\"}", Server.TOKEN_HEADER + ": " + token));
        assertEquals(List.of(), commands);
    }

    @Test
    void token_missingOrInTheWrongPlace_isRefused() throws IOException {
        assertStatus(403, ask("GET /about"));
        assertStatus(403, ask("GET /events"));
        assertStatus(403, command("{\"do\":\"plug\",\"board\":\"bus\"}"));
        assertStatus(403, ask("POST /command?token=" + token(), "Content-Length: 0"));
    }

    @Test
    void about_sayWhatTheSourceIs() throws IOException {
        assertEquals("{\"source\":\"run\",\"live\":true,\"controls\":[\"reset\",\"plug\"],\"why\":false}",
                body(ask("GET /about?token=" + token())));
    }

    @Test
    void command_known_reachesTheSource() throws IOException {
        String answer = command("{\"do\":\"plug\",\"board\":\"bus\"}", Server.TOKEN_HEADER + ": " + token());

        assertEquals("{\"ok\":true}", body(answer));
        assertEquals("bus", commands.get(0).get("board").getAsString());
    }

    @Test
    void command_refusedByTheSource_saysWhy() throws IOException {
        String answer = command("{\"do\":\"plug\"}", Server.TOKEN_HEADER + ": " + token());

        assertStatus(400, answer);
        assertEquals("{\"error\":\"which board?\"}", body(answer));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "x", "[]", "{", "{\"do\":1}", "{\"do\":\"jam\"}", "{'do':'plug'}", "null",
            "{\"do\":\"plug\",\"board\":\"bus\"} x"})
    void command_bad_isRefusedInOneLine(String body) throws IOException {
        String answer = command(body, Server.TOKEN_HEADER + ": " + token());

        assertStatus(400, answer);
        assertTrue(body(answer).startsWith("{\"error\":\""), answer);
        assertEquals(List.of(), commands);
    }

    /** The body of the answer to a question. */
    private String why(String question) throws IOException {
        return body(post("/why", question.replace('\'', '"'), Server.TOKEN_HEADER + ": " + token()));
    }

    @Test
    void question_isAnsweredByTheLog() throws IOException {
        assertEquals("{\"error\":\"nothing can be asked here: there is no log\"}", why("{'what':'dark'}"));
        for (String line : List.of(
                "'t':1,'event':'agent-plan','agent':'one','place':'a.asl:1','trigger':'+!go','body':''",
                "'t':2.5,'event':'agent-event','agent':'one','number':1,'trigger':'+dark[source(page)]'")) {
            log.add(TraceEvent.parse(0, "{" + line.replace('\'', '"') + "}"));
        }

        String chain = "{\"answer\":[\"    2.5000 s  one believes dark\",\"first cause: dark was given on the page\"]}";
        assertEquals(chain, why("{'what':'dark'}"));
        assertEquals(chain, why("{'line':{'event':'agent-event','agent':'one','number':1.0}}"));
        assertEquals("{\"answer\":[\"first cause: one has opened no port: its board can tell it nothing\"]}",
                why("{'what':'dark','agent':'one','until':2.4}"));
        assertTrue(why("{'what':'dark','agent':'two'}").startsWith("{\"error\":\"the log has no agent two"));
        assertTrue(why("{'line':{'event':'agent-plan'}}").startsWith("{\"error\":\"the log does not have that line"));
        assertTrue(why("{'what':' '}").startsWith("{\"error\":\""));
        assertStatus(403, post("/why", "{}"));
    }

    @Test
    void command_tooLongOrTooDeep_isRefused() throws IOException {
        String longest = "{\"do\":\"plug\",\"board\":\"" + "x".repeat(Server.MOST_COMMAND_BYTES) + "\"}";
        assertTrue(command(longest, Server.TOKEN_HEADER + ": " + token()).contains("has at most 4096 bytes"));
        assertStatus(400, command("[".repeat(Server.MOST_COMMAND_BYTES), Server.TOKEN_HEADER + ": " + token()));
        assertEquals(List.of(), commands);
    }

    @ParameterizedTest
    @ValueSource(strings = {"/lib/lit-html/lit-html.js", "/lib/lit-html/directives/repeat.js",
            "/lib/chart.js/dist/chart.umd.js"})
    void library_anyVersion_isSent(String path) throws IOException {
        String answer = ask("GET " + path);

        assertStatus(200, answer);
        assertTrue(answer.contains("Content-Type: text/javascript;charset=utf-8"), path);
    }

    @ParameterizedTest
    @ValueSource(strings = {"/app/", "/app/nothing.js", "/app/../PageFiles.class", "/app/%2e%2e/PageFiles.class",
            "/app/..%2f..%2fMETA-INF/MANIFEST.MF", "/app//etc/passwd", "/app/%2fetc%2fpasswd",
            "/app/..\\..\\x.js", "/lib/", "/lib/lit-html", "/lib/lit-html/", "/lib/lit-html/../lit-html.js",
            "/lib/../live/app/index.html", "/lib/lit-html/..%2f..%2f..%2f..%2f..%2flive/app/index.html",
            "/lib/nothing/x.js", "/lib/lit-html/package.json", "/META-INF/MANIFEST.MF", "/live/app/index.html"})
    void file_thatIsNoneOfThePage_isNotThere(String path) throws IOException {
        String answer = ask("GET " + path);

        assertTrue(answer.startsWith("HTTP/1.1 404 ") || answer.startsWith("HTTP/1.1 400 "), answer);
        assertFalse(body(answer).contains("DOCTYPE"), answer);
    }

    @ParameterizedTest
    @ValueSource(strings = {"PUT /", "DELETE /command", "OPTIONS /command", "GET /command", "POST /events"})
    void method_another_isRefused(String request) throws IOException {
        assertStatus(404, ask(request, "Content-Length: 0"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"-1", "x", "99999999999999999999", "1e3"})
    void events_fromNoNumber_isRefused(String from) throws IOException {
        assertStatus(400, ask("GET /events?token=" + token() + "&from=" + from));
    }
}
