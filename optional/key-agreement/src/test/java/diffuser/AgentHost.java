package diffuser;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.logging.Level;
import java.util.logging.Logger;

import jason.asSyntax.ASSyntax;

import diffuser.board.BoardSettings;
import diffuser.board.Device;
import diffuser.board.DeviceContext;
import diffuser.board.ExclusivePort;
import diffuser.board.HostMessages;
import diffuser.board.KeyService;
import diffuser.report.Warnings;

import javino.board.BoardConfig;
import javino.board.Transmission;
import javino.keyring.BoundedClock;
import javino.link.LinkOpener;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.Message;

/** The parts of a {@link Diffuser} around its board, without the agent. */
public final class AgentHost implements AutoCloseable {

    private static final Logger SILENT = Logger.getLogger("agent host of a test");

    private final Device device;

    static {
        SILENT.setLevel(Level.OFF);
    }

    /** @param clock the computer's clock. */
    public AgentHost(LinkOpener link, Address id, BoundedClock clock, KeyService keyService) {
        BoardConfig usual = new Diffuser().boardConfig();
        Warnings warnings = new Warnings(() -> SILENT);
        DeviceContext context = new DeviceContext("agent", "", (message, peer) -> {},
                new HostMessages(List.of(keyService), warnings::once), warnings, () -> {}, text -> {},
                Optional.of(keyService), false);
        BoardSettings settings = BoardSettings.NONE.withRfId(id).withRadio(true);
        device = Device.open(new ExclusivePort(link, "agent", CompletableFuture.completedFuture(null), Time.REAL),
                ASSyntax.createString(link.name()), usual.with(usual.notes(), clock), settings, context);
    }

    /** Whether its board is there; waits until that is known. */
    public boolean isOnline() {
        device.decided().join();
        return device.isOnline();
    }

    public Transmission transmit(Address to, Message message) {
        return device.transmit(to, message);
    }

    /** Waits until the board has done all that it was asked for until now. */
    public void awaitBoard() {
        device.counters().handle((counters, thrown) -> null).join();
    }

    @Override
    public void close() {
        device.close().join();
    }
}
