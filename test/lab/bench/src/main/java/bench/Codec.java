package bench;

import java.util.Collection;
import java.util.List;
import java.util.concurrent.TimeUnit;

import harness.Table;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.SerialPacket;
import javino.protocol.PacketDecoder;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.openjdk.jmh.runner.options.VerboseMode;

/** The host's codec: a frame of 64 bytes to the packet's bytes on the line and back. */
public final class Codec implements Subject {

    private static final int FRAME_LENGTH = 64;

    /** The exchange that JMH runs. */
    @State(Scope.Thread)
    public static class Exchange {

        private final PacketDecoder decoder = new PacketDecoder();
        private final Frame frame = new Frame(Address.parse("SUPO"), Address.parse("ROMA"),
                Bytes.ofText("x".repeat(FRAME_LENGTH - Frame.HEADER_LENGTH)));
        private int sequence;

        /** One frame there and back. */
        @Benchmark
        public List<PacketDecoder.Result> encodeAndDecode() {
            sequence = sequence + 1 & 0xFF;
            byte[] line = new SerialPacket(sequence, frame).encode().toArray();
            return decoder.feed(line, line.length);
        }
    }

    @Override
    public String name() {
        return "codec";
    }

    @Override
    public String method() {
        return """
            JMH, one thread: `SerialPacket.encode` and `PacketDecoder.feed` of a frame of 64 bytes, checksums and COBS
            included; a fork with 3 rounds of warming up and 5 of measuring, 2 s each, allocation by its GC
            profiler.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        Collection<RunResult> results = new Runner(new OptionsBuilder()
                .include(Exchange.class.getName().replace('$', '.') + ".encodeAndDecode")
                .forks(1).warmupIterations(3).warmupTime(TimeValue.seconds(2)).measurementIterations(5)
                .measurementTime(TimeValue.seconds(2))
                .timeUnit(TimeUnit.SECONDS).addProfiler(GCProfiler.class).verbosity(VerboseMode.SILENT).build()).run();
        RunResult result = results.iterator().next();
        double allocated = result.getSecondaryResults().get("gc.alloc.rate.norm").getScore();
        return List.of(
                Row.of("host codec, encode and decode 64 bytes",
                        Table.text("%.2f M frames/s", result.getPrimaryResult().getScore() / 1e6)).goal("≥ 1"),
                Row.of("the same, allocated", Table.text("%.0f bytes a frame", allocated)));
    }
}
