package javino.board;

import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import javino.legacy.LegacyMessage;
import javino.link.Link;
import javino.link.LinkException;
import javino.protocol.BoardInfo;
import javino.protocol.Capability;
import javino.protocol.ProtocolError;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;
import javino.protocol.Request;
import javino.protocol.Status;

/**
 * Finds out who is at the other end of an open link, and at which speed: says hello, now and then at 1 000 000 baud
 * or 9600, and asks in the older protocol at its speed. Which of them is answered is how the board is then spoken with.
 * For the session's thread only.
 */
final class Greeting {

    /**
     * How many hellos before the older protocol is tried: with the default interval 2 s, in which a board of ours has
     * booted, so that it need not wait for that.
     */
    private static final int HELLOS = 20;
    /** How many where the board has asked again: it is there, and its sketch may wait in loop(). */
    private static final int PATIENT_HELLOS = 100;
    /** A sketch that calls the library often has answered long before. */
    private static final Duration LATE = Duration.ofMillis(500);
    /**
     * For how many hello intervals an answer in the older protocol is waited for: by default 2 s, as there are slow
     * sensors.
     */
    private static final int LEGACY_INTERVALS = 20;

    /** Another speed that a sketch may have; so may it that of the older protocol, which Bluetooth modules have. */
    private static final int FAST_BAUD = 1_000_000;
    /** How many hellos at each of them. */
    private static final int MORE_HELLOS = 5;

    private final Link link;
    private final SessionContext context;
    private final BooleanSupplier goOn;
    private final int baud;
    private final Exchange exchange;
    private final LegacyExchange legacyExchange;

    /** @param goOn asked between attempts whether to make another one. */
    Greeting(Link link, SessionContext context, BooleanSupplier goOn) {
        this.link = link;
        this.context = context;
        this.goOn = goOn;
        baud = link.baud();
        // Random, so that a reply to the program that had the port before is hardly taken for one to this.
        exchange = new Exchange(link, context.time().random().nextInt(0x100), context);
        legacyExchange = new LegacyExchange(link, context);
    }

    /** The exchange with a board that has answered hello. */
    Exchange exchange() {
        return exchange;
    }

    /** The exchange with a board that has answered in the older protocol. */
    LegacyExchange legacyExchange() {
        return legacyExchange;
    }

    /**
     * Asks until a board answers.
     *
     * @return nothing if there was no need to go on.
     * @throws ProtocolException if what answers hello is no board.
     */
    Optional<BoardInfo> greet() throws LinkException, ProtocolException {
        Optional<BoardInfo> board = Optional.empty();
        while (board.isEmpty() && goOn.getAsBoolean()) {
            board = hello(baud, HELLOS);
            if (board.isEmpty() && baud != 0 && goOn.getAsBoolean()) {
                board = hello(FAST_BAUD, MORE_HELLOS);
            }
            if (board.isEmpty() && goOn.getAsBoolean()) {
                board = askInLegacy();
            }
            // Last, as what a board of the older protocol does not understand may spoil its next message.
            if (board.isEmpty() && baud != 0 && goOn.getAsBoolean()) {
                board = hello(LegacyMessage.BAUD, MORE_HELLOS);
            }
        }
        return board;
    }

    private Optional<BoardInfo> hello(int speed, int hellos) throws LinkException, ProtocolException {
        link.setBaud(speed);
        try {
            return hello(hellos);
        } catch (ProtocolException e) {
            // It may be for a poll of the program before, which a hello ends: one in 256 has the same sequence byte.
            context.counters().count(SessionCounter.BAD_REPLIES);
            return hello(hellos);
        }
    }

    private Optional<BoardInfo> hello(int hellos) throws LinkException, ProtocolException {
        Optional<Reply> reply = exchange.ask(Request.hello(), context.config().helloInterval(), () -> false,
                attempts -> attempts < (exchange.hasAskedAgain() ? PATIENT_HELLOS : hellos) && goOn.getAsBoolean());
        Duration presence = exchange.presence();
        exchange.setLag(presence.compareTo(LATE) > 0 ? presence : Duration.ZERO);
        Optional<BoardInfo> board = reply.isEmpty() ? Optional.empty() : Optional.of(boardInfo(reply.get()));
        board.ifPresent(
                greeted -> exchange.setSaysTaken(greeted.capabilities().contains(Capability.SAYS_TAKEN)));
        return board;
    }

    private Optional<BoardInfo> askInLegacy() throws LinkException {
        link.setBaud(LegacyMessage.BAUD);
        return legacyExchange.askPercepts(context.config().helloInterval().multipliedBy(LEGACY_INTERVALS), goOn)
                .map(answer -> BoardInfo.legacy());
    }

    private static BoardInfo boardInfo(Reply reply) throws ProtocolException {
        if (reply.status() != Status.OK) {
            throw new ProtocolException(ProtocolError.BAD_REPLY, "hello answered with " + reply.status());
        }
        BoardInfo board = reply.boardInfo();
        if (board.isLegacy()) {
            throw new ProtocolException(ProtocolError.BAD_REPLY, "hello answered with version "
                    + board.protocolVersion());
        }
        return board;
    }
}
