package live;

import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import io.javalin.Javalin;
import io.javalin.config.JavalinConfig;
import io.javalin.http.Context;
import io.javalin.http.HttpResponseException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javino.JavinoException;
import live.PageFiles.PageFile;
import trace.TraceEvent;
import trace.why.Why;

/**
 * Serves the page, its events and its commands to the browsers of this computer. Attempts of others by one of these
 * browsers are refused: by {@code Host}, {@code Origin} and a token that is drawn anew with each start.
 */
final class Server implements AutoCloseable {

    static final String TOKEN_HEADER = "X-Javino-Token";
    private static final String ADDRESS = "127.0.0.1";
    private static final int TOKEN_BYTES = 16;
    static final int MOST_COMMAND_BYTES = 4096;
    private static final Map<String, String> HEADERS = Map.of(
            "Content-Security-Policy",
            "default-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
            "X-Content-Type-Options", "nosniff", "Referrer-Policy", "no-referrer",
            "Cross-Origin-Resource-Policy", "same-origin", "Cache-Control", "no-store");

    private final Source source;
    private final EventStreams streams;
    private final String token = newToken();
    private final Javalin javalin;

    private Server(Hub hub, Source source) {
        this.source = source;
        streams = new EventStreams(hub, source::watched);
        javalin = Javalin.create(this::configure);
    }

    /**
     * Begins to serve.
     *
     * @param port 0 for one that is free.
     * @throws JavinoException if the port is not free.
     */
    static Server start(Hub hub, Source source, int port) throws JavinoException {
        Server server = new Server(hub, source);
        try {
            server.javalin.start(ADDRESS, port);
        } catch (RuntimeException e) {
            server.close();
            throw new JavinoException("the page cannot be served at port " + port + " of " + ADDRESS
                    + ": is it taken? Choose another by --http-port", e);
        }
        return server;
    }

    private static String newToken() {
        byte[] random = new byte[TOKEN_BYTES];
        new SecureRandom().nextBytes(random);
        return HexFormat.of().formatHex(random);
    }

    /** The address at which a browser finds the page. */
    String address() {
        return "http://" + ADDRESS + ":" + javalin.port() + "/?token=" + token;
    }

    /** The command that brings the page to another computer. */
    String tunnel() {
        return "ssh -L " + javalin.port() + ":" + ADDRESS + ":" + javalin.port() + " " + System.getProperty("user.name")
                + "@" + Browser.host();
    }

    private void configure(JavalinConfig config) {
        config.startup.showJavalinBanner = false;
        config.startup.showOldJavalinVersionWarning = false;
        config.startup.startupWatcherEnabled = false;
        config.routes.before(this::guard);
        config.routes.get("/", request -> send(request, PageFiles.app("index.html")));
        config.routes.get("/app/*", request -> send(request, PageFiles.app(below("/app/", request))));
        config.routes.get("/lib/*", request -> send(request, PageFiles.library(below("/lib/", request))));
        config.routes.get("/about", this::about);
        config.routes.get("/events", this::events);
        config.routes.post("/command", this::command);
        config.routes.post("/why", this::why);
        config.routes.exception(Refusal.class, (e, request) -> request.status(e.status).result(e.getMessage()));
        config.routes.exception(HttpResponseException.class, (e, request) -> request.status(e.getStatus())
                .result("there is no " + request.method() + " of this path"));
    }

    /** A request is refused; the message is one line. */
    private static final class Refusal extends Exception {
        private static final long serialVersionUID = 1L;
        private final int status;

        Refusal(int status, String message) {
            super(message);
            this.status = status;
        }
    }

    /** A page from elsewhere may have made the browser send this, under a name of its own for our address. */
    private void guard(Context request) throws Refusal {
        HEADERS.forEach(request::header);
        List<String> names = List.of(ADDRESS + ":" + javalin.port(), "localhost:" + javalin.port());
        // Asked by each name: of the header that is not there, and of the one that is there twice, none is right.
        String host = request.header("Host");
        if (names.stream().noneMatch(name -> name.equals(host))) {
            throw new Refusal(403, "this page is served to " + names.get(0) + " only");
        }
        String query = request.queryString();
        if (query != null && query.replaceAll("%[0-9A-Fa-f]{2}", "").contains("%")) {
            throw new Refusal(400, "a % in an address has two hexadecimal digits behind it");
        }
        String origin = request.header("Origin");
        if (origin != null && names.stream().noneMatch(name -> origin.equals("http://" + name))) {
            throw new Refusal(403, "this page takes nothing from other pages");
        }
    }

    private void checkToken(String given) throws Refusal {
        byte[] bytes = given == null ? new byte[0] : given.getBytes(StandardCharsets.UTF_8);
        if (!MessageDigest.isEqual(token.getBytes(StandardCharsets.UTF_8), bytes)) {
            throw new Refusal(403, "the token is missing or wrong: open the address that javino watch has printed");
        }
    }

    private static String below(String prefix, Context request) {
        return request.path().substring(prefix.length());
    }

    private static void send(Context request, Optional<PageFile> file) throws Refusal {
        PageFile found = file.orElseThrow(() -> new Refusal(404, "there is no such file"));
        request.header("Content-Type", found.type()).result(found.content());
    }

    private void about(Context request) throws Refusal {
        checkToken(request.queryParam("token"));
        json(request, 200,
                "source", source.kind(), "live", source.isLive(), "controls", source.controls(), "why",
                source.log().isPresent());
    }

    private void events(Context request) throws Refusal, IOException, InterruptedException {
        checkToken(request.queryParam("token"));
        String last = request.header("Last-Event-ID");
        String from = last != null ? last : request.queryParam("from");
        if (from != null && !from.matches("[0-9]{1,18}")) {
            throw new Refusal(400, "from takes the number of an event, 0 for the first");
        }
        if (!streams.serve(request, from == null ? 0 : Long.parseLong(from))) {
            throw new Refusal(503, EventStreams.MOST_PAGES + " pages are open, which is the most: close one");
        }
    }

    private static byte[] body(Context request) throws Refusal {
        try {
            return request.bodyInputStream().readNBytes(MOST_COMMAND_BYTES + 1);
        } catch (IOException | RuntimeException e) {
            // The server fails by either where the body is not what the head says.
            throw new Refusal(400, "the command is not as long as the request says");
        }
    }

    /** Does something with the object that a page has sent. */
    private interface Work {
        Object with(JsonObject body) throws JavinoException, IOException;
    }

    private void answer(Context request, String name, Work work) throws Refusal {
        checkToken(request.header(TOKEN_HEADER));
        byte[] body = body(request);
        try {
            if (body.length > MOST_COMMAND_BYTES) {
                throw new JavinoException("a command has at most " + MOST_COMMAND_BYTES + " bytes");
            }
            json(request, 200, name, work.with(Events.object(new String(body, StandardCharsets.UTF_8))));
        } catch (JavinoException | IOException | IllegalArgumentException e) {
            json(request, 400, "error", e.getMessage());
        }
    }

    private void command(Context request) throws Refusal {
        answer(request, "ok", body -> {
            source.command(known(body));
            return true;
        });
    }

    /** Answers by {@link Why}: {@code line} has the fields of one that is asked of; or {@code what}, {@code agent}. */
    private void why(Context request) throws Refusal {
        answer(request, "answer", body -> {
            List<TraceEvent> events = source.log()
                    .orElseThrow(() -> new JavinoException("nothing can be asked here: there is no log")).events();
            Why why = body.get("until") instanceof JsonPrimitive until && until.isNumber()
                    ? new Why(events, until.getAsDouble()) : new Why(events);
            return body.get("line") instanceof JsonObject line ? why.of(line)
                    : why.answer(Events.text(body, "what"), body.has("agent") ? Events.text(body, "agent") : "");
        });
    }

    private JsonObject known(JsonObject command) throws JavinoException {
        if (source.controls().isEmpty()) {
            throw new JavinoException("nothing can be commanded here");
        }
        if (source.controls().stream().noneMatch(name -> command.has("do") && command.get("do").isJsonPrimitive()
                && command.get("do").getAsString().equals(name))) {
            throw new JavinoException("a command has a \"do\", one of " + String.join(", ", source.controls()));
        }
        return command;
    }

    private static void json(Context request, int status, Object... answer) {
        request.status(status).contentType("application/json").result(Events.json(answer));
    }

    @Override
    public void close() {
        streams.close();
        javalin.stop();
    }
}
