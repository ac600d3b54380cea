package browser;

import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.WebElement;

/**
 * Films {@code docs/live.gif}: 20 s of the live page, from 1 s before the bus asks for help, slowed down. The page
 * goes from moment to moment, so a busy machine films the same.
 */
public final class Film {

    private static final int FRAMES = 100;
    private static final int MILLIS = 200;
    /** Emulated seconds a second. */
    private static final double SPEED = 0.4;

    private Film() {}

    /**
     * Writes the film.
     *
     * @param arguments its file
     */
    public static void main(String[] arguments) throws Exception {
        AnimatedGif film = new AnimatedGif();
        try (LiveRun run = LiveRun.highway(Files.createTempDirectory("film"));
                Page page = Page.open(run.address())) {
            page.await(LivePageTest.OBSERVED, 9);
            page.size(new Dimension(1280, 720));
            double begins = run.events(event -> event.is("rf-tx", "bus")).get(0).real("start") - 1;
            WebElement slider = page.await("#slider");
            for (int i = 0; i < FRAMES; i++) {
                page.script("arguments[0].value = arguments[1]; "
                        + "arguments[0].dispatchEvent(new Event('input', {bubbles: true}))", slider,
                        begins + i * SPEED * MILLIS / 1000);
                page.awaitFrames();
                byte[] png = page.driver().getScreenshotAs(OutputType.BYTES);
                film.add(ImageIO.read(new ByteArrayInputStream(png)), MILLIS);
            }
        }
        film.write(Path.of(arguments[0]).toFile());
        System.exit(0);
    }
}
