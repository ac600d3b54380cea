package browser;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.JavascriptExecutor;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.StaleElementReferenceException;
import org.openqa.selenium.TimeoutException;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.interactions.Actions;
import org.openqa.selenium.support.ui.ExpectedCondition;
import org.openqa.selenium.support.ui.WebDriverWait;

/** A page in Debian's Chromium, which speaks to this computer only. */
final class Page implements AutoCloseable {

    /** Long enough for a machine that has much else to do. */
    private static final Duration PATIENCE = Duration.ofSeconds(300);
    private static final Path SCREENSHOTS = Path.of(System.getProperty("javino.screenshots"));

    /** It would complain that Debian's Chromium is newer than what it knows of a protocol that we do not use. */
    private static final Logger SELENIUM = Logger.getLogger("org.openqa.selenium");

    static {
        SELENIUM.setLevel(Level.SEVERE);
    }

    private final ChromeDriver driver;

    private Page(String address, int width, int height, boolean dark) {
        ChromeOptions options = new ChromeOptions();
        options.setBinary("/usr/bin/chromium");
        options.addArguments("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--no-first-run",
                "--disable-background-networking", "--disable-component-update", "--disable-sync",
                "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1, EXCLUDE localhost",
                "--window-size=" + width + "," + height);
        if (dark) {
            options.addArguments("--force-dark-mode");
        }
        options.setCapability("goog:loggingPrefs", Map.of("browser", "ALL"));
        driver = new ChromeDriver(
                new ChromeDriverService.Builder().usingDriverExecutable(new File("/usr/bin/chromedriver")).build(),
                options);
        driver.get(address);
    }

    static Page open(String address) {
        return new Page(address, 1280, 900, false);
    }

    static Page onPhone(String address) {
        return new Page(address, 412, 915, true);
    }

    ChromeDriver driver() {
        return driver;
    }

    /** Makes what is seen of the page so large, and waits until it is drawn so. */
    void size(Dimension size) {
        driver.executeCdpCommand("Emulation.setDeviceMetricsOverride",
                Map.of("width", size.width, "height", size.height,
                        "deviceScaleFactor", 1, "mobile", false));
        awaitFrames();
    }

    /** Waits until the page was drawn some times: a busy machine draws seldom. */
    void awaitFrames() {
        script("""
                let left = 4;
                return new Promise((done) => {
                  const next = () => left-- ? requestAnimationFrame(next) : done(true);
                  next();
                });
                """);
    }

    void reload() {
        driver.navigate().refresh();
    }

    /** Waits for an element. */
    WebElement await(String css) {
        return await("an element " + css, page -> all(css).stream().findFirst().orElse(null));
    }

    /** Waits until one of these elements has this text in it. */
    void awaitText(String css, String text) {
        await(css + " with " + text, page -> all(css).stream().anyMatch(element -> element.getText().contains(text)));
    }

    /** Does something, and again each time that so many milliseconds have passed, until it is shown; how often. */
    int repeat(String what, long everyMillis, Runnable action, BooleanSupplier isShown) {
        long[] next = {0};
        int[] times = {0};
        await(what, page -> {
            if (System.currentTimeMillis() >= next[0]) {
                action.run();
                times[0]++;
                next[0] = System.currentTimeMillis() + everyMillis;
            }
            return isShown.getAsBoolean();
        });
        return times[0];
    }

    /** Waits for as many elements at least. */
    void await(String css, int count) {
        await(count + " elements " + css, page -> all(css).size() >= count);
    }

    <T> T await(String what, ExpectedCondition<T> condition) {
        try {
            return new WebDriverWait(driver, PATIENCE).ignoring(StaleElementReferenceException.class).until(condition);
        } catch (TimeoutException e) {
            screenshot("in-vain");
            throw new AssertionError("the page does not show " + what + "; it says: "
                    + driver.findElement(By.tagName("body")).getText() + "\n" + log(), e);
        }
    }

    List<WebElement> all(String css) {
        return driver.findElements(By.cssSelector(css));
    }

    String attribute(String css, String name) {
        return driver.findElement(By.cssSelector(css)).getDomAttribute(name);
    }

    Object script(String javascript, Object... arguments) {
        return ((JavascriptExecutor) driver).executeScript(javascript, arguments);
    }

    Actions actions() {
        return new Actions(driver);
    }

    /** The page's complaints: errors of its scripts, and what its own policy has kept away. */
    List<String> log() {
        return driver.manage().logs().get("browser").getAll().stream().map(Object::toString).toList();
    }

    void screenshot(String name) {
        try {
            Files.createDirectories(SCREENSHOTS);
            Files.write(SCREENSHOTS.resolve(name + ".png"), driver.getScreenshotAs(OutputType.BYTES));
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    @Override
    public void close() {
        driver.quit();
    }
}
