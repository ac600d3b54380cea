package javino.fake;

import java.util.ArrayList;
import java.util.List;
import javino.protocol.Bytes;
import javino.protocol.Outcome;

/** The records that a fake board keeps until its host polls: messages, ends of transmissions, reports of the radio. */
public final class Mailbox {

    private final Runnable onChange;
    /** Records that are told once, and how many of them the last reply had. */
    private final List<Bytes> reports = new ArrayList<>();
    private int told;
    private final List<Bytes> messages = new ArrayList<>();
    private int firstNumber;
    /** How many messages a reply has brought: the host can have taken only these, whatever numbers come again later. */
    private int offered;

    Mailbox(Runnable onChange) {
        this.onChange = onChange;
    }

    synchronized void receive(String destination, String origin, int id, Bytes content) {
        messages.add(Bytes.join(Bytes.ofText(destination + origin), Bytes.ofNumber(id, 3), content));
        onChange.run();
    }

    synchronized void end(int number, Outcome outcome) {
        report('T', Bytes.of(number, outcome.ordinal()));
    }

    /** Reports a sealed frame for which the board has no key. */
    public synchronized void receiveWithoutKey(String destination, String origin) {
        report('N', Bytes.ofText(destination + origin));
    }

    /** Reports a packet that the board hears. */
    public synchronized void overhear(long millis, int how, Bytes payload) {
        report('O', Bytes.join(Bytes.ofNumber(millis, 4), Bytes.of(how), payload));
    }

    private void report(char type, Bytes value) {
        reports.add(Poll.record(type, value));
        onChange.run();
    }

    /** Deletes what the host has. */
    synchronized void take(Poll poll) {
        if (poll.lostReply()) {
            told = 0;
        } else if (!poll.replyMayCome()) {
            reports.subList(0, told).clear();
            told = 0;
            notifyAll();
        }
        int index = poll.taken() - firstNumber & 0xFF;
        if (poll.taken() >= 0 && index < offered) {
            messages.subList(0, index + 1).clear();
            offered -= index + 1;
            firstNumber = firstNumber + index + 1 & 0xFF;
            notifyAll();
        }
    }

    /** Tells again what the last reply had: a host has come. */
    synchronized void hostArrived() {
        told = 0;
    }

    /** Loses reports, and numbers messages anew: their senders repeat those that were not taken. */
    synchronized void boot() {
        reports.clear();
        told = 0;
        firstNumber = 0;
        offered = 0;
        notifyAll();
    }

    synchronized boolean isWaiting() {
        return told < reports.size() || !messages.isEmpty();
    }

    /** A reply with all reports, and the messages that fit. */
    synchronized Bytes tell(int flags) {
        Bytes records = Bytes.join(reports.subList(told, reports.size()).toArray(Bytes[]::new));
        told = reports.size();
        for (int i = 0; i < messages.size(); i++) {
            Bytes numbered = Bytes.join(Bytes.of(firstNumber + i & 0xFF), messages.get(i));
            Bytes longer = Bytes.join(records, Poll.record('M', numbered));
            if (longer.length() > Poll.ROOM) {
                return Bytes.join(Bytes.of(0, flags | Poll.MORE), records);
            }
            records = longer;
            offered = Math.max(offered, i + 1);
        }
        return Bytes.join(Bytes.of(0, flags), records);
    }

    /** Waits until the host has had all that there was to tell, and has asked for more. */
    public synchronized void awaitQuiet() throws InterruptedException {
        while (!messages.isEmpty() || !reports.isEmpty()) {
            wait();
        }
    }

    /** Waits until the host has taken all messages. */
    public synchronized void awaitAllTaken() throws InterruptedException {
        while (!messages.isEmpty()) {
            wait();
        }
    }
}
