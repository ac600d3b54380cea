package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import gateway.TwoCells;
import harness.Mosquitto;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javino.board.ReceivedMessage;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Frame;
import javino.protocol.Payload;
import javino.protocol.ProtocolException;
import javino.vectors.Crypto;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The table of rights once more, with each act sealed in one cell and opened in another: gateways and a broker are
 * between them, and nobody can do more or less by these.
 */
class RightsThroughGatewaysTest {

    /** One pair of cells has a quarter of its air for this, and acts come faster. */
    private static final int PAIRS = 32;
    private static final int MOST_PACKET = 77;
    private static final int ATTEMPTS = 12;
    private static final long PATIENCE_MILLIS = 4000;
    private static final Bytes ENCRYPTION = Bytes.copyOf(Crypto.kdf(TestKeys.PAIR, "JavinoEnc"));
    private static final Bytes AUTHENTICATION = Bytes.copyOf(Crypto.kdf(TestKeys.PAIR, "JavinoMac"));

    private final List<TwoCells> pairs = new ArrayList<>();
    private final Set<Bytes> said = new HashSet<>();
    private int acts;
    private int lost;
    private long nonce;

    @AfterEach
    void close() {
        pairs.forEach(TwoCells::close);
    }

    @Test
    @Tag("verify")
    void cells_thatCoverThroughGateways_haveTheEffectsOfTheirRights(@TempDir Path folder) throws Exception {
        check(RightsTest.chosen(), folder);
    }

    @Test
    @Tag("soak")
    void cells_allThroughGateways_haveTheEffectsOfTheirRights(@TempDir Path folder) throws Exception {
        check(RightsTest.possible(), folder);
    }

    private void check(List<RightsTest.Cell> cells, Path folder) throws Exception {
        try (Mosquitto broker = Mosquitto.start(folder)) {
            for (int i = 0; i < PAIRS; i++) {
                pairs.add(new TwoCells("mqtts://localhost:" + broker.port(), broker.ca(), Mosquitto.OWNER,
                        Mosquitto.PASSWORD, "pair" + i));
                pairs.get(i).answer(new Frame(Address.BROADCAST, Victim.SELF, Bytes.ofText("tell;here")).encode());
            }
            RightsTest.check(cells, this::carry);
            long byRadio = cells.stream().filter(cell -> cell.who() != RightsTest.Who.GUEST).count();
            System.out.println(acts + " acts through gateways, " + lost + " of them repeated");
            assertEquals(byRadio, acts);
        }
    }

    /** Carries an act from its sender's board to the other's, by the next pair of cells. */
    private ReceivedMessage carry(ReceivedMessage act) {
        try {
            TwoCells cells = pairs.get(acts++ % PAIRS);
            for (int attempt = 1; attempt <= ATTEMPTS; attempt++) {
                List<Bytes> packets = packets(onAir(act));
                if (comes(cells, packets)) {
                    return opened(packets);
                }
                lost++;
            }
            throw new AssertionError(act + " did not come to the other cell");
        } catch (InterruptedException | ProtocolException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Whether all packets are on the air of the other cell, where nothing is that was not said in this one. */
    private boolean comes(TwoCells cells, List<Bytes> packets) throws InterruptedException {
        Set<Bytes> missing = new HashSet<>(packets);
        said.addAll(packets);
        packets.forEach(cells::say);
        long end = System.nanoTime() + PATIENCE_MILLIS * 1_000_000;
        while (!missing.isEmpty() && System.nanoTime() < end) {
            cells.relayed(PATIENCE_MILLIS / 10).ifPresent(packet -> {
                assertTrue(said.contains(packet), () -> "nobody has said " + packet.hex());
                missing.remove(packet);
            });
        }
        return missing.isEmpty();
    }

    // The work of the sender's board (SPEC 5 and 7.1)

    private Bytes onAir(ReceivedMessage act) {
        Bytes content = Bytes.ofText(act.content().toString());
        if (act.to().equals(Address.BROADCAST)) {
            return new Frame(act.to(), act.from(), content).encode();
        }
        Bytes drawn = Bytes.ofNumber(++nonce, Payload.NONCE_LENGTH);
        byte[] iv = iv(act.from(), act.to(), drawn);
        Bytes crypt = Bytes.copyOf(Crypto.cfb(ENCRYPTION.toArray(), iv, content.toArray()));
        Bytes untagged = new Frame(act.to(), act.from(),
                Bytes.join(drawn, crypt, Bytes.copyOf(new byte[Payload.TAG_LENGTH]))).encode();
        Bytes signed = untagged.slice(0, untagged.length() - Payload.TAG_LENGTH);
        return Bytes.join(signed, tag(signed));
    }

    private static byte[] iv(Address origin, Address destination, Bytes nonce) {
        return Crypto.aes(ENCRYPTION.toArray(), Bytes.join(Bytes.ofText("" + origin + destination), nonce,
                Bytes.of(0, 0)).toArray());
    }

    private static Bytes tag(Bytes signed) {
        return Bytes.copyOf(Crypto.cmac(AUTHENTICATION.toArray(), signed.toArray())).slice(0, Payload.TAG_LENGTH);
    }

    private static List<Bytes> packets(Bytes frame) throws ProtocolException {
        List<Bytes> packets = new ArrayList<>();
        if (frame.length() <= MOST_PACKET) {
            return List.of(frame);
        }
        Address origin = Address.decode(frame, Address.LENGTH);
        for (int at = 0; at < frame.length(); at += Payload.PART_LENGTH) {
            packets.add(new Frame(Address.fragment(0, packets.size()), origin,
                    frame.slice(at, Math.min(frame.length(), at + Payload.PART_LENGTH))).encode());
        }
        return packets;
    }

    // The work of the receiver's board

    private static ReceivedMessage opened(List<Bytes> packets) throws ProtocolException {
        Bytes frame = packets.size() == 1 ? packets.get(0)
                : Bytes.join(packets.stream().map(each -> each.from(Frame.HEADER_LENGTH)).toArray(Bytes[]::new));
        Address to = Address.decode(frame, 0);
        Address from = Address.decode(frame, Address.LENGTH);
        Bytes message = frame.from(Frame.HEADER_LENGTH);
        if (to.equals(Address.BROADCAST)) {
            return new ReceivedMessage(from, to, 0, Content.parse(message.text()));
        }
        int end = message.length() - Payload.TAG_LENGTH;
        assertTrue(message.from(end).isSame(tag(frame.slice(0, frame.length() - Payload.TAG_LENGTH))), "the tag");
        Bytes content = message.slice(Payload.NONCE_LENGTH, end);
        // The other way round, each block's pad comes from the block before it, which is known.
        byte[] input = iv(from, to, message.slice(0, Payload.NONCE_LENGTH));
        byte[] plain = content.toArray();
        for (int at = 0; at < plain.length; at += input.length) {
            byte[] pad = Crypto.aes(ENCRYPTION.toArray(), input);
            input = Arrays.copyOfRange(content.toArray(), at, at + pad.length);
            for (int i = at; i < Math.min(plain.length, at + pad.length); i++) {
                plain[i] ^= pad[i - at];
            }
        }
        return new ReceivedMessage(from, to, 0, Content.parse(Bytes.copyOf(plain).text()));
    }
}
