package capture;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Map;
import javino.JavinoException;
import javino.Printable;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.cli.Await;
import javino.cli.CommandPlugin;
import javino.cli.Overhearing;
import javino.cli.UntilInterrupted;
import javino.link.LinkOpener;
import javino.link.SerialLink;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code javino capture}: shows or writes all packets on the air. */
@Command(name = "capture", description = {
        "Shows all packets that a board hears, whoever they are for, until Ctrl-C; or those of an emulator's trace.",
        "With --write it writes them for Wireshark, as pcapng. It needs no key and reads nothing that is sealed. The "
                + "board needs no address, and its radio stays as it is."})
public final class CaptureCommand implements CommandPlugin {

    private static final String STANDARD_OUTPUT = "-";
    private static final int COUNT_INTERVAL_MILLIS = 1000;

    @Option(names = "--port", paramLabel = "PORT",
            description = "The board's serial port, such as /dev/ttyACM0 or COM5.")
    private String port;

    @Option(names = "--trace", paramLabel = "FILE",
            description = "The trace of the emulator, such as build/trace.jsonl: what each board sent and received.")
    private Path trace;

    @Option(names = "--write", paramLabel = "FILE",
            description = "Write a pcapng file; - for the standard output, as in: javino capture --port P --write - | "
                    + "wireshark -k -i -")
    private Path write;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, IOException {
        check(port == null == (trace != null), "capture takes either --port PORT, for a board, or --trace FILE");
        check(write == null || trace == null || !Files.exists(write) || !Files.isSameFile(write, trace),
                "--write would overwrite the trace");
        if (trace != null) {
            copyTrace();
        } else {
            UntilInterrupted.run(() -> listen(SerialLink.opener(port)));
        }
        return 0;
    }

    private void check(boolean right, String otherwise) {
        if (!right) {
            throw new ParameterException(spec.commandLine(), otherwise);
        }
    }

    private void copyTrace() throws JavinoException, IOException {
        TraceFile read = TraceFile.read(trace);
        try (Sink sink = sink(0, read.ids())) {
            for (AirPacket packet : read.packets()) {
                sink.packet(packet);
            }
        }
        if (write != null) {
            note(read.packets().size() + " packets written; the trace has no bytes of serial lines");
        }
    }

    private Sink sink(long start, Map<String, String> ids) throws IOException {
        if (write == null) {
            return Sink.lines(spec.commandLine().getOut(), start);
        }
        OutputStream out = write.toString().equals(STANDARD_OUTPUT) ? new FileOutputStream(FileDescriptor.out)
                : Files.newOutputStream(write);
        return Sink.file(new Pcapng(out,
                "javino " + CaptureCommand.class.getPackage().getImplementationVersion()), ids);
    }

    private void listen(LinkOpener link) throws JavinoException, IOException, InterruptedException {
        String name = link.name().substring(link.name().lastIndexOf('/') + 1);
        OverheardPackets ear = new OverheardPackets(name, this::note, CaptureCommand::now);
        try (Board board = Board.open(link, BoardConfig.create(), ear)) {
            BoardInfo info = Await.result(board, board.greeted());
            try (Sink sink = sink(now(), info.rfId().map(id -> Map.of(name, id.toString())).orElse(Map.of()))) {
                ear.to(sink);
                Overhearing.begin(board, link.name());
                try {
                    awaitEnd(board, ear);
                    refuseLoss();
                } finally {
                    ear.end();
                    Overhearing.end(board);
                }
            }
        }
    }

    /** A file that takes no more is an error; who reads from a pipe or a terminal may go. */
    private void refuseLoss() throws JavinoException {
        if (write != null && !write.toString().equals(STANDARD_OUTPUT)) {
            throw new JavinoException(write + ": nothing more can be written; is the disk full?");
        }
    }

    /** Tells what the board could not tell, until the user ends it, or who reads the packets has gone. */
    private void awaitEnd(Board board, OverheardPackets ear) throws InterruptedException {
        long dropped = dropped(board);
        while (!ear.awaitBroken(COUNT_INTERVAL_MILLIS)) {
            long now = dropped(board);
            if (now > dropped) {
                note((now - dropped) + " packets are missing: the board had no memory left for them");
            }
            dropped = now;
        }
    }

    private static long dropped(Board board) throws InterruptedException {
        try {
            return Await.result(board, board.statistics()).getOrDefault(Counter.RADIO_OVERHEARD_DROPPED, 0L);
        } catch (JavinoException e) {
            // The ear was told why; a board that has started again has counted nothing.
            return 0;
        }
    }

    private static long now() {
        return ChronoUnit.MICROS.between(Instant.EPOCH, Instant.now());
    }

    /** Not to the standard output, which may be the capture itself. */
    private void note(String what) {
        spec.commandLine().getErr().println("capture: " + Printable.of(what));
        spec.commandLine().getErr().flush();
    }
}
