package campaign;

import harness.Emulator;
import harness.Host;
import harness.Report;
import harness.Table;
import harness.TestKeys;
import harness.MovingAgents;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javino.protocol.Content;
import javino.protocol.Performative;

/** How long moves of agents of several sizes take, and what of the air: one pair, where nothing else is sent. */
final class MoveSizes {

    private static final List<Integer> SIZES = List.of(200, 1000, 2000, 5000, 20_000);
    private static final int AIM_SIZE = 2000;
    private static final double AIM_SECONDS = 20;
    private static final double AGAIN_SECONDS = 5;
    private static final int PLAIN_LENGTH = 480;
    private static final int PLAIN_MESSAGES = 4;
    /** It moves there, back, and there again. */
    private static final String WALKER = """
            +!begin <- !go("@THERE@"); !go("@HERE@"); !go("@THERE@").
            +!go(To) <- .wait(2000); .print("leaves"); .moveOut(To, mutualism); .print("arrived").
            """;

    private final AirUsage air = new AirUsage();
    private EmulatedTime time;

    /** A time, and what was sent until then. */
    private record Moment(double seconds, AirUsage.Sum air) {

        /** The time and the packets between this and a later one. */
        Moment until(Moment end) {
            return new Moment(end.seconds - seconds,
                    new AirUsage.Sum(end.air.packets() - air.packets(), end.air.seconds() - air.seconds()));
        }
    }

    /**
     * One size.
     *
     * @param program bytes of AgentSpeak that the agent was started with.
     * @param text    bytes of text that it has when it has arrived.
     * @param legs    its three moves.
     */
    private record Measured(int program, long text, List<Moment> legs) {
    }

    void run(Settings settings, Report report) throws Exception {
        List<Integer> sizes = settings.choose(SIZES, List.of(200));
        List<Field.Cell> cells = Collections.nCopies(sizes.size(), new Field.Cell("Station", 2));
        List<Measured> all = new ArrayList<>();
        Moment plain;
        try (Closing closing = new Closing()) {
            Field field = closing.add(Field.start(new Emulator.Scenario().seed(settings.seed()).listener(air)
                    .discardEvents().inEmulatedTime(), cells, report));
            time = new EmulatedTime();
            for (int cell = 0; cell < sizes.size(); cell++) {
                String walker = WALKER + AgentTexts.of(settings.root(), sizes.get(cell) - WALKER.length());
                all.add(measure(field, cell, walker));
                report.progress("an agent of %d bytes was carried three times: %s", walker.length(),
                        all.get(cell).legs().stream().map(leg -> seconds(leg.seconds)).toList());
            }
            plain = plain(field);
        }
        describe(all, plain, report);
    }

    private Moment now(List<Field.Post> posts) {
        return new Moment(time.now(), air.of(posts));
    }

    private Measured measure(Field field, int cell, String walker) throws IOException, InterruptedException {
        List<Field.Post> posts = field.cell(cell);
        List<Moment> moments = new ArrayList<>();
        Path folder = field.folder().resolve("size" + cell);
        try (MovingAgents travels =
                new MovingAgents(field.emulator(), folder, posts.stream().map(Field.Post::name).toList(),
                        posts.stream().map(Field.Post::address).toList(), List.of(true, true), walker, line -> {
                            if (line.contains("] leaves") || line.contains("] arrived")) {
                                moments.add(now(posts));
                            }
                        })) {
            travels.start(MovingAgents.AWAY);
            travels.start(MovingAgents.HOME);
            travels.await("arrivals", 1, line -> line.contains("] arrived"));
            long text = size(travels.place(MovingAgents.AWAY).resolve("moves/parts"));
            travels.await("arrivals", 3, line -> line.contains("] arrived"));
            return new Measured(walker.length(), text, List.of(moments.get(0).until(moments.get(1)),
                    moments.get(2).until(moments.get(3)), moments.get(4).until(moments.get(5))));
        }
    }

    private static long size(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.mapToLong(file -> file.toFile().length()).sum();
        }
    }

    /** The cost of one unicast of plain text. */
    private Moment plain(Field field) throws InterruptedException {
        Field.Post from = field.cell(0).get(0);
        Field.Post to = field.cell(0).get(1);
        try (Host sender = Host.of(field.emulator(), from.name());
                Host receiver = Host.of(field.emulator(), to.name())) {
            sender.as(from.address().toString(), Map.of(to.address().toString(), TestKeys.PAIR));
            receiver.as(to.address().toString(), Map.of(from.address().toString(), TestKeys.PAIR));
            Moment begun = now(field.cell(0));
            Content bytes = new Content(Performative.TELL, "x".repeat(PLAIN_LENGTH));
            for (int i = 0; i < PLAIN_MESSAGES; i++) {
                Host.get(sender.board.transmit(to.address(), bytes).end());
            }
            Moment all = begun.until(now(field.cell(0)));
            return new Moment(all.seconds / PLAIN_MESSAGES,
                    new AirUsage.Sum(all.air.packets() / PLAIN_MESSAGES, all.air.seconds() / PLAIN_MESSAGES));
        }
    }

    private static void describe(List<Measured> all, Moment plain, Report report) {
        report.text("""
            **Time and air.** One pair, in clean air where nothing else is sent. An agent of so many bytes of AgentSpeak
            (programs of this repository without their comments, beyond 9 kB a second and a third time with other names)
            moves there, back, and there again: *first visit*, *back* and *second visit*. Emulated time from
            `.moveOut` to the next step of its plan. *Text* is what travels, program and state, before it is packed.
            *Air* is what both boards send, acknowledgements included. *Plain* is what unicasts of %d bytes of that text
            as it is would take: one takes %.1f s and %.2f s of air.
            """.formatted(PLAIN_LENGTH, plain.seconds, plain.air.seconds()));
        Table table = new Table("AgentSpeak, bytes", "text, bytes", "first visit", "back", "second visit", "air, first",
                "air, back", "air, second", "plain", "air, plain");
        for (Measured each : all) {
            List<Object> row = new ArrayList<>(List.of(each.program, each.text));
            each.legs.forEach(leg -> row.add(seconds(leg.seconds)));
            each.legs.forEach(leg -> row.add(seconds(leg.air.seconds())));
            double messages = (double) each.text / PLAIN_LENGTH;
            row.add(seconds(messages * plain.seconds));
            row.add(seconds(messages * plain.air.seconds()));
            table.row(row.toArray());
        }
        report.table(table);
        all.stream().filter(each -> each.program >= AIM_SIZE).findFirst().ifPresent(each -> {
            report.claim("an agent of " + each.program + " bytes arrives after", seconds(each.legs.get(0).seconds),
                    "second visit: " + seconds(each.legs.get(2).seconds));
            report.aim("an agent of 2 kB arrives within 20 s", each.legs.get(0).seconds <= AIM_SECONDS);
            report.aim("its second visit takes at most 5 s", each.legs.get(2).seconds <= AGAIN_SECONDS);
        });
    }

    private static String seconds(double value) {
        return Table.text("%.1f s", value);
    }
}
