package uppaal.replay;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Payload;
import trace.TraceEvent;

/** What a board may send as a relay (SPEC 7.5): copies of unicasts that came to it, and of their acknowledgements. */
final class Copies {
    private static final int MODULUS = 3;
    /** Quiet slots before a copy: a new one, one that its sender sends again, and one of its own accord. */
    private static final int NEW = 8;
    private static final int AGAIN = 6;
    private static final int REPEAT = 2;
    /** Slots from the end of a copy to one of its own accord, at least. */
    private static final int REPEAT_AFTER = REPEAT + 20;
    /** Quiet slots before an acknowledgement. */
    private static final int ANSWER = 1;
    /** Copies of a new packet; and of its acknowledgement. */
    private static final int MOST_COPIES = 2;
    private static final int MOST_ANSWERS = 4;
    /** Packets that a relay keeps. */
    private static final int PLACES = 4;
    /** After so long a packet may begin anew, in seconds. */
    private static final double LATE = 1.45;
    /** What came so much earlier may still wait for the air, in seconds. */
    private static final double LONGEST_WAIT = 20;
    /** How early a board may be, and what it may not have heard, in slots. */
    private static final double EARLY = 0.5;
    private static final double UNHEARD = 1.25;
    /** On the air for unicasts that nobody has acknowledged: the most, in seconds, and the share of all time. */
    private static final double MOST_CREDIT = 4;
    private static final double SHARE = 0.1;
    /** How much more it may be, since boards calculate in milliseconds of their clocks. */
    private static final double ROUNDED = 1.1;

    /** A unicast that has come to the board. */
    private static final class Copied {
        final Payload packet;
        /** With which hops it has come. */
        final boolean[] came = new boolean[MODULUS];
        /** With which hops its acknowledgements have come, by their bytes. */
        final Map<String, boolean[]> answers = new HashMap<>();
        /** How often it may still be copied, and the quiet slots before that. */
        int left;
        int quiet;
        /** Since when it may be copied once more of the board's own accord, in seconds. */
        double repeatedFrom;
        /** The hops of the board's copy; negative where they are not known. */
        int hops = -1;
        boolean copied;
        /** Since when it may be answered, in seconds; and whether it came again so late that its answer may be copied. */
        double answeredFrom = Double.POSITIVE_INFINITY;
        boolean askedLate;
        /** Whether the board has carried its acknowledgement, and how often since it was copied. */
        int carried;
        /** Whether it was surely answered, or copied by others, so that the board is to keep silent. */
        boolean answered;
        boolean handedOn;
        double cost;
        /** When it came last or was copied; and when something has surely happened to it. */
        double seen;
        double happened;

        Copied(Payload packet, double seconds) {
            this.packet = packet;
            happened = seconds;
        }

        boolean isSilenced() {
            return answered || handedOn;
        }

        boolean isAnsweredBy(Payload answer) {
            return packet.destination().equals(answer.origin()) && packet.lastBits() == answer.answered();
        }
    }

    private final String name;
    private final Set<String> ids;
    private final Map<String, Copied> packets = new Recent<>();
    /** Whether it is a relay; null where it has not said, since it may have become one before. */
    private Boolean on;
    private double credit = MOST_CREDIT;
    private double filled = Double.NEGATIVE_INFINITY;
    /** The last one for which the board is to keep silent; and how many in a row were copied for all that. */
    private Copied silenced;
    private int heedless;

    /** @param ids the board's own addresses */
    Copies(String name, Set<String> ids) {
        this.name = name;
        this.ids = ids;
    }

    /** Whether it has said that it is a relay. */
    boolean isOn() {
        return on != null && on;
    }

    /** It says whether it is one. */
    void set(boolean relays) {
        if (!relays) {
            reset();
        }
        on = relays;
    }

    /** The board forgets all. */
    void reset() {
        packets.clear();
        credit = MOST_CREDIT;
        silenced = null;
    }

    /** A packet comes to the board, perhaps damaged. */
    void hears(Packet packet, boolean undamaged, double seconds) {
        Payload payload = packet.payload();
        if (isAnswer(payload)) {
            packets.values().stream().filter(copied -> copied.isAnsweredBy(payload))
                    .forEach(copied -> answered(copied, packet, undamaged, seconds));
        } else if (payload.kind() == Payload.Kind.UNICAST && payload.hasNonce() && !ids.contains(payload.origin())
                && !ids.contains(payload.destination())) {
                    unicast(packet, undamaged, seconds);
                }
    }

    private static boolean isAnswer(Payload payload) {
        return payload.isAcknowledgement()
                && (payload.message().length() == Answers.DELIVERED || payload.message().length() == Answers.STALE);
    }

    private void unicast(Packet packet, boolean undamaged, double seconds) {
        Copied copied = packets.get(packet.payload().hex());
        int hops = packet.hops();
        if (copied == null || mayBeForgotten(copied) || copied.carried >= MOST_ANSWERS) {
            Copied again = new Copied(packet.payload(), seconds);
            again.left = MOST_COPIES;
            again.quiet = NEW;
            if (copied != null) {
                // It may be here as before.
                System.arraycopy(copied.came, 0, again.came, 0, MODULUS);
                again.answers.putAll(copied.answers);
                again.answeredFrom = copied.answeredFrom;
                again.copied = copied.copied;
                again.carried = copied.carried;
                again.quiet = Math.min(NEW, copied.left > 0 ? copied.quiet : NEW);
            } else if (undamaged) {
                again.hops = next(hops);
            }
            packets.put(packet.payload().hex(), again);
            copied = again;
        } else {
            again(copied, hops, undamaged, seconds);
        }
        copied.came[hops] = true;
        copied.seen = seconds;
        copied.askedLate |= seconds > copied.answeredFrom + LATE;
    }

    /** It comes again. */
    private void again(Copied copied, int hops, boolean undamaged, double seconds) {
        boolean late = copied.happened < seconds - LATE;
        if (late || hops == 0) {
            int least = late ? NEW : AGAIN;
            copied.quiet = copied.left > 0 ? Math.min(copied.quiet, least) : least;
            copied.left = Math.max(copied.left, late ? MOST_COPIES : 1);
            copied.repeatedFrom = Double.NEGATIVE_INFINITY;
            copied.handedOn = false;
            copied.hops = late && !copied.copied ? -1 : copied.hops;
        } else if (copied.hops >= 0 && undamaged
                && (hops == next(copied.hops) || hops == copied.hops && !copied.copied)) {
                    copied.handedOn = true;
                    silence(copied);
                } else
            if (!undamaged && !copied.copied) {
                copied.hops = -1;
            }
    }

    /** The board is to keep silent; of the one before it has done so. */
    private void silence(Copied copied) {
        if (silenced != null && silenced != copied && silenced.isSilenced()) {
            heedless = 0;
        }
        silenced = copied;
    }

    private void answered(Copied copied, Packet packet, boolean undamaged, double seconds) {
        copied.answeredFrom = Math.min(copied.answeredFrom, seconds);
        copied.answers.computeIfAbsent(packet.payload().hex(), hex -> new boolean[MODULUS])[packet.hops()] = true;
        if (undamaged && copied.hops >= 0) {
            copied.answered = true;
            silence(copied);
        }
        credit = Math.min(MOST_CREDIT, credit + copied.cost);
        copied.cost = 0;
    }

    private static int next(int hops) {
        return (hops + 1) % MODULUS;
    }

    /** Whether so many others have come since that it may have lost its place. */
    private boolean mayBeForgotten(Copied copied) {
        return packets.values().stream().filter(other -> other != copied && other.seen > copied.seen - LONGEST_WAIT)
                .count() >= PLACES;
    }

    /** The board begins to send a packet of somebody else's. */
    void sends(TraceEvent event, Payload payload, Ear ear) throws RefusedException {
        double start = event.real("start");
        if (on != null && !on) {
            throw new RefusedException(name + " copies " + what(payload) + "; expected that it relays nothing");
        }
        if (isAnswer(payload)) {
            sendsAnswer(event, payload, start, ear);
            return;
        }
        Copied copied = packets.get(payload.hex());
        if (copied == null) {
            throw new RefusedException(event.hops() == 0 && !payload.isAcknowledgement()
                    ? name + " sends as '" + payload.origin() + "'; expected its own id"
                    : name + " copies " + what(payload) + "; expected a unicast in one packet, or its acknowledgement, "
                            + "that has come to it");
        }
        checkForm(event, payload, copied.came);
        boolean mayBeNew = copied.carried == 0 || copied.carried >= MOST_ANSWERS || mayBeForgotten(copied);
        if (!mayBeNew) {
            throw new RefusedException(
                    name + " copies " + what(payload) + " though it has carried its acknowledgement");
        }
        if (copied.left == 0) {
            throw new RefusedException(name + " copies " + what(payload) + " once more than it may; expected that it "
                    + "comes again first");
        }
        if (start < copied.repeatedFrom && ear.isTimed()) {
            throw new RefusedException(String.format(Locale.ROOT, "%s copies %s again too soon; expected no earlier "
                    + "than at %.3f s", name, what(payload), copied.repeatedFrom));
        }
        checkQuiet(what(payload), copied.quiet, start, ear);
        if (copied.isSilenced() && ++heedless > RadioCell.LOST) {
            throw new RefusedException(
                    name + " copies " + what(payload) + ", which was answered or handed on; expected "
                            + "silence: of the last " + heedless + " such packets it has heeded none");
        }
        pay(event, payload, copied);
        copied.left--;
        copied.copied = true;
        copied.carried = 0;
        copied.answered = false;
        copied.handedOn = false;
        copied.hops = event.hops();
        copied.quiet = REPEAT;
        copied.happened = event.real("end");
        copied.seen = copied.happened;
        copied.repeatedFrom = copied.happened + (REPEAT_AFTER - EARLY) * ear.slot();
    }

    private void sendsAnswer(TraceEvent event, Payload payload, double start, Ear ear) throws RefusedException {
        Optional<Copied> able = packets.values().stream()
                .filter(copied -> (copied.copied || copied.askedLate) && copied.answers.containsKey(payload.hex()))
                .findFirst();
        if (able.isEmpty()) {
            throw new RefusedException(name + " copies " + what(payload)
                    + "; expected one that has come to it, for a packet that it has copied or that came again late");
        }
        Copied copied = able.get();
        checkForm(event, payload, copied.answers.get(payload.hex()));
        if (copied.carried >= MOST_ANSWERS) {
            throw new RefusedException(name + " copies " + what(payload) + " more than " + MOST_ANSWERS + " times");
        }
        checkQuiet(what(payload), copied.copied && copied.carried == 0 ? ANSWER : AGAIN, start, ear);
        copied.carried++;
        copied.happened = event.real("end");
    }

    private void checkForm(TraceEvent event, Payload payload, boolean[] came) throws RefusedException {
        if (event.has("trailer")) {
            throw new RefusedException(name + " copies " + what(payload) + " with a trailer; expected none");
        }
        if (!came[(event.hops() + MODULUS - 1) % MODULUS]) {
            StringBuilder expected = new StringBuilder();
            for (int hops = 0; hops < MODULUS; hops++) {
                expected.append(came[hops] ? (expected.isEmpty() ? "" : " or ") + next(hops) : "");
            }
            throw new RefusedException(name + " copies " + what(payload) + " with " + event.hops()
                    + " hops behind it; expected " + expected + ", one more than it came with");
        }
    }

    private void checkQuiet(String what, int least, double start, Ear ear) throws RefusedException {
        double quiet = ear.quietBefore(start, UNHEARD);
        double from = start - least * ear.slot();
        if (quiet < least - EARLY && ear.isTimed() && ear.isSure(from, start)) {
            throw new RefusedException(String.format(Locale.ROOT, "%s copies %s after %.1f quiet slots; expected %d or "
                    + "more", name, what, quiet, least));
        }
    }

    /** Unicasts that nobody acknowledges take a tenth of the air at most. */
    private void pay(TraceEvent event, Payload payload, Copied copied) throws RefusedException {
        double start = event.real("start");
        double cost = event.real("end") - start;
        credit = filled == Double.NEGATIVE_INFINITY ? credit
                : Math.min(MOST_CREDIT, credit + (start - filled) * SHARE * ROUNDED);
        filled = start;
        if (credit * ROUNDED < cost) {
            throw new RefusedException(String.format(Locale.ROOT, "%s copies %s; expected that it keeps silent: %.1f s "
                    + "of the air are left for what nobody acknowledges, and it takes %.1f s", name, what(payload),
                    credit,
                    cost));
        }
        credit = Math.max(0, credit - cost);
        copied.cost += cost;
    }

    private static String what(Payload payload) {
        return "a" + (payload.isAcknowledgement() ? "n " : " ") + payload.kind() + " of " + payload.origin();
    }
}
