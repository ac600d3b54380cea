package javino.fake;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import javino.link.InMemoryLink;
import javino.link.LinkException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.SerialPacket;
import javino.protocol.PacketDecoder;
import javino.protocol.PollReply;

/** A fake board's end of the line: packets, repeats answered from memory, held polls (SPEC 4.2, 4.3), and faults. */
public final class PacketLine implements FakePort.Device {

    /**
     * The message that ends a Mega's boot loader: start, sequence 1, length 1, token, CMD_LEAVE_PROGMODE_ISP, exclusive
     * or of all.
     */
    private static final String LEAVE_PROGRAMMING = "1b" + "01" + "0001" + "0e" + "11" + "04";
    /** The boot loader's answer to that: length 2, CMD_LEAVE_PROGMODE_ISP, STATUS_CMD_OK. */
    private static final Bytes PROGRAMMING_LEFT = Bytes.of(0x1B, 0x01, 0x00, 0x02, 0x0E, 0x11, 0x00, 0x07);
    /** The longest reply, as a packet, that is kept for a repeat of a poll; else that is asked again (SPEC 4.2). */
    private static final int MOST_KEPT = 20;
    /** The time between the bytes of a reading that is halted. */
    private static final long BYTE_NANOS = 10_000_000;

    private final FakeBoard board;
    private final PacketDecoder decoder = new PacketDecoder();
    private final byte[] buffer = new byte[1024];
    private final List<Bytes> messages = new ArrayList<>();
    private InMemoryLink line;
    private SerialPacket lastRequest;
    private Bytes lastReply = Bytes.EMPTY;
    private SerialPacket held;
    private long heldSince;
    private int polls;
    private Future<?> nextLook;
    private boolean booted;

    private UnaryOperator<Bytes> fault = reply -> reply;
    private Predicate<Bytes> loses = message -> false;
    private Duration delay = Duration.ZERO;
    private boolean silent;
    private boolean stalled;
    private Bytes stalledReplies = Bytes.EMPTY;
    private boolean loading;
    private int bootLoaderQuestions;
    private boolean badPolls;
    private Bytes prints = Bytes.EMPTY;
    /** What actions print, by the messages of their requests. */
    private final Map<Bytes, Bytes> says = new HashMap<>();
    private int deaf;
    private boolean haltsReadings;
    /** The end of a reading: its last byte waits for the host's next one. */
    private Bytes rest = Bytes.EMPTY;

    PacketLine(FakeBoard board) {
        this.board = board;
    }

    @Override
    public synchronized void receive(InMemoryLink from) throws LinkException {
        line = from;
        if (!stalled) {
            read();
            scheduleLook();
        }
    }

    private boolean read() throws LinkException {
        int count = line.read(buffer, Duration.ZERO);
        if (count > 0 && deaf > 0) {
            deaf--;
        } else if (count > 0) {
            receive(count);
        }
        return count > 0;
    }

    private void receive(int count) {
        writeWhatWaits(true);
        endHold();
        boolean leaves = Bytes.copyOf(buffer).slice(0, count).hex().contains(LEAVE_PROGRAMMING);
        bootLoaderQuestions += leaves ? 1 : 0;
        if (loading) {
            // Bytes that come in one piece with the boot loader's end are lost with it.
            loading = !leaves;
            write(loading ? Bytes.EMPTY : PROGRAMMING_LEFT);
            return;
        }
        for (PacketDecoder.Result result : decoder.feed(buffer, count)) {
            endHold();
            if (result instanceof PacketDecoder.Found found) {
                answer(found.packet());
            }
        }
    }

    private void endHold() {
        if (held != null) {
            answerHeld(true);
        }
    }

    /** Has the board soon look whether it has something to send. */
    void changed() {
        FakePort.TIMER.execute(this::look);
    }

    private synchronized void look() {
        if (line == null) {
            return;
        }
        writeWhatWaits(false);
        if (held != null) {
            answerHeld(false);
        }
        scheduleLook();
    }

    private void scheduleLook() {
        if (nextLook != null) {
            nextLook.cancel(false);
        }
        if (rest.length() > 1 || held != null) {
            long nanos = rest.length() > 1 ? BYTE_NANOS : nanosUntilAnswer();
            nextLook = FakePort.TIMER.schedule(this::look, nanos, TimeUnit.NANOSECONDS);
        }
    }

    private long nanosUntilAnswer() {
        Poll poll = new Poll(held.frame().message());
        return Math.min(heldSince + poll.holdNanos() - System.nanoTime(), board.percepts.nanosUntilReading(poll));
    }

    /** Asks again after a boot, and writes more of a reading that is halted. */
    private void writeWhatWaits(boolean byteCame) {
        if (booted) {
            booted = false;
            askAgain();
        }
        int end = byteCame ? rest.length() : Math.min(1, rest.length() - 1);
        if (end > 0) {
            write(rest.slice(0, end));
            rest = rest.from(end);
        }
    }

    private void answerHeld(boolean byteCame) {
        Poll poll = new Poll(held.frame().message());
        boolean over = byteCame || System.nanoTime() - heldSince >= poll.holdNanos();
        Bytes message = badPolls ? Bytes.of(0, 0, 'P') : board.answer(poll, over);
        if (message != null) {
            SerialPacket request = held;
            held = null;
            reply(request, message);
        }
    }

    private void answer(SerialPacket request) {
        if (silent || loses.test(request.frame().message())) {
            return;
        }
        if (board.saysTaken()) {
            FakePort.write(line, Bytes.join(prints, Bytes.of(0)).toArray());
        }
        boolean repeated = request.equals(lastRequest);
        if (repeated && !(request.frame().message().at(0) == 'P' && lastReply.length() > MOST_KEPT)) {
            write(fault.apply(lastReply));
            return;
        }
        if (!repeated) {
            messages.add(request.frame().message());
        }
        write(says.getOrDefault(request.frame().message(), Bytes.EMPTY));
        Bytes message = board.perform(repeated ? Poll.repeated(request.frame()) : request.frame());
        if (message != null) {
            reply(request, message);
            return;
        }
        held = request;
        heldSince = System.nanoTime();
        polls++;
        notifyAll();
        answerHeld(false);
    }

    private void reply(SerialPacket request, Bytes message) {
        lastReply = new SerialPacket(request.sequence(), new Frame(Address.SERIAL, Address.SERIAL, message)).encode();
        lastRequest = request;
        Bytes bytes = fault.apply(lastReply);
        if (haltsReadings && isHolding(request.frame().message())
                && PollReply.isReading(request.sequence(), begun(bytes))) {
            rest = bytes.from(bytes.length() - 4);
            bytes = bytes.slice(0, bytes.length() - 4);
        }
        write(board.saysTaken() ? Bytes.join(Bytes.of(0), bytes) : bytes);
    }

    private static boolean isHolding(Bytes request) {
        return request.at(0) == 'P' && new Poll(request).holdNanos() > 0;
    }

    private static Bytes begun(Bytes reply) {
        PacketDecoder decoder = new PacketDecoder();
        decoder.feed(reply.toArray(), reply.length() - 1);
        return decoder.begun(PollReply.FLAGS_END);
    }

    private void write(Bytes bytes) {
        InMemoryLink to = line;
        if (silent) {
            return;
        }
        if (stalled) {
            stalledReplies = Bytes.join(stalledReplies, bytes);
        } else if (delay.isZero()) {
            FakePort.write(to, bytes.toArray());
        } else {
            FakePort.TIMER.schedule(() -> FakePort.write(to, bytes.toArray()), delay.toNanos(), TimeUnit.NANOSECONDS);
        }
    }

    /** Asks again, as after damage: an earlier library sends one zero for it. */
    public synchronized void askAgain() {
        write(board.saysTaken() ? Bytes.of(0, 1, 0) : Bytes.of(0));
    }

    /** Writes what is no packet, as a sketch that prints does. */
    public synchronized void print(String text) {
        write(Bytes.ofText(text));
    }

    /** Writes this before it takes each request. */
    public synchronized void setPrints(String text) {
        prints = Bytes.ofText(text);
    }

    /** Prints this whenever it performs that action. */
    synchronized void setSays(String action, String text) {
        says.put(Bytes.ofText("A" + action), Bytes.ofText(text));
    }

    synchronized void boot() {
        held = null;
        booted = true;
        lastRequest = null;
        changed();
    }

    /** Answers nothing, or again everything. */
    public synchronized void setSilent(boolean isSilent) {
        silent = isSilent;
    }

    /** Does nothing more before {@link #resume}. */
    synchronized void stall() {
        stalled = true;
        notifyAll();
    }

    /** Waits until the board stalls. */
    public synchronized void awaitStalled() throws InterruptedException {
        while (!stalled) {
            wait();
        }
    }

    /** Sends the replies that were stalled, and receives what came since. */
    synchronized void resume() {
        stalled = false;
        Bytes replies = stalledReplies;
        stalledReplies = Bytes.EMPTY;
        FakePort.TIMER.execute(() -> receiveStalled(replies));
    }

    private synchronized void receiveStalled(Bytes replies) {
        try {
            write(replies);
            while (!stalled && read()) {
                scheduleLook();
            }
        } catch (LinkException closed) {
            return;
        }
    }

    /** Sends each reply so much later. */
    public synchronized void setDelay(Duration newDelay) {
        delay = newDelay;
    }

    /** Changes the bytes of each reply on their way. */
    public synchronized void setFault(UnaryOperator<Bytes> newFault) {
        fault = newFault;
    }

    /** Loses the requests whose message the predicate names. */
    public synchronized void setLoses(Predicate<Bytes> lost) {
        loses = lost;
    }

    /** Loses so many of the host's writes. */
    public synchronized void setDeaf(int writes) {
        deaf = writes;
    }

    /** Runs the boot loader, which waits for a sketch, until its end. */
    public synchronized void setLoading() {
        loading = true;
    }

    /** How often a boot loader was told to leave, whether one runs or not. */
    public synchronized int bootLoaderQuestions() {
        return bootLoaderQuestions;
    }

    /** Halts each reading that a poll with a hold brings before its end, until the host sends something. */
    public synchronized void setHaltsReadings(boolean halts) {
        haltsReadings = halts;
    }

    /** Answers polls with half a record. */
    public synchronized void setBadPolls(boolean bad) {
        badPolls = bad;
    }

    /** The messages of all requests that came, without repeats, in hexadecimal digits. */
    public synchronized List<String> messages() {
        return messages.stream().map(Bytes::hex).toList();
    }

    /** How many requests with this command came, without repeats. */
    public synchronized long count(char command) {
        return messages.stream().filter(message -> message.length() > 0 && message.at(0) == command).count();
    }

    /** Waits for so many further polls. */
    public synchronized void awaitPolls(int more) throws InterruptedException {
        int wanted = polls + more;
        while (polls < wanted) {
            wait();
        }
    }

    /** Waits until a poll is held. */
    public synchronized void awaitHeld() throws InterruptedException {
        while (held == null) {
            wait();
        }
    }
}
