package browser;

import static browser.LivePageTest.OBSERVED;
import static browser.LivePageTest.assertClean;
import static browser.LivePageTest.click;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebDriver;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.support.ui.Select;
import trace.TraceEvent;

/** How a user finds the page, and how it shows why a forgery fails, that time stands still, and what no agent says. */
class ForgeryTest {

    private static final String VERDICT = "#forged [role='status']";
    /** A host gives its board up after 5.2 s (BoardConfig). */
    private static final long LONGER_THAN_PATIENCE_MILLIS = 9000;
    private static final long STANDS_MILLIS = 2000;
    /** Longer than boards take to tell what they did with a packet. */
    private static final long AGAIN_MILLIS = 60_000;
    private static final Predicate<TraceEvent> OFF =
            event -> event.is("said") && event.text("text").endsWith(" is off");
    private static final String IN_SIGHT = """
            const box = arguments[0].getBoundingClientRect();
            return scrollY === 0 && box.top >= 0 && box.bottom <= innerHeight
              && box.left >= 0 && box.right <= innerWidth;
            """;

    private record Forgery(String button, String foretold, String headline, String verdict) {}

    private static final List<Forgery> FORGERIES = List.of(
            new Forgery("shout", "heard as a shout only", "as Police: Bus heard it, as a shout only",
                    "Bus heard it as a shout only: a shout has no tag, so it "
                            + "proves nothing, and the agent is told that anybody can have sent it."),
            new Forgery("replay", "refused: heard before", "You replayed a packet: Bus had it already",
                    "Bus had it already and repeats its answer; its agent hears nothing. Nobody can change the "
                            + "packet's number without the key."),
            new Forgery("flip", "refused: wrong tag", "You changed one bit: Bus refused it, wrong tag.",
                    "Bus refused it: its tag is wrong, because whoever has not the key cannot make the tag."),
            new Forgery("key", "refused: wrong tag", "You made up a key: Bus refused it, wrong tag.",
                    "Bus refused it: its tag is wrong, because whoever has not the key cannot make the tag."));

    /** Words that say nothing to who looks at the page for the first time. */
    private static final Pattern ABOVE = Pattern.compile("(?i)injector|start symbol|right CRC");

    /** Tests share one highway, and leave it at the speed of life. */
    @TempDir
    private static Path highway;
    private static LiveRun run;
    @TempDir
    private Path folder;

    @BeforeAll
    static void start() throws Exception {
        run = LiveRun.highway(highway).awaitGoingOn();
    }

    @AfterAll
    static void end() {
        run.close();
    }

    @Test
    @Tag("verify")
    void highway_withoutAScreen_tellsItsPageAloneBehindTheStartAndBehindTheEnd() throws Exception {
        String address = run.address();
        List<String> lines = run.said().lines().toList();
        List<Integer> places = places(address);
        String port = address.replaceAll(".*:(\\d+)/.*", "$1");

        assertTrue(address.matches("http://127\\.0\\.0\\.1:\\d+/\\?token=[0-9a-f]{32}"), address);
        assertEquals(2, lines.stream().filter(line -> line.contains("token=")).count(), run::said);
        for (int place : places) {
            assertTrue(lines.get(place - 1).contains("ssh -L " + port + ":127.0.0.1:" + port + " "), run::said);
        }
        assertTrue(lines.get(places.get(0) - 2).startsWith("five agents"), run::said);
        assertTrue(lines.get(places.get(0) + 1).matches(" *[0-9.]+ s .*"), run::said);
        assertTrue(lines.get(places.get(1) - 2).startsWith("the run goes on"), run::said);
    }

    private static List<Integer> places(String address) {
        List<String> lines = run.said().lines().toList();
        return IntStream.range(0, lines.size()).filter(i -> lines.get(i).equals(address)).boxed().toList();
    }

    @Test
    @Tag("verify")
    void forgery_hasTheEndThatWasForetold_andItsAddresseeSaysWhy() throws Exception {
        try (Page page = Page.open(run.address())) {
            page.driver().executeCdpCommand("Emulation.setDeviceMetricsOverride",
                    Map.of("width", 1280, "height", 720, "deviceScaleFactor", 1, "mobile", false));
            page.await(OBSERVED, 9);
            int sent = run.events(is("rf-tx", "injector")).size();
            for (Forgery forgery : FORGERIES) {
                String button = "#forge-" + forgery.button();
                assertEquals(true, page.script(IN_SIGHT, page.await(button + "-end")), button);
                assertEquals(forgery.foretold(), page.await(button + "-end").getText());
                // A late host tells that it took it after its board's counters have told of another packet.
                sent += until(page, forgery.verdict(), () -> click(page, "forge-" + forgery.button()));
                assertEquals(true, page.script(IN_SIGHT, page.await("#forged")));
                assertEquals(true, page.script("return document.getElementById('scene').getBoundingClientRect().bottom"
                        + " <= document.getElementById('forged').getBoundingClientRect().top"), "it covers the road");
                page.awaitText("#story li", forgery.headline());
                assertFalse(ABOVE.matcher(page.await("body").getText()).find());
                assertEquals(sent, run.events(is("rf-tx", "injector")).size());
                page.screenshot("forge-" + forgery.button());
            }
            assertNull(page.await("#forged details").getDomAttribute("open"));
            press(page, "summary");
            page.awaitText("#forged li", "Hospital ignored it: it is for another device or group");

            String last = lastToTheBus();
            String key = keyOf("ROMA SUPO");
            until(page, "Bus took it: its tag is right.", () -> assertEquals("", page.script(GENUINE, last, key)));
            press(page, "[aria-label='close']");
            page.await("nothing", driver -> !page.await("#forged").isDisplayed());
            page.awaitText("section.agent[data-board='bus'] .refused", "had already");
            LivePageTest.slide(page, "range", 95);
            page.awaitText("#story", "Range is now 95 m.");
            LivePageTest.slide(page, "range", 100);
            page.awaitText("#story", "Range is now 100 m.");
            List<String> story = page.all("#story li").stream().map(WebElement::getText).toList();
            assertEquals(List.copyOf(new LinkedHashSet<>(story)), story);
            click(page, "forge-key");
            page.await("what came of it", driver -> page.await("#forged").isDisplayed());
            page.driver().findElement(By.tagName("body")).sendKeys(Keys.ESCAPE);
            page.await("nothing", driver -> !page.await("#forged").isDisplayed());
            assertClean(page);
        }
    }

    @Test
    @Tag("verify")
    void injector_isRefused_andItsTextIsNeverMarkup() throws Exception {
        try (Page page = Page.open(run.address())) {
            page.await(OBSERVED, 9);
            page.size(new Dimension(1280, 720));
            page.driver().findElement(By.id("tab-injector")).click();
            page.await(".injector");
            for (WebElement input : page.all(".injector input, .injector select, .injector button")) {
                assertEquals(true, page.script(IN_SIGHT, input), input.toString());
            }
            WebElement term = page.await("#shout input[name='term']");
            term.clear();
            term.sendKeys("p(\"<script>document.title=7</script>\")");
            click(page, "shout-send");
            page.awaitText("#injector-result", "<script>");
            page.screenshot("shout");

            Select recorded = new Select(page.await("#recorded"));
            recorded.getOptions().stream().filter(option -> option.getText().contains("SUPP")
                    && option.getText().contains("sealed")).findFirst().orElseThrow().click();
            clickUntil(page, "send-flipped", "radioBadTag");
            page.screenshot("forged");
            page.await("replay", driver -> page.driver().findElement(By.id("replay")).isEnabled());
            clickUntil(page, "replay", "radioRepeats");
            page.screenshot("replayed");

            assertFalse("7".equals(page.driver().getTitle()));
            assertTrue(page.all("body script").isEmpty());
            LivePageTest.awaitEvent(run, is("rf-tx", "injector"));
            assertClean(page);
        }
    }

    /** The packet may meet another one on the air. */
    private static void clickUntil(Page page, String id, String result) {
        page.repeat(result, AGAIN_MILLIS / 4, () -> {
            page.await(id + " that can be pressed", driver -> driver.findElement(By.id(id)).isEnabled());
            click(page, id);
        }, () -> page.driver().findElement(By.id("injector-result")).getText().contains(result));
    }

    /** Clicks without a pointer: what is said of a packet moves as more is known of it. */
    private static void press(Page page, String css) {
        page.script("arguments[0].click()", page.await("#forged " + css));
    }

    /** Forges until another packet has that verdict, and tells how often: it may meet another one on the air. */
    private static int until(Page page, String verdict, Runnable forgery) {
        List<String> before = packets(page);
        return page.repeat(verdict, AGAIN_MILLIS, forgery,
                () -> !packets(page).equals(before) && page.await(VERDICT).getText().contains(verdict));
    }

    /** The number of the packet that is spoken of. */
    private static List<String> packets(Page page) {
        return page.all("#forged p").stream().map(said -> said.getDomAttribute("data-n")).toList();
    }

    /** Sends what the police could send next. */
    private static final String GENUINE = """
            const [last, key] = arguments;
            return Promise.all([import('/app/seal.js'), import('/app/packet.js'), import('/app/source.js')])
              .then(async ([{ seal }, { bytesOf }, { command }]) => {
                const nonce = bytesOf(last).slice(10, 16);
                nonce[5] += 99;
                const content = new TextEncoder().encode('tell;helpComing');
                const next = await seal(bytesOf(key), 'ROMA', 'SUPO', nonce, content);
                return command({ do: 'send', position: [0, 9], payload: next });
              });
            """;

    private static String lastToTheBus() throws Exception {
        List<TraceEvent> all = run.events(is("rf-tx", "police")
                .and(event -> event.textOrEmpty("kind").equals("unicast") && event.text("destination").equals("ROMA")));
        return all.get(all.size() - 1).text("payload");
    }

    private static String keyOf(String pair) throws Exception {
        return Files.readAllLines(highway.resolve("build/keyring")).stream()
                .filter(line -> line.startsWith(pair + " = "))
                .findFirst().orElseThrow().substring(pair.length() + 3);
    }

    private static Predicate<TraceEvent> is(String event, String board) {
        return seen -> seen.is(event) && seen.board().equals(board);
    }

    @Test
    @Tag("verify")
    void pause_isOne_andCostsNoAgentItsBoard() throws Exception {
        try (Page page = Page.open(run.address())) {
            page.await(OBSERVED, 9);
            page.driver().findElement(By.tagName("body")).sendKeys(Keys.SPACE);
            page.awaitText("#source", "paused");
            page.awaitText("#story", "The run is paused.");
            // A browser that has little time still lets its clock go on to the moment of the pause.
            double time = page.await("a clock that stands", driver -> standing(page));
            List<TraceEvent> off = run.events(OFF);
            Thread.sleep(LONGER_THAN_PATIENCE_MILLIS);
            assertEquals(time, seconds(page.driver()));
            assertFalse(page.await("#forge-key").isEnabled());
            assertEquals(1, page.all("button[aria-label='play']").size() + page.all("button[id*='pause']").size());

            click(page, "back");
            click(page, "play");
            page.await("it is again where the run is", driver -> seconds(driver) >= time
                    && page.await("#follow").getDomAttribute("aria-pressed").equals("true"));
            click(page, "play");
            page.awaitText("#source", "live");
            LivePageTest.slide(page, "light", 100);
            page.awaitText("section.agent[data-board='bus'] .belief", "light(100)");
            page.await("five agents at their boards",
                    driver -> page.all(".state").stream().allMatch(each -> each.getText().equals("agent connected")));
            assertEquals(off, run.events(OFF));
            assertClean(page);
        }
    }

    /** The clock runs ahead of a run that is slower than told, or whose events come late. */
    private static final String AHEAD = """
            return import('/app/clock.js').then(({ Clock }) => {
              const clock = new Clock(true);
              const model = { end: 10, head: { speed: 1 } };
              for (let now = 0; now <= 3000; now += 100) clock.tick(now, model, false);
              const ahead = clock.t;
              Object.assign(model, { end: 11, head: { speed: 0 } });
              clock.tick(3100, model, false);
              return ahead > 11 && clock.t;
            });
            """;

    @Test
    @Tag("verify")
    void clock_thatRanAhead_standsAtThePause() throws Exception {
        Files.writeString(folder.resolve("trace.jsonl"), "{\"t\":0,\"event\":\"scenario\",\"seed\":1,\"boards\":[]}\n");
        try (LiveRun watch = LiveRun.watch(folder, "--trace", "trace.jsonl"); Page page = Page.open(watch.address())) {
            assertEquals(11, ((Number) page.script(AHEAD)).doubleValue());
        }
    }

    private static double seconds(WebDriver driver) {
        return Double.parseDouble(driver.findElement(By.cssSelector("#clock")).getText().replace(" s", ""));
    }

    /** The time of a clock that is the same after a while. */
    private static Double standing(Page page) {
        double before = seconds(page.driver());
        LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(STANDS_MILLIS));
        page.awaitFrames();
        return seconds(page.driver()) == before ? before : null;
    }

    @Test
    @Tag("verify")
    void speed_isThatOfTheRun_whileThePageFollowsIt() throws Exception {
        try (Page page = Page.open(run.address())) {
            page.await(OBSERVED, 9);
            // The page tells the last three things: in a slow run they stand long enough to be read.
            new Select(page.await("#rate")).selectByValue("0.1");
            page.awaitText("#story", "The run goes at 0.1 times the speed of life.");
            click(page, "play");
            page.awaitText("#source", "paused");
            assertEquals("0.1", page.await("#rate").getDomProperty("value"));
            click(page, "play");
            page.awaitText("#story", "The run goes at 0.1 times the speed of life.");
            page.awaitText("#source", "live");
            List<TraceEvent> speeds = run.events(LivePageTest.command("speed"));
            double resumed = speeds.get(speeds.size() - 1).seconds();
            new Select(page.await("#rate")).selectByValue("1");
            LivePageTest.awaitEvent(run, LivePageTest.command("speed")
                    .and(event -> event.real("value") == 1 && event.seconds() >= resumed));
            assertClean(page);
        }
    }

    @Test
    @Tag("verify")
    void printsAndWarnings_areShown_butNotAsWhatTheAgentSays() throws Exception {
        Files.writeString(folder.resolve("trace.jsonl"), """
                {"t":0,"event":"scenario","seed":1,"boards":[{"name":"a"}]}
                {"t":0,"event":"about","aside":["I am an agent"]}
                {"t":1,"event":"note","text":"5 keys written"}
                {"t":1000,"board":"a","event":"said","text":"hello"}
                {"t":1000,"board":"a","event":"said","text":"I am an agent"}
                {"t":1000,"board":"a","event":"port","state":"closed"}
                {"t":1000,"board":"a","event":"beliefs","add":["openness(totallyClosed)[source(percept)]"]}
                {"t":1000,"board":"a","event":"printed","text":"first\\r\\nt = 20.99\\r\\n"}
                {"t":1000,"board":"a","event":"warned","text":"the sketch on a is slow, loop(): up to 94 ms <b>"}
                {"t":1000,"board":"a","event":"uart","line":"from its other line"}
                """);
        try (LiveRun watch = LiveRun.watch(folder, "--trace", "trace.jsonl"); Page page = Page.open(watch.address())) {
            page.awaitText("section.agent .said", "hello");
            assertEquals(2, page.all(".said li").size());
            String card = page.await("section.agent").getText();
            assertFalse(card.contains("cut off") || card.contains("no agent connected"), card);
            assertFalse(page.await("#story").getText().contains("I am an agent"));
            page.awaitText("section.agent .printed summary", "from its other line");
            click(page, "cards .printed summary");
            page.awaitText("section.agent .printed", "t = 20.99");
            page.awaitText("section.agent .warned", "1 warning");
            assertFalse(page.await("section.agent").getText().contains("slow"));
            click(page, "cards .warned summary");
            page.awaitText("section.agent .warned", "up to 94 ms <b>");
            assertTrue(page.await("#story").getText().contains("hello"));
            assertClean(page);
        }
    }

    /** Each is a sentence about its addressee, by what the trace tells. */
    @Test
    @Tag("verify")
    void forgery_thatIsLost_isSaidToBeLost() throws Exception {
        String sent = """
                {"t":%1$d.3,"board":"injector","event":"rf-tx","payload":"524f4d415355504f446f%2$s",\
                "destination":"ROMA","origin":"SUPO","kind":"unicast","sealed":true,"start":%1$d,"end":%1$d.3}
                """;
        String rest = "00".repeat(29);
        Files.writeString(folder.resolve("trace.jsonl"), """
                {"t":0,"event":"scenario","seed":1,"boards":[{"name":"a"},{"name":"b"}]}
                {"t":0,"event":"device","board":"a","address":"ROMA","title":"Bus"}
                """ + sent.formatted(1, rest) + "{\"t\":3,\"event\":\"note\",\"text\":\"\"}\n"
                + sent.formatted(4, rest) + """
                {"t":4.3,"board":"a","event":"rf-damaged","from":"injector","why":"wrong CRC","start":4,"end":4.3}
                """);
        try (LiveRun watch = LiveRun.watch(folder, "--trace", "trace.jsonl"); Page page = Page.open(watch.address())) {
            page.awaitText(VERDICT, "Bus did not hear it undamaged: wrong CRC.");
            page.script("const slider = document.getElementById('slider'); slider.value = 3; "
                    + "slider.dispatchEvent(new Event('input', {bubbles: true}))");
            page.awaitText(VERDICT, "Bus did not hear it: move the “?” nearer.");
            page.await(".row .arrow.unheard");
            assertEquals(0, page.all(".row path.tip").size(), "an arrow to one that has not heard it");
            assertClean(page);
        }
    }
}
