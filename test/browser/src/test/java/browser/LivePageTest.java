package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.support.ui.Select;
import trace.TraceEvent;

/** The highway as its user sees it, and disturbs it, in a real browser. */
class LivePageTest {

    static final String OBSERVED = "li.behaviour[data-observed='true']";
    private static final long PATIENCE_MILLIS = 60_000;

    @TempDir
    private Path folder;

    @Test
    @Tag("verify")
    void highway_isSeenToItsEnd_andPlayedBackFromItsTrace() throws Exception {
        try (LiveRun run = LiveRun.highway(folder); Page page = Page.open(run.address())) {
            page.await("section.agent", 5);
            page.screenshot("beginning");
            page.await(OBSERVED, 1);
            page.reload();
            page.await(OBSERVED, 9);
            page.awaitText("section.agent[data-board='bus'] .said", "Help is coming, says SUPO");
            page.awaitText("section.agent[data-board='bus'] .belief", "accident");
            page.await("section.agent[data-board='bus'] .lamp[data-pin='9'][data-on='1']");
            page.screenshot("highway");
            double told = clock(page);
            click(page, "again");
            page.await("a story that is told slowly", driver -> clock(page) < told
                    && page.await("#rate").getDomProperty("value").equals("0.3"));
            click(page, "follow");
            assertAnswers(page);
            try (Page phone = Page.onPhone(run.address())) {
                phone.await(OBSERVED, 9);
                phone.screenshot("phone");
            }
            page.driver().findElement(By.id("tab-air")).click();
            page.await("tr.packet", 8);
            page.screenshot("sniffer");
            assertClean(page);
            int status = run.end();
            assertTrue(run.said().contains("model: trace accepted"), run::said);
            assertEquals(0, status, run::said);
        }
        try (LiveRun watch = LiveRun.watch(folder, "--trace", "build/run.jsonl");
                Page page = Page.open(watch.address())) {
            page.await("section.agent", 5);
            WebElement slider = page.await("#slider");
            page.driver().findElement(By.tagName("body")).sendKeys(Keys.SPACE);
            page.await("the end", driver -> { // of what has been read of the trace
                page.script("arguments[0].value = arguments[0].max; "
                        + "arguments[0].dispatchEvent(new Event('input', {bubbles: true}))", slider);
                return page.all(OBSERVED).size() >= 9 && !page.all("#verdict").isEmpty();
            });
            page.awaitText("#verdict", "model: trace accepted");
            answer(page, "section.agent[data-board='bus'] .belief .ask", "helpComing");
            page.awaitText("#why li", "police sends tell;helpComing");
            page.script("arguments[0].value = 0; "
                    + "arguments[0].dispatchEvent(new Event('input', {bubbles: true}))", slider);
            page.await("no behaviour", driver -> page.all(OBSERVED).isEmpty());
            page.driver().findElement(By.id("back")).click();
            assertTrue(page.all("#interfere button").isEmpty());
            page.screenshot("trace");
            page.driver().findElement(By.id("file")).sendKeys(folder.resolve("build/run.jsonl").toString());
            page.awaitText("#asking", "javino why FILE");
            assertTrue(page.all(".ask, #ask").isEmpty(), "a file that the server does not have");
            assertClean(page);
        }
    }

    @Test
    @Tag("verify")
    void highway_endedBeforeItsEnd_isNoFailure() throws Exception {
        try (LiveRun run = LiveRun.highway(folder, "--live="); Page page = Page.open(run.address())) {
            awaitEvent(run, command("speed").and(event -> event.real("value") == 0.3));
            page.await("section.agent[data-board='bus']:not([data-openness=''])");
            double begins = run.events(event -> event.is("story") && event.has("begun")).get(0).seconds();
            assertTrue(run.events(is("said", "police")).get(0).seconds() >= begins, "it waits");
            // On a busy machine the page may be there too late for it.
            assertTrue(run.events(command("speed")).get(0).seconds() <= begins
                    || run.said().contains("nobody looks at the page yet"), run::said);
            assertEquals(0, run.end(), run::said);
        }
    }

    @Test
    @Tag("soak")
    void interference_isSeenInAgentAndTrace() throws Exception {
        try (LiveRun run = LiveRun.highway(folder); Page page = Page.open(run.address())) {
            page.await(OBSERVED, 9);

            choose(page, "board police");
            click(page, "unplug");
            page.awaitText("section.agent[data-board='police'] .said", "is off");
            page.screenshot("unplugged");
            click(page, "plug");
            page.awaitText("section.agent[data-board='police'] .said", "is on");
            awaitEvent(run, is("port", "police").and(with("state", "plugged")));

            choose(page, "board hospital");
            click(page, "reset");
            awaitEvent(run, is("reset", "hospital").and(with("why", "fault")));
            page.awaitText("section.agent[data-board='hospital'] .said", "is off");
            click(page, "power-cut");
            awaitEvent(run, is("fault", "hospital").and(with("do", "power-cut")));

            choose(page, "board ambulance");
            place(page, 500, 300);
            awaitEvent(run, is("place", "ambulance")
                    .and(event -> event.json("position").getAsJsonArray().get(0).getAsDouble() == 500));
            click(page, "jam-chosen");
            awaitEvent(run, event -> event.is("fault")
                    && event.text("do").equals("jam"));

            slide(page, "light", 100);
            page.awaitText("section.agent[data-board='bus'] .belief", "light(100)");
            slide(page, "errors", 20);
            awaitEvent(run, command("radio").and(event -> event.real("bitErrorRate") == 0.02));

            choose(page, "obstacle rock");
            place(page, 40, 40);
            awaitEvent(run, command("obstacle"));
            click(page, "remove");
            awaitEvent(run, command("obstacle").and(event -> event.has("remove")));

            click(page, "play");
            page.awaitText("#source", "paused");
            click(page, "play");
            page.awaitText("#source", "live");
            page.screenshot("interfered");
            assertClean(page);
        }
    }

    @Test
    @Tag("soak")
    void vehicle_isDraggedByMouseAndKeys_andAnObstaclePut() throws Exception {
        try (LiveRun run = LiveRun.highway(folder); Page page = Page.open(run.address())) {
            page.await(OBSERVED, 9);
            WebElement road = page.await("#road");
            page.actions().moveToElement(page.await("[data-key='board police']")).clickAndHold().moveByOffset(20, -30)
                    .moveByOffset(20, -30).release().perform();
            awaitEvent(run, command("move").and(with("board", "police")).and(event -> y(event) > 1));

            choose(page, "board hospital");
            road.sendKeys(Keys.ARROW_UP);
            awaitEvent(run, command("move").and(with("board", "hospital")).and(event -> y(event) == 41));

            click(page, "add-obstacle");
            page.actions().moveToElement(road, 200, 0).click().perform();
            awaitEvent(run, command("obstacle"));
            page.screenshot("dragged");
            assertClean(page);
        }
    }

    private static double y(TraceEvent event) {
        return event.json("position").getAsJsonArray().get(1).getAsDouble();
    }

    /** Boards have a packet before its trailer has ended, and the trace tells so. */
    @Test
    @Tag("verify")
    void packetWithATrailer_isHeardAndHandedOverByItsBoards() throws Exception {
        String packet =
                "\"payload\":\"535550505355504f4d49000001000000%s\",\"destination\":\"SUPP\",".formatted("00".repeat(8))
                        + "\"origin\":\"SUPO\",\"kind\":\"unicast\",\"sealed\":true,";
        Files.writeString(folder.resolve("trace.jsonl"), """
                {"t":0,"event":"scenario","seed":1,"boards":[{"name":"a"},{"name":"b"},{"name":"c"}]}
                {"t":1.2001,"board":"b","event":"rf-rx","from":"a",%1$s"bits":372,"start":1.0001,"end":1.2001}
                {"t":1.204,"board":"c","event":"rf-damaged","from":"a","why":"wrong CRC","start":1,"end":1.2}
                {"t":1.22,"board":"b","event":"host-handed","destination":"SUPP","origin":"SUPO","id":"010000"}
                {"t":1.278,"board":"a","event":"rf-tx",%1$s"trailer":"parity","bits":528,"start":1,"end":1.278}
                {"t":2,"board":"b","event":"rf-rx",%1$s"bits":372,"start":1.8,"end":2}
                """.formatted(packet));
        try (LiveRun watch = LiveRun.watch(folder, "--trace", "trace.jsonl"); Page page = Page.open(watch.address())) {
            click(page, "tab-air");
            page.awaitText("tr.packet", "sealed, with parity");
            assertEquals("1.2001 b , 1.204 c wrong CRC; 1.22 b", page.script("""
                    const text = arguments[0];
                    return import('/app/model.js').then(({ Model }) => {
                      const model = new Model();
                      for (const line of text.trim().split('\\n')) model.add(JSON.parse(line));
                      const [p] = model.packets;
                      return p.heard.map((h) => [h.t, h.board, h.why].join(' ')).join(', ')
                        + '; ' + p.handed.map((h) => [h.t, h.board].join(' ')).join(', ');
                    });
                    """, Files.readString(folder.resolve("trace.jsonl"))));
            assertClean(page);
        }
    }

    @Test
    @Tag("verify")
    void beliefThatIsSealed_staysSoWhenItIsShoutedToo() throws Exception {
        Files.writeString(folder.resolve("trace.jsonl"), """
                {"t":0,"event":"scenario","seed":1,"boards":[{"name":"a"}]}
                {"t":1,"board":"a","event":"port","state":"open"}
                {"t":1,"board":"a","event":"beliefs","add":["openness(totallyClosed)[source(percept)]",\
                "port(x,on)[source(percept)]",\
                "help[cast(broadcast,\\"ROMA\\"),cast(unicast,\\"ROMA\\"),source(\\"ROMA\\")]"]}
                """);
        try (LiveRun watch = LiveRun.watch(folder, "--trace", "trace.jsonl"); Page page = Page.open(watch.address())) {
            page.awaitText("section.agent .belief", "from ROMA, sealed; also shouted by ROMA, perhaps forged");
            String card = page.await("section.agent").getText();
            assertTrue(card.contains("agent connected") && !card.contains("cut off"), card);
            assertFalse(card.contains("port(x,on)"), card);
            assertTrue(card.contains("1 about its board"), card);
            assertClean(page);
        }
    }

    @Test
    @Tag("verify")
    void board_isWatchedWithoutAnyAgent() throws Exception {
        Files.writeString(folder.resolve("lamp.json"), """
                {"boards": [{"name": "car", "firmware": "%s/javino-firmware/build/vehicle/Vehicle.ino.elf",
                 "port": "ports/car", "sensors": [{"type": "ldr", "pin": "A0", "light": [[0, 500], [60, 800]]}]}]}
                """.formatted(LiveRun.ROOT));
        Process emulator = new ProcessBuilder(LiveRun.ROOT.resolve("emulator/build/javino-emulator").toString(),
                "lamp.json").directory(folder.toFile()).inheritIO().start();
        while (emulator.isAlive() && !Files.exists(folder.resolve("ports/car"))) {
            Thread.sleep(20);
        }
        try (LiveRun watch = LiveRun.watch(folder, "--port", "ports/car"); Page page = Page.open(watch.address())) {
            page.awaitText("#cards", "drive");
            page.awaitText("#cards", "light");
            page.all("#cards button").stream().filter(button -> button.getText().contains("drive")).findFirst()
                    .orElseThrow().click();
            page.awaitText("#cards", "moving");
            page.screenshot("board");
            assertClean(page);
        } finally {
            emulator.destroy();
            emulator.waitFor();
        }
    }

    /** From what the bus believes back to its own sensor, through all five agents; and its board's boxes. */
    private static void assertAnswers(Page page) {
        answer(page, "section.agent[data-board='bus'] .belief .ask", "helpComing");
        List<String> links = page.all("#why li").stream().map(WebElement::getText).toList();
        int at = 0;
        for (String link : List.of("bus believes helpComing", "the gate passed tell;helpComing from SUPO", "packet ",
                "police sends tell;helpComing", "support sends tell;helpComing",
                "hospital sends tell;ambulanceIsComing",
                "ambulance chose the plan (ambulance.asl:12) for +someoneNeedAmbulance", "packet 1 of bus, not sealed",
                "bus sends tell;help", "bus's board tells proximity(",
                "first cause: bus's board told it, by its sensors")) {
            while (at < links.size() && !links.get(at).contains(link)) {
                at++;
            }
            assertTrue(at < links.size(), () -> link + " is not in its place among " + links);
        }
        // docs/live.png: the answer, and the page at the time of one of its links.
        page.size(new Dimension(1280, 720));
        page.script("[...document.querySelectorAll('#why li')].find((each) => each.innerText.includes('packet '))"
                + ".querySelector('button').click()");
        page.awaitText("#labels", "to Bus");
        page.awaitText("#story", "Police sends to Bus alone.");
        page.screenshot("live");
        click(page, "follow");
        answer(page, "section.agent[data-board='bus'] .lamp .ask", "buzzer");
        page.awaitText("#why li", "because of accidentAlert, within which the pin changed");
        page.screenshot("why-highway");
        assertEquals(5, page.all("form.goal").size());
        assertEquals(5, page.all("form.say").size());
        page.script("document.querySelector(\"[data-board='bus'] .do summary\").click()");
        page.await("[data-board='bus'] [data-action='stop']").click();
        page.awaitText("section.agent[data-board='bus'] .acted", "stop ✓ done");
        answer(page, "section.agent[data-board='bus'] .acted .ask", "stop");
        page.awaitText("#why .cause", "first cause: bus did so outside any plan");
        page.driver().findElement(By.tagName("body")).sendKeys(Keys.ESCAPE);
        page.await("no answer", driver -> !driver.findElement(By.id("why")).isDisplayed());
    }

    /** Clicks on the line with that text. */
    private static void answer(Page page, String css, String text) {
        page.await("a line to be asked: " + text, driver -> Boolean.TRUE.equals(page.script(
                "const all = [...document.querySelectorAll(arguments[0])];"
                        + "const one = all.find((each) => each.innerText.includes(arguments[1]));"
                        + "one?.click(); return one !== undefined;",
                css, text)));
        page.awaitText("#why h3", text);
        page.await("#why .cause");
    }

    private static double clock(Page page) {
        return Double.parseDouble(page.attribute("#clock", "data-t"));
    }

    static void click(Page page, String id) {
        page.await("#" + id).click();
    }

    static void choose(Page page, String value) {
        new Select(page.await("#chosen")).selectByValue(value);
    }

    static void place(Page page, int x, int y) {
        for (String id : List.of("x", "y")) {
            WebElement field = page.await("#" + id);
            field.clear();
            field.sendKeys(Integer.toString(id.equals("x") ? x : y));
        }
        click(page, "move");
    }

    static void slide(Page page, String id, int value) {
        page.script("arguments[0].value = arguments[1]; "
                + "arguments[0].dispatchEvent(new Event('input', {bubbles: true}))", page.await("#" + id), value);
    }

    private static Predicate<TraceEvent> is(String event, String board) {
        return with("event", event).and(with("board", board));
    }

    static Predicate<TraceEvent> command(String name) {
        return with("event", "command").and(with("do", name));
    }

    private static Predicate<TraceEvent> with(String key, String value) {
        return event -> event.has(key) && event.json(key).isJsonPrimitive()
                && event.text(key).equals(value);
    }

    static void awaitEvent(LiveRun run, Predicate<TraceEvent> wanted) throws IOException, InterruptedException {
        long end = System.currentTimeMillis() + PATIENCE_MILLIS;
        while (run.events(wanted).isEmpty()) {
            assertTrue(System.currentTimeMillis() < end, () -> "no such event; the run said:\n" + run.said());
            Thread.sleep(100);
        }
    }

    /** No script has failed, and the page's own policy had nothing to keep away. */
    static void assertClean(Page page) {
        assertEquals(List.of(), page.log().stream().filter(line -> line.contains("SEVERE")).toList());
    }
}
