package bench;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.util.List;

/** Packets lost on damaged lines. */
final class DecoderLoss implements Subject {

    @Override
    public String name() {
        return "loss";
    }

    @Override
    public String method() {
        return """
            1000 packets of 40 random bytes in each condition, the same lines for both receivers, on the PC
            (`bench/native/loss.cpp`): the modem of the firmware on a simulated timer, and the sampled receiver that the
            firmware's tests compare it with (VirtualWire's algorithm, written anew;
            `test/firmware/radio/support/SampledReceiver.h`).""";
    }

    @Override
    public List<Row> measure() throws Exception {
        return Command.run(Machine.program("loss")).stream()
                .map(line -> row(JsonParser.parseString(line).getAsJsonObject())).toList();
    }

    private static Row row(JsonObject result) {
        return Row.against("lost of " + result.get("packets").getAsInt() + ": " + result.get("condition").getAsString(),
                "%.0f",
                result.get("oursLost").getAsInt(), result.get("sampledLost").getAsInt(), "sampled");
    }
}
