package fuzz;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javino.protocol.Bytes;
import javino.protocol.PacketDecoder;
import javino.protocol.PacketDecoder.Found;
import javino.protocol.PacketDecoder.Refused;
import javino.protocol.PacketDecoder.Result;

/**
 * Bytes of a serial line, the first one the size of the chunks in which they come: what is found does not depend on
 * that, and comes out again when it is encoded.
 */
public final class PacketDecoderTarget {

    private PacketDecoderTarget() {
    }

    public static void fuzzerTestOneInput(byte[] data) {
        if (data.length == 0) {
            return;
        }
        byte[] line = Arrays.copyOfRange(data, 1, data.length);
        List<String> whole = describe(feed(line, line.length));
        Holds.equal(whole, describe(feed(line, 1 + (data[0] & 0xFF))), "the same in chunks");
        Holds.equal(whole, describe(feed(line, 1)), "the same byte by byte");
        feed(line, line.length).forEach(PacketDecoderTarget::checkRoundTrip);
    }

    private static List<Result> feed(byte[] line, int chunk) {
        PacketDecoder decoder = new PacketDecoder();
        List<Result> results = new ArrayList<>();
        for (int at = 0; at < line.length; at += chunk) {
            byte[] part = Arrays.copyOfRange(line, at, Math.min(line.length, at + chunk));
            results.addAll(decoder.feed(part, part.length));
        }
        return results;
    }

    private static List<String> describe(List<Result> results) {
        return results.stream().map(result -> result instanceof Refused refused
                ? refused.cause().getMessage() : ((Found) result).packet().toString()).toList();
    }

    private static void checkRoundTrip(Result result) {
        if (result instanceof Found found) {
            Bytes encoded = found.packet().encode();
            Holds.equal(List.of(result), feed(encoded.toArray(), encoded.length()), "packet");
        }
    }
}
