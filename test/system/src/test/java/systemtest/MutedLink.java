package systemtest;

import harness.ForwardedLink;
import harness.Host;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/** A real link whose host is not heard any more once it has heard a word: it gets a message, and never says so. */
final class MutedLink extends ForwardedLink {

    private final String word;
    private final StringBuilder heard = new StringBuilder();

    private MutedLink(Link link, String word) {
        super(link);
        this.word = word;
    }

    static LinkOpener opener(String port, String word) {
        return opener(Host.link(port), link -> new MutedLink(link, word));
    }

    @Override
    public void write(byte[] bytes) throws LinkException {
        if (heard.indexOf(word) < 0) {
            link.write(bytes);
        }
    }

    @Override
    public int read(byte[] into, Duration timeout) throws LinkException {
        int count = link.read(into, timeout);
        heard.append(new String(into, 0, count, StandardCharsets.ISO_8859_1));
        return count;
    }
}
