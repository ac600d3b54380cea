package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.support.ui.Select;

/** The places of things on the page: labels, cards, the camera's frame, plots, and the menu of a vehicle. */
class ViewTest {

    private static final List<Dimension> SIZES =
            List.of(new Dimension(1280, 720), new Dimension(1920, 1080), new Dimension(800, 600));
    private static final int BEHAVIOURS = 9;
    /** The time between two looks at what changes: to draw the page in another size takes much. */
    private static final long EVERY_MILLIS = 500;
    /** Texts that are cut, or that cover another; what is scrolled out of sight is neither. */
    private static final String FAULTS = """
            const faults = [], texts = [];
            const all = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
            for (let text = all.nextNode(); text; text = all.nextNode()) {
              const parent = text.parentElement;
              if (!text.data.trim() || !parent.checkVisibility({ visibilityProperty: true })) continue;
              if (parent.closest('option, .row')) continue;
              const range = document.createRange();
              range.selectNodeContents(text);
              for (const box of range.getClientRects()) {
                let hidden = false, cut = false;
                for (let around = parent; around !== document.body; around = around.parentElement) {
                  const style = getComputedStyle(around), edge = around.getBoundingClientRect();
                  for (const [axis, from, to] of [['X', 'left', 'right'], ['Y', 'top', 'bottom']]) {
                    if (style['overflow' + axis] === 'visible') continue;
                    if (box[from] >= edge[from] - 1.5 && box[to] <= edge[to] + 1.5) continue;
                    const partly = box[to] > edge[from] && box[from] < edge[to];
                    if (style['overflow' + axis] === 'hidden' && partly) cut = true;
                    else hidden = true;
                  }
                }
                if (!hidden && cut) faults.push('cut: ' + text.data);
                if (!hidden) texts.push({ text, box });
              }
            }
            texts.forEach((one, i) => texts.slice(i + 1).filter((other) => other.text !== one.text).forEach((other) => {
              const [a, b] = [one.box, other.box];
              const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
              const tall = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
              if (wide > 1.5 && tall > 3.5) faults.push('one on another: ' + one.text.data + ', ' + other.text.data);
            }));
            return faults;
            """;
    /** The middle of all pixels of the road that have a board's colour. */
    private static final String DRAWN_AT = """
            const road = document.getElementById('road');
            const named = getComputedStyle(document.documentElement).getPropertyValue('--hue-' + arguments[0]);
            const colour = named.match(/[0-9a-f]{2}/g).map((hex) => parseInt(hex, 16));
            const { data, width } = road.getContext('2d').getImageData(0, 0, road.width, road.height);
            const found = [];
            for (let i = 0; i < data.length; i += 4) {
              if (colour.every((part, k) => data[i + k] === part)) found.push(i / 4);
            }
            const mean = (of) => Math.round(found.reduce((sum, i) => sum + of(i), 0) / found.length);
            return found.length === 0 ? [] : [mean((i) => i % width), mean((i) => Math.floor(i / width))];
            """;

    /** How many pixels at the left edge are road. */
    private static final String ROAD = """
            const road = document.getElementById('road');
            const named = getComputedStyle(document.documentElement).getPropertyValue('--road');
            const colour = named.match(/[0-9a-f]{2}/g).map((hex) => parseInt(hex, 16));
            const { data } = road.getContext('2d').getImageData(1, 0, 1, road.height);
            return data.filter((part, i) => i % 4 === 0 && colour.every((c, k) => data[i + k] === c)).length;
            """;

    @TempDir
    private Path folder;

    @Test
    @Tag("verify")
    void highway_atThreeSizes_showsLabelsApartAndCardsWhole() throws Exception {
        try (LiveRun run = LiveRun.highway(folder); Page page = Page.open(run.address())) {
            page.await("section.agent", 5);
            int seen = 0;
            for (int i = 0; seen < BEHAVIOURS || i % SIZES.size() != 0; i++) {
                Dimension size = SIZES.get(i % SIZES.size());
                page.size(size);
                assertLaidOut(page, size);
                seen = page.all(LivePageTest.OBSERVED).size();
                Thread.sleep(EVERY_MILLIS);
            }
            for (Dimension size : SIZES) {
                page.size(size);
                assertLaidOut(page, size);
                assertCardsAreWhole(page);
                assertEquals(0, page.all("#labels .edge").size(), "a resize shows all again");
                page.screenshot("view-" + size.width);
            }
            page.size(SIZES.get(0));
            page.actions().moveToElement(page.await("[data-key='board bus']")).clickAndHold().moveByOffset(1, 1)
                    .release()
                    .perform();
            page.awaitText("#menu", "Bus");
            page.screenshot("menu");
            LivePageTest.slide(page, "sensor-A0", 55);
            page.awaitText("section.agent[data-board='bus'] .belief", "light(55)");
            page.awaitText("#menu", "55");
            page.screenshot("sensor");
            LivePageTest.click(page, "free-A0");
            page.awaitText("section.agent[data-board='bus'] .belief", "light(700)");
            LivePageTest.click(page, "close-menu");
            Object road = page.script(ROAD);
            LivePageTest.choose(page, "board police");
            LivePageTest.place(page, 20, 9);
            LivePageTest.awaitEvent(run, event -> event.is("place", "police")
                    && event.json("position").getAsJsonArray().get(1).getAsDouble() == 9);
            page.awaitFrames();
            assertEquals(road, page.script(ROAD), "there is one road");
            LivePageTest.click(page, "close-menu");
            assertEquals(1, run.events(LivePageTest.command("move")).size(), "a click is no drag");
            page.await("no menu", driver -> !driver.findElement(By.id("menu")).isDisplayed());
            LivePageTest.assertClean(page);
        }
    }

    private static void assertLaidOut(Page page, Dimension size) {
        page.await("a time line of this size", driver -> Boolean.TRUE.equals(page.script(
                "const box = document.getElementById('timeline'), drawn = box.querySelector('svg');"
                        + "return drawn.clientWidth <= Math.max(box.clientWidth, 300)")));
        assertEquals(List.of(), page.script(FAULTS), () -> "at " + size);
        assertEquals(5, page.all("#labels .name, #labels .edge").size(), () -> "at " + size);
        if (size.width < 1000) {
            return;
        }
        assertEquals(List.of(), page.script("""
                return [...document.querySelectorAll('section.agent')].filter((card) => {
                  const { top, bottom, height } = card.getBoundingClientRect();
                  return top < 0 || bottom > innerHeight || height < 100;
                }).map((card) => card.innerText);
                """), () -> "at " + size);
    }

    private static void assertCardsAreWhole(Page page) {
        assertEquals(List.of(), page.script("""
                return [...document.querySelectorAll('section.agent')]
                  .filter((card) => card.scrollHeight > card.clientHeight + 1).map((card) => card.innerText);
                """));
    }

    @Test
    @Tag("verify")
    void camera_keepsItsFrame_andTellsWhoIsOutside() throws Exception {
        Files.writeString(folder.resolve("two.json"), """
                {"boards": [
                  {"name": "house", "firmware": "%1$s", "port": "ports/tty", "position": [60, 0],
                   "watch": [{"pin": 13, "name": "lamp"}],
                   "sensors": [{"type": "digital", "pin": 7, "level": [[0, 1]]}]},
                  {"name": "car", "firmware": "%1$s", "position": [0, 0]}]}
                """.formatted(LiveRun.ROOT.resolve("javino-firmware/build/station/Station.ino.elf")));
        try (LiveRun run = LiveRun.piped(folder, "two.json"); Page page = Page.open(run.address())) {
            page.await("#labels .name", 2);
            assertOwnAgents(page);
            List<?> house = page.await("a house that stands", driver -> standing(page, 0));
            List<?> car = page.await("a car that stands", driver -> standing(page, 1));
            LivePageTest.choose(page, "board car");
            LivePageTest.place(page, -5, 0);
            page.await("a car that has moved", driver -> !drawnAt(page, 1).equals(car));
            assertStands(house, drawnAt(page, 0));
            LivePageTest.place(page, 600, 0);
            WebElement arrow = page.await("#labels .edge");
            assertEquals("→ car", arrow.getText());
            assertEquals(List.of(), page.script(FAULTS));
            page.screenshot("outside");
            assertEquals(List.of(), drawnAt(page, 1));
            assertStands(house, drawnAt(page, 0));

            LivePageTest.click(page, "fit");
            page.await("nobody outside", driver -> page.all("#labels .edge").isEmpty());
            assertNotEquals(List.of(), drawnAt(page, 1));
            assertNotEquals(List.of(), drawnAt(page, 0));

            LivePageTest.place(page, 1200, 0);
            LivePageTest.click(page, "close-menu");
            page.await("#labels .edge").click();
            page.await("the car in the middle", driver -> !drawnAt(page, 1).isEmpty());

            LivePageTest.click(page, "fit");
            page.await("the house", driver -> !drawnAt(page, 0).isEmpty());
            List<?> before = drawnAt(page, 0);
            WebElement road = page.await("#road");
            page.actions().moveToElement(road, 0, 60).clickAndHold().moveByOffset(40, 20).release().perform();
            page.await("a view moved by 40 and 20 pixels",
                    driver -> coordinate(drawnAt(page, 0), 0) == coordinate(before, 0) + 40
                            && coordinate(drawnAt(page, 0), 1) == coordinate(before, 1) + 20);
            List<?> after = drawnAt(page, 0);
            int left = coordinate(after, 0) - road.getSize().width / 2;
            int top = coordinate(after, 1) - road.getSize().height / 2;
            page.actions().moveToElement(road, left, top).click().perform();
            page.awaitText("#menu", "house");
            page.script("arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: -100, cancelable: true, "
                    + "clientX: arguments[0].getBoundingClientRect().left, "
                    + "clientY: arguments[0].getBoundingClientRect().top}))", road);
            page.await("a nearer view", driver -> coordinate(drawnAt(page, 0), 0) > coordinate(after, 0));
            LivePageTest.assertClean(page);
        }
    }

    /** A project of one's own: an agent with a board, one that it makes later, and what the page has them do. */
    private void assertOwnAgents(Page page) throws IOException {
        Files.writeString(folder.resolve("own.mas2j"), "MAS own { agents: owner agentArchClass diffuser.Diffuser; }");
        Files.writeString(folder.resolve("owner.asl"), """
                !start.
                +!start <- .port("ports/tty"); .percepts(open); .setMyRFId("ROMA"); .create_agent(helper, "helper.asl").
                +!greet(X)[source(page)] <- .print("hello ", X).
                +delivered(To, P, C) <- .print("not by this").
                """);
        Files.writeString(folder.resolve("helper.asl"), "ready.");
        LiveRun agents = LiveRun.agents(folder, "own.mas2j");
        try {
            page.awaitText("section.agent[data-agent='helper'] .belief", "ready");
            page.awaitText("section.agent[data-board='house'] .name", "owner");
            page.awaitText("[data-key='board house']", "lamp");
            page.awaitText("#labels", "car");
            page.await("[data-agent='owner'] input[name='goal']").sendKeys("greet(page)", Keys.ENTER);
            page.awaitText("[data-agent='owner'] .said", "hello page");
            page.awaitText("#story", "The agent owner says: “hello page”");
            page.await("[data-board='house'] input[name='content']").sendKeys("dark(3)", Keys.ENTER);
            page.awaitText("#story", "house calls to all in range: “tell;dark(3)”");
            assertAnswers(page);
            LivePageTest.click(page, "card-sensor-house-7-0");
            page.await("#card-sensor-house-7-0[aria-pressed='true']");
            page.screenshot("own");
            assertEquals(List.of(), page.script(FAULTS));
            assertEquals(0L, page.script(ROAD), "no road where there is none");
        } finally {
            agents.close();
        }
        page.await("no helper", driver -> page.all("section.agent[data-agent='helper']").isEmpty());
    }

    /** Why, by a click on a line and by the box, and as far as one can read it. */
    private static void assertAnswers(Page page) {
        page.driver().findElement(By.cssSelector("[data-agent='helper'] .belief .ask")).click();
        page.awaitText("#why li", "helper believes ready");
        page.awaitText("#why .cause", "first cause: ready is a belief of the program");
        ask(page, "owner", "dark(3)");
        page.awaitText("#why .cause", "first cause: nobody has told dark(3)");
        ask(page, "owner", "!greet(_)");
        page.awaitText("#why .cause", "first cause: !greet(page) was given on the page");
        page.screenshot("why");
        page.driver().findElement(By.tagName("body")).sendKeys(Keys.ESCAPE);
        page.await("no answer", driver -> !driver.findElement(By.id("why")).isDisplayed());
        page.await(".row.packet[data-n]");
        // The row is drawn anew with each event.
        page.script("document.querySelector('.row.packet').dispatchEvent(new MouseEvent('click', {bubbles: true}))");
        page.awaitText("#why h3", "Why this packet to ////?");
        page.awaitText("#why .cause", "first cause: the host of house's board sent it");
        LivePageTest.click(page, "follow");
        LivePageTest.click(page, "close-why");
    }

    private static void ask(Page page, String agent, String what) {
        new Select(page.await("#ask select")).selectByValue(agent);
        WebElement box = page.await("#ask input");
        box.clear();
        box.sendKeys(what, Keys.ENTER);
    }

    private static List<?> drawnAt(Page page, int hue) {
        return (List<?>) page.script(DRAWN_AT, hue);
    }

    /** The place where it is drawn, unless that changes with the page's layout. */
    private static List<?> standing(Page page, int hue) {
        List<?> before = drawnAt(page, hue);
        LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(1));
        page.awaitFrames();
        return !before.isEmpty() && before.equals(drawnAt(page, hue)) ? before : null;
    }

    /** At its place, but for the pixel by which its colour at an edge can differ. */
    private static void assertStands(List<?> before, List<?> now) {
        for (int axis : new int[] {0, 1}) {
            assertTrue(Math.abs(coordinate(before, axis) - coordinate(now, axis)) <= 1, () -> before + ", " + now);
        }
    }

    private static int coordinate(List<?> place, int axis) {
        return Math.toIntExact((Long) place.get(axis));
    }

    @Test
    @Tag("verify")
    void value_thatTrembles_looksStill() throws Exception {
        List<String> trace = new ArrayList<>(List.of("{\"t\":0,\"event\":\"scenario\",\"boards\":[{\"name\":\"a\"}]}"));
        for (int t = 1; t <= 30; t++) {
            trace.add(String.format(Locale.ROOT,
                    "{\"t\":%d,\"board\":\"a\",\"event\":\"percepts\",\"percepts\":[\"celsius(20.%d)\",\"light(%d)\"]}",
                    t,
                    t % 2, t % 3 == 0 ? 0 : 1023));
        }
        Files.write(folder.resolve("trace.jsonl"), trace);
        try (LiveRun watch = LiveRun.watch(folder, "--trace", "trace.jsonl"); Page page = Page.open(watch.address())) {
            page.await("the whole trace", driver -> Boolean.TRUE.equals(
                    page.script("return Number(document.getElementById('slider')?.max) >= 30")));
            LivePageTest.slide(page, "slider", 30);
            page.await("a plot of all values", driver -> Boolean.TRUE.equals(page.script(
                    "const c = document.querySelector('canvas.plot');"
                            + "return (c && Chart.getChart(c)?.data.datasets[0].data.length) > 25")));
            page.screenshot("plots");
            page.await("a page that does nothing", driver -> Integer.parseInt(page.attribute("html", "data-fps")) <= 5);
            assertTrue(heightOf(page, "light") > 0.5, () -> "light " + heightOf(page, "light"));
            assertTrue(heightOf(page, "celsius") < 0.2, () -> "celsius " + heightOf(page, "celsius"));
            assertEquals("0 1,023", ticks(page, "light"));
            assertEquals("17 23", ticks(page, "celsius"));
            LivePageTest.assertClean(page);
        }
    }

    /** The part of its plot that a line covers, from its lowest to its highest row. */
    private static double heightOf(Page page, String percept) {
        return ((Number) page.script("""
                const canvas = document.querySelector(`canvas[data-percept='${arguments[0]}']`);
                const { left, top, right, bottom } = Chart.getChart(canvas).chartArea;
                const ratio = canvas.width / canvas.clientWidth;
                const [wide, tall] = [(right - left) * ratio, (bottom - top) * ratio];
                const { data } = canvas.getContext('2d').getImageData(left * ratio, top * ratio, wide, tall);
                const rows = [];
                for (let i = 0; i < data.length; i += 4) {
                  if (data[i + 3] > 200 && data[i] < 60) rows.push(Math.floor(i / 4 / Math.floor(wide)));
                }
                return (Math.max(...rows) - Math.min(...rows)) / tall;
                """, percept)).doubleValue();
    }

    private static String ticks(Page page, String percept) {
        return (String) page.script("return Chart.getChart(document.querySelector("
                + "`canvas[data-percept='${arguments[0]}']`)).scales.y.ticks.map((tick) => tick.label).join(' ')",
                percept);
    }
}
