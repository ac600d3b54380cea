package fuzz;

import java.util.List;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.PollReply;
import javino.protocol.PollReply.Message;
import javino.protocol.PollReply.Percept;
import javino.protocol.PollReply.Transmission;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;

/** A board's answer, read as the answer to each request; what a poll brings accounts for every byte of it. */
public final class ReplyTarget {

    private static final int FLAGS = 7;

    /** One way to read the body of an answer. */
    private interface Reader {
        Object read(Reply reply) throws ProtocolException;
    }

    private static final List<Reader> READERS = List.of(Reply::boardInfo, Reply::checkValue, Reply::storedKeys,
            Reply::statistics, Reply::transmissionNumber, reply -> {
                reply.nothing();
                return null;
            });

    private ReplyTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) {
        if (data.length > Frame.MAX_MESSAGE_LENGTH) {
            return;
        }
        Frame frame = new Frame(Address.SERIAL, Address.SERIAL, Bytes.copyOf(data));
        try {
            Reply reply = Reply.decode(frame);
            READERS.forEach(reader -> read(reader, reply));
            PollReply poll = reply.poll();
            Bytes flags = Bytes.of(reply.body().at(0) & FLAGS);
            Holds.equal(Bytes.join(flags, reply.body().from(1)), encode(poll), "poll reply");
        } catch (ProtocolException e) {
            Holds.always(e.error() != null, "a refusal says why");
        }
    }

    private static void read(Reader reader, Reply reply) {
        try {
            reader.read(reply);
        } catch (ProtocolException e) {
            Holds.always(e.error() != null, "a refusal says why");
        }
    }

    private static Bytes encode(PollReply poll) {
        Bytes flags = Bytes.of((poll.more() ? 1 : 0) | (poll.leftOut() ? 2 : 0) | (poll.reading() ? 4 : 0));
        return poll.records().stream().map(ReplyTarget::encode).reduce(flags, Bytes::join);
    }

    private static Bytes encode(PollReply.Item item) {
        if (item instanceof Percept percept) {
            return record('P', percept.literal());
        }
        if (item instanceof Transmission transmission) {
            return record('T', Bytes.of(transmission.number(), transmission.outcome().ordinal()));
        }
        Message message = (Message) item;
        return record('M', Bytes.join(Bytes.of(message.number()), message.destination().toBytes(),
                message.origin().toBytes(), Bytes.ofNumber(message.id(), 3), message.content()));
    }

    private static Bytes record(char type, Bytes value) {
        return Bytes.join(Bytes.of(type), Bytes.ofNumber(value.length(), 2), value);
    }
}
