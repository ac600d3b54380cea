package javino.board;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.PollReply;
import javino.protocol.HostMessage;

/** Keeps all that it is told, as lines such as {@code message ROMA tell;help}. */
final class RecordingListener implements BoardListener {

    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();

    @Override
    public void online(BoardInfo info) {
        lines.add("online " + info.bootEpoch());
    }

    @Override
    public void offline(String why) {
        lines.add("offline " + why);
    }

    @Override
    public void percepts(List<String> literals) {
        lines.add("percepts " + literals);
    }

    @Override
    public void message(ReceivedMessage message) {
        lines.add("message " + message.from() + " " + message.content());
    }

    @Override
    public void hostMessage(Address from, Address to, HostMessage message) {
        lines.add("host message " + from + " " + to + " " + message.encode());
    }

    @Override
    public void noKey(PollReply.NoKey frame) {
        lines.add("no key " + frame.destination() + " " + frame.origin());
    }

    @Override
    public void overheard(PollReply.Overheard packet) {
        lines.add("overheard " + packet.millis() + " " + packet.how() + " " + packet.payload().hex());
    }

    @Override
    public void printed(String text) {
        lines.add("printed " + text);
    }

    @Override
    public void warning(String what) {
        lines.add("warning " + what);
    }

    @Override
    public void timerTaken(int timer, String what) {
        lines.add("timer " + timer);
        BoardListener.super.timerTaken(timer, what);
    }

    /** Adds a line of a test's own. */
    void note(String line) {
        lines.add(line);
    }

    /** The next line, for which it waits. */
    String next() throws InterruptedException {
        return lines.take();
    }

    /** Waits for a line that begins so, and gives those before it with it. */
    List<String> until(String start) throws InterruptedException {
        List<String> seen = new ArrayList<>();
        do {
            seen.add(lines.take());
        } while (!seen.get(seen.size() - 1).startsWith(start));
        return seen;
    }

    /** The lines that are there and were not taken. */
    List<String> rest() {
        List<String> rest = new ArrayList<>();
        lines.drainTo(rest);
        return rest;
    }
}
