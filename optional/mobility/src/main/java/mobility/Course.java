package mobility;

import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

import diffuser.report.Failure;

import javino.link.Time;
import javino.protocol.Bytes;
import javino.protocol.Outcome;

/** A move under way: does what its {@link Machine} decides. On the thread of the {@link Time.Timer}. */
final class Course {

    /** Between two reports of progress. */
    private static final long PROGRESS_MILLIS = 5_000;
    private static final long PERCENT = 100;

    private final Moves moves;
    private final Move.Key key;
    private final Retransmission message;
    private final Optional<CompletableFuture<String>> end;
    private Machine machine;
    private long reported;
    /** A wait that began in an earlier turn is over. */
    private int turn;

    /** @param end completes with the name there of an agent that leaves; none where nobody waits for it. */
    Course(Moves moves, Move.Key key, Machine machine, Optional<CompletableFuture<String>> end) {
        this.moves = moves;
        this.key = key;
        this.machine = machine;
        this.end = end;
        message = new Retransmission(moves.clock, this::answer, event -> {
            if (key.out()) {
                step(event);
            }
        });
        reported = moves.clock.millis();
    }

    Move.Key key() {
        return key;
    }

    Machine machine() {
        return machine;
    }

    /** Goes on from the record of its machine. */
    void goOn() {
        moves.reached(this);
        message.say(machine.message(), 0);
        await();
        if (machine.state() == Arrival.State.WAKING) {
            wake(true);
        }
    }

    void step(Event event) {
        try {
            machine.step(event, moves).forEach(effect -> effect.accept(this));
        } catch (UncheckedIOException e) {
            if (machine.record().isPresent() || key.out()) {
                throw e;
            }
            step(new Event.Rejected(new RefusedException("disk", "its records cannot be written: " + e.getMessage()),
                    false));
        }
    }

    /** Says and does nothing more. */
    void close() {
        turn++;
        message.say(Optional.empty(), 0);
    }

    // Effects of an event

    /** Writes or deletes the record of a state; then it is the state, and its message is said. */
    void become(Machine next) {
        if (!next.record().equals(machine.record())) {
            next.record().ifPresentOrElse(moves.folder::write, () -> moves.folder.delete(key));
        }
        Machine before = machine;
        machine = next;
        moves.reached(this);
        if (!next.message().equals(before.message())) {
            // If all has been delivered, an answer may be on its way.
            message.say(next.message(), next.state() == Departure.State.SENT ? Retransmission.ANSWER_MILLIS : 0);
        }
    }

    /** {@link Machine#patience} begins anew. */
    void await() {
        await(machine.patience());
    }

    private void await(long millis) {
        int mine = ++turn;
        moves.clock.after(millis, () -> {
            if (mine == turn && machine.patience() > 0) {
                // If the disk fails, it is tried again.
                await(Retransmission.LEAST_PAUSE_MILLIS);
                step(new Event.Expired());
            }
        });
    }

    /** Says something once. */
    CompletableFuture<Outcome> answer(MoveMessage.Said said) {
        return moves.mas.send(key.peer(), new MoveMessage(key.number(), said).encode());
    }

    /** Says again what is said, at once. */
    void hurry() {
        message.hurry();
    }

    /** Counts a message that is of no use. */
    void drop() {
        moves.counts.count(Moves.Count.DROPPED);
    }

    /** Forgets what no record needs. */
    void tidy() {
        moves.tidy();
    }

    /** Tells how much is there of an agent that takes long. */
    void report(List<Integer> there, List<Part> parts) {
        if (moves.clock.millis() - reported >= PROGRESS_MILLIS) {
            reported = moves.clock.millis();
            moves.mas.progress(machine.move().name(), key.peer(), key.out(),
                    (int) (PERCENT * there.stream().mapToLong(Integer::longValue).sum()
                            / Math.max(1, parts.stream().mapToLong(Part::packed).sum())));
        }
    }

    /** The move by which the agent came is over. */
    void endEarlier() {
        machine.move().before().ifPresent(earlier -> moves.step(earlier, new Event.Superseded()));
    }

    /** The agent ends here. */
    void remove() {
        moves.mas.left(machine.move());
    }

    /** @param name the agent's name there. */
    void arrived(String name) {
        moves.counts.count(Moves.Count.LEFT);
        end.ifPresent(waiting -> waiting.complete(name));
        tidy();
    }

    /** The agent lives on here, and its plan fails. */
    void stay(Failure why, Departure.Parts parts) {
        moves.counts.count(Moves.Count.STAYED);
        end.ifPresentOrElse(waiting -> waiting.completeExceptionally(why.toException()),
                () -> moves.mas.stays(machine.move(), parts.texts(), why));
    }

    /** Has a plan asked whether an agent may come. */
    void ask(Move comes, MoveMessage.Offer offer) {
        moves.admit(comes, offer).whenComplete((done, thrown) -> moves.clock.execute(() -> {
            Throwable cause = thrown instanceof CompletionException ? thrown.getCause() : thrown;
            step(thrown == null ? new Event.Accepted() : new Event.Rejected(cause instanceof RefusedException refused
                    ? refused : new RefusedException("refused", String.valueOf(cause.getMessage())), false));
        }));
    }

    void refuse(RefusedException why, List<Part> unneeded) {
        moves.counts.count(Moves.Count.REFUSED);
        moves.mas.warn("an agent from " + key.peer() + " was not taken in: " + why.getMessage());
        answer(new MoveMessage.Refused(why.error(), why.getMessage()));
        unneeded.forEach(part -> moves.folder.forget(part.hash()));
    }

    /** Keeps bytes of a part; or says what lacks, where they do not fit. */
    void take(MoveMessage.Data data, MoveMessage.Offer offer) {
        if (data.part() >= offer.parts().size()) {
            drop();
            return;
        }
        Part part = offer.parts().get(data.part());
        int here = moves.folder.here(part);
        int end = data.offset() + data.bytes().length();
        if (data.offset() > here || end > part.packed()) {
            look(offer, true);
        } else if (end > here) {
            moves.folder.append(part.hash(), data.bytes().from(here - data.offset()));
            report(here(offer), offer.parts());
            look(offer, false);
        }
    }

    /** Checks the texts if all is here; else says what lacks, if that is wanted. */
    void look(MoveMessage.Offer offer, boolean say) {
        if (offer.parts().stream().allMatch(part -> moves.folder.here(part) >= part.packed())) {
            check(offer.parts());
        } else if (say) {
            answer(new MoveMessage.Want(here(offer)));
        }
    }

    private List<Integer> here(MoveMessage.Offer offer) {
        return offer.parts().stream().map(moves.folder::here).toList();
    }

    private void check(List<Part> parts) {
        List<Bytes> all = new ArrayList<>();
        boolean damaged = true;
        try {
            for (Part part : parts) {
                all.add(moves.folder.whole(part));
            }
            damaged = false;
            moves.mas.check(all);
        } catch (RefusedException e) {
            step(new Event.Rejected(e, damaged));
            return;
        }
        all.forEach(text -> moves.folder.keep(Part.hash(text), text));
        step(new Event.Accepted());
    }

    /** Nothing more is done where the texts are lost. */
    void expectTexts() {
        moves.texts(machine.move());
    }

    /** The agent has come, and so has gone no longer; it wakes. */
    void come(List<Move> absences) {
        moves.counts.count(Moves.Count.CAME);
        for (Move absence : absences) {
            moves.step(absence.key(), new Event.Superseded());
            moves.folder.delete(absence.key());
        }
        wake(false);
    }

    /** @param anew as in {@link Event.Woken}. */
    void wake(boolean anew) {
        moves.mas.wake(machine.move(), moves.texts(machine.move()), anew,
                name -> step(new Event.Woken(name, anew)));
    }
}
