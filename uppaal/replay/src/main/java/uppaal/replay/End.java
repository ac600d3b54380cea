package uppaal.replay;

import java.util.List;
import java.util.Set;
import uppaal.network.StateSet;

/**
 * One end of a message, at its sender's board or at a receiver's: what its automata may be doing. It hears of all
 * that is on the air at its board, as long as anything is due.
 */
final class End {
    /** So many slots later than the model a board may do something: it writes to its EEPROM, or its sketch is busy. */
    private static final int LATE = 40;
    /** By this share of a slot a board may be early: its clock counts milliseconds. */
    private static final double EARLY = 0.25;
    /** From here on, in slots, a carrier is heard. */
    private static final double HEARD = 1.25;
    /** Quiet slots after which more change nothing. */
    private static final int LONG_QUIET = 20;
    /** The model counts no further: the patience while a relay carries it, and the widest window. */
    private static final int MOST = 700;
    /** Slots that a packet takes in the model. */
    private static final int PACKET = 2;
    private static final String TAKING = "taking";
    private static final String CONFIRMED = "confirmed";

    private final Message message;
    private final String who;
    private final Scenes.Scene scene;
    private final Ear ear;
    private final Scenes scenes;
    private StateSet possible;
    /** Up to when its automata know what its board has heard. */
    private double told = Double.NEGATIVE_INFINITY;
    /** Since when its board's air is quiet, or busy. */
    private double since = Double.NEGATIVE_INFINITY;
    /** The last carrier that it has heard begin or end. */
    private long last = -1;
    private int carriers;
    private boolean overlapping;
    /** Whether the present carrier may be unheard. */
    private boolean doubtful;
    /** The most slots of that time that may have passed in the model. */
    private int slots;
    private boolean sending;
    private boolean fresh = true;
    /** Whether the host has said that it has taken it, and the board has not confirmed that. */
    private boolean taking;
    /** What has come while its board was busy with that, or with another message: it may look at it later. */
    private String late;
    /** Since when its board has something to tell of it. */
    private double ended = Double.POSITIVE_INFINITY;

    /**
     * @param who the board's id
     * @param scenes take the edges that may have been taken
     */
    End(Message message, String who, Scenes scenes, Scenes.Scene scene, Ear ear) {
        this.message = message;
        this.who = who;
        this.scene = scene;
        this.ear = ear;
        this.scenes = scenes;
        this.possible = scene.first();
    }

    /** Whether something is due, so that it must hear what is on the air. */
    boolean isAwake() {
        return !possible.isCertain(scene.rest());
    }

    /** Since when its board has had something to tell its host of it, in seconds; infinite where it has not. */
    double ended() {
        return ended;
    }

    /** What may happen next. */
    Set<String> next() {
        return possible.next();
    }

    /** Up to this moment nothing more was seen. */
    void await(double seconds) throws RefusedException {
        if (isAwake()) {
            reach(seconds);
        }
    }

    /** Something was seen. */
    void see(double seconds, String step) throws RefusedException {
        reach(seconds);
        take(possible.see(step), step);
        taking &= !step.equals(CONFIRMED);
    }

    /** Its host says that it has taken it; its board may hear of that up to when it confirms it. */
    void take(double seconds) throws RefusedException {
        if (!may(seconds, TAKING)) {
            see(seconds, TAKING);
        }
        reach(seconds);
        doubt(TAKING);
        taking = true;
        late = null;
    }

    /** Something may have happened. */
    void perhaps(double seconds, String step) throws RefusedException {
        reach(seconds);
        doubt(step);
        late = ear.isBusy() ? step : null;
    }

    /**
     * Its board sends an answer that may be this one, or to another message: then, too, its board is heard to send. So
     * here it is sent and over at once.
     */
    void perhapsSends(double seconds, String step) throws RefusedException {
        reach(seconds);
        StateSet.Seen sent = possible.see(step);
        cover(sent);
        sent.possible().flatMap(sending -> sending.elapse(PACKET, PACKET).possible())
                .flatMap(sending -> sending.after("end")).ifPresent(over -> settle(possible.or(over)));
    }

    private void doubt(String step) {
        cover(possible.see(step));
        settle(possible.perhaps(step));
    }

    /** Whether something may be seen now. */
    boolean may(double seconds, String step) throws RefusedException {
        reach(seconds);
        return possible.after(step).isPresent();
    }

    private void take(StateSet.Seen seen, String step) throws RefusedException {
        StateSet now = seen.possible().orElseThrow(() -> message.refusal(step, who, this));
        cover(seen);
        settle(now);
    }

    private void cover(StateSet.Seen seen) {
        scenes.cover(scene, seen);
    }

    private void settle(StateSet now) {
        possible = now;
        ended = possible.isCertain(scene.ended()) ? Math.min(ended, told) : Double.POSITIVE_INFINITY;
        if (isAwake()) {
            ear.wake(this);
        }
    }

    /** Time passes; an end at which nothing was due hears first what is on the air. */
    private void reach(double seconds) throws RefusedException {
        if (possible.isCertain(scene.over())) {
            return;
        }
        if (told == Double.NEGATIVE_INFINITY || !isAwake()) {
            List<Ear.Sound> latest = ear.latest();
            if (!latest.isEmpty() && last < latest.get(0).number()) {
                told = latest.get(0).seconds() - LONG_QUIET * ear.slot();
                since = told;
                slots = 0;
            }
            for (Ear.Sound sound : latest) {
                if (sound.number() > last) {
                    hear(sound);
                }
            }
        }
        pass(seconds);
        fresh = false;
    }

    /** A carrier begins or ends at its board. */
    void hear(Ear.Sound sound) throws RefusedException {
        last = sound.number();
        pass(sound.seconds());
        boolean sure = !overlapping && (carriers == 0 || !sound.begins() && !doubtful)
                && ear.isSure(sound.begins() ? sound.seconds() : since, sound.seconds());
        doubtful = sound.begins() && !sure;
        if (sound.owner() == this) {
            sending = sound.begins();
            if (!sending) {
                take(possible.see("end"), "end");
            }
        } else {
            if (sound.begins() && carriers > 0 && !overlapping && !sending) {
                // From here on the bits of both together may be no carrier to its board.
                doubt("silence");
            }
            // The turn of its board's messages concerns a sender, once it waits for its own.
            boolean turn = fresh || !scene.template().equals("Sender");
            String name = sound.name().equals("own_message") && turn ? "own_answer" : sound.name();
            if (sure || name.startsWith("own_")) {
                take(possible.see(name), name);
            } else if (sound.begins()) {
                doubt(name);
            } else {
                cover(possible.see(name));
                settle(possible.where(name));
            }
        }
        if (!sound.begins() && sound.name().startsWith("own_") && carriers > 2) {
            // What its board sent hid that others overlap.
            doubt("silence");
        }
        if (taking) {
            doubt(TAKING);
        }
        late = ear.isBusy() ? late : null;
        if (late != null) {
            doubt(late);
        }
        overlapping |= sound.begins() && carriers > 0;
        carriers += sound.begins() ? 1 : -1;
        if (carriers == 0 || sound.begins() && carriers == 1) {
            since = sound.seconds();
            slots = 0;
            overlapping &= carriers != 0;
            if (carriers == 0) {
                StateSet.Seen quiet = possible.only(scene.quiet());
                cover(quiet);
                settle(quiet.possible().orElseThrow());
            }
        }
    }

    /** The next power of two: where little is known, few ways to wait are enough, and soon all are known. */
    private static int coarse(int passed) {
        return passed > LONG_QUIET + LATE ? MOST : passed == 1 ? 1 : Integer.highestOneBit(passed - 1) << 1;
    }

    private void pass(double seconds) throws RefusedException {
        if (told == Double.NEGATIVE_INFINITY) {
            told = seconds - LONG_QUIET * ear.slot();
            since = told;
        }
        double passed = Math.max(0, seconds - told) / ear.slot();
        double all = Math.max(0, seconds - since) / ear.slot();
        StateSet.Seen seen;
        if (seconds <= told) {
            return; // what its board has just heard, it need not have acted upon
        }
        if (sending) {
            seen = possible.elapse(0, PACKET);
        } else if (!ear.isTimed()) {
            seen = possible.elapse(0, MOST);
        } else if (overlapping || !ear.isSure(since, seconds)) {
            seen = possible.elapse(0, coarse((int) passed + 1));
        } else if (carriers > 0) {
            seen = all > HEARD ? possible.elapse(PACKET, PACKET) : possible.elapse(0, 1);
        } else {
            // The slot may have become a little longer, by a packet of the board's own.
            int most = Math.max(0, Math.min(MOST, (int) (all + EARLY)) - slots);
            seen = possible.elapse(Math.min(most, Math.max(0, (int) (passed - LATE))), most);
            slots += most;
        }
        take(seen, StateSet.SLOT);
        told = Math.max(told, seconds);
    }
}
