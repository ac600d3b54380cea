package simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;

/** Hears all, and says what he likes in whosoever name: forged, replayed, reflected, mixed. He has no certificate. */
public final class Attacker {

    private static final int MOST = 400;
    private static final int MOST_NOISE = 40;

    private final Random random;
    private final List<HeardMessage> heard = new ArrayList<>();
    private final List<Address> names;
    private final Voice voice;

    /** How his words come to be on the air. */
    public interface Voice {

        /** Says a word to all in somebody's name; or to somebody noise, as if it were sealed. */
        void say(Address from, Address to, Bytes word);
    }

    private record HeardMessage(Address from, Bytes word) {
    }

    /** @param names in which he speaks, and to whom. */
    public Attacker(Random random, List<Address> names, Voice voice) {
        this.random = random;
        this.names = names;
        this.voice = voice;
    }

    /** He hears a word. */
    public void hear(Address from, Bytes word) {
        if (heard.size() < MOST) {
            heard.add(new HeardMessage(from, word));
        }
    }

    /** Sends one message. */
    public void act() {
        Address victim = pick(names);
        Address name = random.nextInt(4) == 0 ? new Address(random.nextInt(0xF00000)) : pick(names);
        switch (random.nextInt(heard.isEmpty() ? 2 : 6)) {
            case 0 -> forge(name, victim);
            case 1 -> voice.say(name, victim, noise(random.nextInt(MOST_NOISE)));
            case 2 -> replay(pick(heard));
            case 3 -> reflect(pick(heard));
            case 4 -> change(pick(heard));
            default -> mix(pick(heard), pick(heard));
        }
    }

    private void broadcast(Address from, Bytes word) {
        voice.say(from, Address.BROADCAST, word);
    }

    private <T> T pick(List<T> from) {
        return from.get(random.nextInt(from.size()));
    }

    private Bytes noise(int length) {
        byte[] bytes = new byte[length];
        random.nextBytes(bytes);
        return Bytes.copyOf(bytes);
    }

    private static Bytes address(Address address) {
        return Bytes.ofNumber(address.value(), 3);
    }

    private void forge(Address name, Address victim) {
        Kind[] plain = {Kind.MESSAGE_1, Kind.MESSAGE_2, Kind.MESSAGE_3, Kind.RENEWAL_1, Kind.RENEWAL_2,
                Kind.RENEWAL_3, Kind.WANT};
        Kind kind = plain[random.nextInt(plain.length)];
        Bytes body = kind == Kind.WANT ? Bytes.of(plain[random.nextInt(plain.length)].first(), random.nextInt(2))
                : noise(kind.length());
        broadcast(name, pick(HostMessage.fragments(kind, victim, body)).encode());
    }

    private void replay(HeardMessage each) {
        broadcast(each.from, each.word);
    }

    /** Back to whoever said it, in the name of whom it was for, or of somebody of those. */
    private void reflect(HeardMessage each) {
        Address to = new Address((int) each.word.number(1, 4));
        broadcast(to.kind() == Address.Kind.DEVICE ? to : pick(names),
                Bytes.join(each.word.slice(0, 1), address(each.from), each.word.from(4)));
    }

    private void change(HeardMessage each) {
        byte[] bytes = each.word.toArray();
        bytes[1 + random.nextInt(bytes.length - 1)] ^= (byte) (1 << random.nextInt(8));
        broadcast(each.from, Bytes.copyOf(bytes));
    }

    /** The one's words in the other's name, to another. */
    private void mix(HeardMessage one, HeardMessage other) {
        broadcast(other.from, Bytes.join(one.word.slice(0, 1), other.word.slice(1, 4), one.word.from(4)));
    }
}
