package mobility;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.zip.Deflater;
import java.util.zip.DeflaterInputStream;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;

import javino.protocol.Bytes;
import javino.protocol.ProtocolException;

/**
 * A text of an agent that travels, as an offer names it (SPEC 9.2).
 *
 * @param hash   8 bytes of SHA-256 of the text in UTF-8.
 * @param packed how many bytes it has when it is packed, 0…16777215.
 * @param length how many bytes of UTF-8 the text has, 0…16777215.
 */
record Part(Bytes hash, int packed, int length) {

    /** The bytes of a hash. */
    static final int HASH_LENGTH = 8;

    /**
     * Texts that AgentSpeak repeats, the most frequent last, as Deflate reaches what is near with fewer bits (SPEC
     * 9.5).
     */
    static final String DICTIONARY = """
            atomic priority(.succeed_goal(.fail_goal(.drop_desire(.drop_intention(.findall(.member(.length(.concat(.nth(
            .min(.max(.random(.time(.date(.my_name(.abolish(.term2string(.broadcast(.suspend.resume
            .infrastructure(.setMyRFId(.getRFMessages(open);.percepts(open).port(".act(.deliver(.diffuse(broadcast,tell,
            achieve,untell,askOne,askAll,signal,.send([error(E),error_msg(Why)][source(percept)][cast(unicast,multicast,
            ",mutualism)",inquilinism)",cloning).moveOut("BBhome("M
            F0,1,+!VFrom,"To," : true : not false & | <- if ({ else { while (for ( mod div == \\== .print("
            ",.wait(1000);.wait(.count(_,_)) <- +-?-+!start<-!
            -!!@l[source(self)],source(""";

    /** The hash of a text. */
    static Bytes hash(Bytes text) {
        return text.sha256().slice(0, HASH_LENGTH);
    }

    /** No text of that length has more bytes when it is packed. */
    static int mostPacked(int length) {
        return length + length / 1000 + 64;
    }

    /** A text, packed. */
    static Bytes pack(Bytes text) {
        Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION, true);
        deflater.setDictionary(dictionary());
        try (var packing = new DeflaterInputStream(new ByteArrayInputStream(text.toArray()), deflater)) {
            return Bytes.copyOf(packing.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            deflater.end();
        }
    }

    /**
     * The text of packed bytes. Takes no more memory than the offer has said.
     *
     * @throws RefusedException damaged, if they are none of this part.
     */
    Bytes unpack(Bytes bytes) throws RefusedException {
        Inflater inflater = new Inflater(true);
        inflater.setDictionary(dictionary());
        try (var unpacking = new InflaterInputStream(new ByteArrayInputStream(bytes.toArray()), inflater)) {
            // With room for one byte more, so that a longer text shows.
            Bytes text = Bytes.copyOf(unpacking.readNBytes(length + 1));
            text.text();
            if (inflater.finished() && text.length() == length && hash(text).equals(hash)) {
                return text;
            }
        } catch (IOException | ProtocolException e) {
            // Bytes that are no packed text are no part either.
        } finally {
            inflater.end();
        }
        throw new RefusedException("damaged", "a part of the agent is not what was offered");
    }

    private static byte[] dictionary() {
        return DICTIONARY.getBytes(StandardCharsets.UTF_8);
    }
}
