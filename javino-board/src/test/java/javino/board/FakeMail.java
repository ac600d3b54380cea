package javino.board;

import java.util.ArrayList;
import java.util.List;
import javino.protocol.Bytes;
import javino.protocol.Outcome;

/** What a fake board keeps for its host until it is polled, and how it answers a poll (SPEC 4.3). */
final class FakeMail {

    private int damaged;

    void setDamaged() {
        damaged = 8;
    }

    /** What follows status and flags. */
    private static final int ROOM = 509;

    /** Records that are told once: outcomes, frames without a key, and what was overheard. */
    private final List<Bytes> news = new ArrayList<>();
    private int told;
    private final List<Bytes> messages = new ArrayList<>();
    private int firstNumber;
    private List<Bytes> reading;
    private long readAt;
    /** How many of the messages a reply has brought: only these can be taken, whatever numbers come again later. */
    private int offered;

    void receive(String destination, String origin, int id, Bytes content) {
        messages.add(Bytes.join(Bytes.ofText(destination), Bytes.ofText(origin), Bytes.ofNumber(id, 3), content));
    }

    void end(int number, Outcome outcome) {
        news.add(record('T', Bytes.of(number, outcome.ordinal())));
    }

    void receiveWithoutKey(String destination, String origin) {
        news.add(record('N', Bytes.join(Bytes.ofText(destination), Bytes.ofText(origin))));
    }

    void overhear(long millis, int how, Bytes payload) {
        news.add(record('O', Bytes.join(Bytes.ofNumber(millis, 4), Bytes.of(how), payload)));
    }

    /** Forgets the message of this number and all before it. */
    void taken(int number) {
        int index = number - firstNumber & 0xFF;
        if (index < offered) {
            messages.subList(0, index + 1).clear();
            offered -= index + 1;
            firstNumber = number + 1 & 0xFF;
        }
    }

    /** The host has had the last reply. */
    void replyArrived() {
        news.subList(0, told).clear();
        told = 0;
    }

    /** The host may not have had the last reply. */
    void hostArrived() {
        told = 0;
        reading = null;
    }

    /** Loses outcomes, and numbers messages anew: their senders repeat those that were not taken. */
    void boot() {
        news.clear();
        told = 0;
        firstNumber = 0;
        offered = 0;
        reading = null;
    }

    boolean isEmpty() {
        return messages.isEmpty();
    }

    /** The message of a poll. */
    record Poll(boolean percepts, boolean now, int hold, int least) {

        static Poll of(Bytes message) {
            return new Poll((message.at(1) & 1) != 0, (message.at(1) & 2) != 0, (int) message.number(2, 4),
                    (int) message.number(4, 7));
        }
    }

    /**
     * The reply if there is something to tell, or it must not be held any longer; otherwise null.
     *
     * @param percepts what the board perceives.
     * @param over     whether the hold is over, or a byte has come.
     */
    Bytes answer(Poll poll, List<Bytes> percepts, boolean over) {
        if (!poll.percepts()) {
            reading = null;
        }
        if (told < news.size() || !messages.isEmpty()) {
            return tellWhatWaits();
        }
        boolean due = reading == null || poll.now()
                || !percepts.equals(reading) && System.nanoTime() - readAt >= poll.least() * 1_000_000L;
        if (poll.percepts() && due) {
            reading = List.copyOf(percepts);
            readAt = System.nanoTime();
            return tellReading();
        }
        return over ? Bytes.of(0, damaged) : null;
    }

    private Bytes tellWhatWaits() {
        int flags = damaged;
        Bytes records = Bytes.EMPTY;
        for (Bytes untold : news.subList(told, news.size())) {
            records = Bytes.join(records, untold);
        }
        told = news.size();
        for (int i = 0; i < messages.size(); i++) {
            Bytes longer = Bytes.join(records, record('M', Bytes.join(Bytes.of(firstNumber + i), messages.get(i))));
            if (longer.length() > ROOM) {
                flags |= 1;
                break;
            }
            records = longer;
            offered = Math.max(offered, i + 1);
        }
        return Bytes.join(Bytes.of(0, flags), records);
    }

    private Bytes tellReading() {
        int flags = damaged | 4;
        Bytes records = Bytes.EMPTY;
        for (Bytes percept : reading) {
            Bytes longer = Bytes.join(records, record('P', percept));
            flags |= longer.length() > ROOM ? 2 : 0;
            records = longer.length() > ROOM ? records : longer;
        }
        return Bytes.join(Bytes.of(0, flags), records);
    }

    private static Bytes record(char type, Bytes value) {
        return Bytes.join(Bytes.of(type), Bytes.ofNumber(value.length(), 2), value);
    }
}
