package live;

import diffuser.Diffuser;
import javino.fake.FakeBoard;
import javino.link.LinkOpener;
import javino.protocol.Capability;

/** An agent whose board's sketch prints. */
public final class PrintingBoard extends Diffuser {

    private static final long serialVersionUID = 1L;

    @Override
    protected LinkOpener link(String port) {
        FakeBoard fake = new FakeBoard();
        fake.setCapabilities(Capability.SAYS_TAKEN);
        fake.setActions("lampOn");
        fake.line.setPrints("t = 20.99\r\n");
        return fake.port;
    }
}
