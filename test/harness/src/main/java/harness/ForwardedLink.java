package harness;

import java.util.function.UnaryOperator;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/** A real link, between which and its host something happens to the bytes. */
public abstract class ForwardedLink implements Link {

    protected final Link link;

    protected ForwardedLink(Link link) {
        this.link = link;
    }

    /** Opens links and puts something between each of them and its host. */
    public static LinkOpener opener(LinkOpener opener, UnaryOperator<Link> between) {
        return new LinkOpener() {
            @Override
            public Link open() throws LinkException {
                return between.apply(opener.open());
            }

            @Override
            public String name() {
                return opener.name();
            }
        };
    }

    @Override
    public final void wake() {
        link.wake();
    }

    @Override
    public final void close() {
        link.close();
    }
}
