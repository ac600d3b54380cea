package uppaal.replay;

import java.util.Locale;
import javino.protocol.Airtime;
import javino.protocol.Payload;
import trace.TraceEvent;

/** Packets must be on the air as long as their bytes take (SPEC 6). */
final class AirtimeCheck {
    private static final int MARK_BITS = 12;
    private static final int PARITY_BITS = 12 * 17;
    private static final int SHORT_PARITY_BITS = 12 * 13;
    /** The most bytes of payload whose parity is short. */
    private static final int SHORT_PAYLOAD = 45;
    private static final int LEAST_RATE = 90;
    private static final int MOST_RATE = 11_000;

    private AirtimeCheck() {
    }

    /** A packet of ours has as many bits as its bytes need (SPEC 6, 6.2); a reset or the end may cut a trailer. */
    static void check(TraceEvent event, Payload payload, Station board) throws RefusedException {
        if (!board.isNamed() && !board.copies.isOn()) {
            return;
        }
        double bits = event.real("bits");
        String trailer = event.textOrEmpty("trailer");
        int length = payload.bytes().length();
        int least = event.has("radio") ? Airtime.moduleBits(length) : Airtime.bits(length);
        int all = least + trailerBits(trailer, length);
        // The trace's end breaks a packet off, too.
        boolean mayBreakOff = event.has("cut") || !board.ear.isSure(event.real("start"), event.seconds());
        if (bits != all && !(mayBreakOff && bits >= least && bits < all)) {
            throw new RefusedException(event.board() + " sends " + (int) bits + " bits; expected " + all
                    + " for these bytes" + (trailer.isEmpty() ? "" : " and this trailer"));
        }
        double seconds = event.real("end") - event.real("start");
        double rate = (bits - 1) / seconds;
        if (!(rate >= LEAST_RATE && rate <= MOST_RATE && (mayBreakOff || board.ear.fits(bits, seconds)))) {
            throw new RefusedException(String.format(Locale.ROOT,
                    "%s sends %d bits in %.6f s; expected a time on the air that fits them", event.board(), (int) bits,
                    seconds));
        }
    }

    private static int trailerBits(String trailer, int length) {
        return switch (trailer) {
            case "mark" -> MARK_BITS;
            case "parity" -> length <= SHORT_PAYLOAD ? SHORT_PARITY_BITS : PARITY_BITS;
            default -> 0;
        };
    }

    /** What reaches a board takes as long as it was sent, but for a trailer. */
    static void checkArrival(TraceEvent event, Packet packet) throws RefusedException {
        if (!event.has("payload")) {
            return;
        }
        double end = event.real("end");
        double bit = (packet.end() - packet.start()) / packet.bits();
        double least = packet.start() + bit * (Airtime.bits(packet.payload().bytes().length()) - 2);
        if (end < Math.min(least, packet.end()) - RadioCell.DISORDER || end > packet.end() + RadioCell.DISORDER) {
            throw new RefusedException(event.board() + " hears a packet end " + (end < least ? "before" : "after")
                    + " its sender has ended it");
        }
    }
}
