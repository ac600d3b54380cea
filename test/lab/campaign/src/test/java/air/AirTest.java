package air;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Table;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import javax.xml.parsers.DocumentBuilderFactory;
import javino.protocol.Airtime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;

/** The air as {@code gradle air} sees it, in small traces whose collisions are known. */
class AirTest {

    private static final double BIT = 1 / 2000.0;
    private static final double SLOT = 16 * BIT;
    /** The bits of a payload of 24 bytes. */
    private static final int BITS = Airtime.bits(24);
    private static final double LENGTH = (BITS - 1) * BIT;

    @TempDir
    private Path folder;

    private final List<String> lines = new ArrayList<>();
    private int payloads;

    /** A packet, and the boards in range; those with a minus before their names get it damaged. */
    private AirTest send(String board, double start, String... boards) {
        return sendAs(board, start, Table.text("\"kind\":\"unicast\",\"payload\":\"%048x\"", payloads++), boards);
    }

    private AirTest sendAs(String board, double start, String fields, String... boards) {
        return sendBits(board, start, BITS, fields, boards);
    }

    private AirTest sendBits(String board, double start, int bits, String fields, String... boards) {
        double end = start + (bits - 1) * BIT;
        for (String heard : boards) {
            boolean damaged = heard.startsWith("-");
            line("\"t\":%f,\"board\":\"%s\",\"event\":\"%s\",\"from\":\"%s\",\"start\":%f,\"end\":%f", start + LENGTH,
                    heard.substring(damaged ? 1 : 0), damaged ? "rf-damaged" : "rf-rx", board, start + 0.00011,
                    start + LENGTH);
        }
        return line("\"t\":%f,\"board\":\"%s\",\"event\":\"rf-tx\",\"destination\":\"SUPP\",\"origin\":\"SUPO\",%s,"
                + "\"bits\":%d,\"start\":%f,\"end\":%f", end, board, fields, bits, start, end);
    }

    private AirTest overlap(String board, double seconds, String sources) {
        return line("\"t\":%f,\"board\":\"%s\",\"event\":\"rf-collision\",\"boards\":[%s]", seconds, board, sources);
    }

    private AirTest line(String format, Object... values) {
        lines.add("{" + Table.text(format, values) + "}");
        return this;
    }

    private Path file() throws IOException {
        return Files.write(folder.resolve("trace.jsonl"), lines);
    }

    private List<Packet> packets() throws IOException {
        AirTrace trace = AirTrace.read(file());
        List<Packet> packets = trace.packets();
        Causes.find(packets, trace.jams());
        return packets;
    }

    private List<Cause> causes() throws IOException {
        return packets().stream().map(packet -> packet.cause).toList();
    }

    private static List<Cause> list(Cause... causes) {
        return Arrays.asList(causes);
    }

    @Test
    void beginning_lessThanASlotAfterAnother_isInTheSameSlot() throws IOException {
        send("a", 1, "-b", "-c").send("b", 1 + 0.99 * SLOT, "-a", "-c");
        assertEquals(list(null, Cause.SAME_SLOT), causes());
    }

    @Test
    void beginning_atTheSameTime_isToldOfOneOfThem() throws IOException {
        send("b", 1, "-a", "-c").send("a", 1, "-b", "-c");
        assertEquals(1, causes().stream().filter(Cause.SAME_SLOT::equals).count());
    }

    @Test
    void beginning_aSlotLater_couldHaveBeenPutOff() throws IOException {
        send("a", 1, "-b", "-c").send("b", 1 + 1.01 * SLOT, "-a", "-c");
        assertEquals(list(null, Cause.MISSED), causes());
    }

    @Test
    void beginning_outOfTheOthersRange_isHidden() throws IOException {
        send("a", 1, "-b").send("c", 1.1, "-b");
        assertEquals(list(null, Cause.HIDDEN), causes());
    }

    @Test
    void beginning_whereNobodyHearsBoth_isNoCollision() throws IOException {
        send("a", 1, "b").send("c", 1.1, "d");
        assertEquals(list(null, null), causes());
        assertTrue(packets().stream().allMatch(packet -> packet.met.isEmpty()));
    }

    @Test
    void beginning_afterItsSenderSentBesideTheOthersBeginning_isBecauseOfThat() throws IOException {
        send("a", 1, "-b", "-c").send("b", 1 + LENGTH - SLOT, "-a", "-c").send("a", 1 + LENGTH + 2 * SLOT, "-b", "-c");
        assertEquals(list(null, Cause.MISSED, Cause.OWN), causes());
    }

    @Test
    void beginning_afterTwoTogether_couldNotMakeOutEither() throws IOException {
        send("a", 1, "-b", "-c").send("b", 1 + 2 * BIT, "-a", "-c").send("c", 1.1, "-a", "-b");
        assertEquals(list(null, Cause.SAME_SLOT, Cause.BURIED), causes());
    }

    @Test
    void beginning_onlyAfterwards_isNoCollision() throws IOException {
        send("a", 1, "b", "c").send("b", 1 + LENGTH + BIT, "a", "c");
        assertEquals(list(null, null), causes());
    }

    @Test
    void damage_withoutAnother_isOfNoiseOrAJamOrAPacketThatWasBrokenOff() throws IOException {
        line("\"t\":2.9,\"event\":\"fault\",\"do\":\"jam\",\"until\":4").send("a", 1, "-b", "c").send("a", 3, "-b", "c")
                .overlap("b", 3.0001, "\"a\",\"jam\"").overlap("c", 3.0001, "\"a\",\"jam\"").send("a", 5, "-b", "c")
                .overlap("b", 5.1, "\"a\",\"c\"").send("a", 7, "b").overlap("b", 7.1, "\"a\",\"jam\"")
                .send("a", 9, "-b", "c").overlap("c", 9.1, "\"a\",\"jam\"");
        assertEquals(list(Cause.NOISE, Cause.JAM, Cause.UNFINISHED, null, Cause.NOISE), causes());
    }

    @Test
    void quiet_isCountedFromWhatTheSenderCouldHear() throws IOException {
        send("a", 1, "b", "c").send("x", 1.1, "c").send("b", 1 + LENGTH + 7.5 * SLOT, "a", "c")
                .send("a", 1 + LENGTH + 7.75 * SLOT, "b", "c");
        List<Packet> packets = packets();
        assertTrue(Double.isNaN(packets.get(0).quietSlots));
        assertTrue(Double.isNaN(packets.get(1).quietSlots));
        assertEquals(7.5, packets.get(2).quietSlots, 1e-3);
        assertEquals(7.75, packets.get(3).quietSlots, 1e-3);
    }

    @Test
    void kind_isToldByWhatWasSentBefore() throws IOException {
        String fragment = "\"kind\":\"fragment\",\"id\":3,\"index\":%d,\"payload\":\"%s\"";
        String head = "2b46444153555050" + "4141";
        sendAs("a", 1, "\"kind\":\"unicast\",\"payload\":\"0011\"")
                .sendAs("a", 2, "\"kind\":\"unicast\",\"payload\":\"0011\"")
                .sendAs("a", 3, Table.text(fragment, 1, head + "77"))
                .sendAs("a", 4, Table.text(fragment, 9, head + "77"))
                .sendAs("a", 5, Table.text(fragment, 2, head + "77"))
                .sendAs("a", 6, "\"kind\":\"acknowledgement\",\"payload\":\"22\"")
                .sendAs("a", 7, "\"kind\":\"acknowledgement\",\"payload\":\"22\"")
                .sendAs("a", 8, "\"kind\":\"broadcast\",\"payload\":\"33\"")
                .sendAs("a", 9, "\"kind\":\"no frame\",\"payload\":\"4\"");
        assertEquals(List.of(Packet.Kind.FIRST, Packet.Kind.REPEAT, Packet.Kind.FRAGMENT, Packet.Kind.REPEAT,
                Packet.Kind.FRAGMENT, Packet.Kind.ACKNOWLEDGEMENT, Packet.Kind.ACKNOWLEDGEMENT, Packet.Kind.TO_MANY,
                Packet.Kind.OTHER), packets().stream().map(packet -> packet.kind).toList());
    }

    @Test
    void trailer_countsToThePacketButIsNotOfItsBody() throws IOException {
        sendBits("a", 1, BITS + 156, Table.text("\"kind\":\"unicast\",\"payload\":\"%048x\",\"trailer\":\"parity\"", 1),
                "b", "-c").send("c", 1 + LENGTH + 20 * BIT, "-b");
        List<Packet> packets = packets();
        assertEquals(1 + LENGTH, packets.get(0).bodyEnd, 1e-6);
        assertEquals(1 + LENGTH + 156 * BIT, packets.get(0).end, 1e-6);
        assertEquals(List.of("c"), packets.get(0).damagedAt);
        assertEquals(Cause.MISSED, packets.get(1).cause);
    }

    @Test
    void figures_haveTheAirOfTheWindowOnly() throws IOException {
        send("a", 1, "-b", "-c").send("b", 1, "-a", "-c").send("c", 1 + LENGTH / 2, "-a", "-b");
        List<Packet> packets = packets();
        AirTrace trace = AirTrace.read(file());
        String text = new Figures(packets, 1 + LENGTH / 4, 1 + 2 * LENGTH).text(trace);
        // The window is 7/4 of a packet long: one or more are on the air for 5/4, two or more for 3/4.
        assertTrue(text.contains("air used: 71.4 % of the time, by more than one at once 42.9 %"), text);
        assertTrue(text.contains("together"), text);
        assertTrue(text.matches("(?s).*a SUPO +42\\.9 % .*c SUPO +57\\.1 % .*"), text);
    }

    @Test
    void picture_isXmlWhateverTheNames_andMarksWhatCollided() throws Exception {
        send("<a&\\u0001\\ud800\\\"", 1, "-b", "-c").send("b", 1 + 2 * BIT, "-<a&\\u0001\\ud800\\\"", "-c").send("c", 3,
                "b");
        line("\"t\":2.5,\"event\":\"fault\",\"do\":\"jam\",\"until\":4");
        Path picture = folder.resolve("new/air.svg");
        String said = said(() -> Main.run("--trace", write(), "--picture", picture.toString()), 0);
        Document svg = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                .parse(new ByteArrayInputStream(Files.readAllBytes(picture)));
        String text = svg.getDocumentElement().getTextContent();
        assertTrue(text.contains("S same slot") && text.contains("✗2"), text);
        assertTrue(Files.readString(picture)
                .matches("(?s).*<rect x='[0-9.]+' y='80' width='[0-9.]+' height='48' fill='#ccc'/>.*"));
        assertTrue(text.contains("collided with that of b, which began 0.12 slots later"), text);
        assertTrue(said.matches("(?s).*S same slot +1 +2 +2…2, median 2\n.*"), said);
    }

    @Test
    void picture_ofALongRun_isOfWhereMostCollidedUnlessToldOtherwise() throws Exception {
        for (int second = 0; second < 100; second++) {
            send("a", second, "b");
        }
        send("b", 60 + BIT, "a");
        Path picture = folder.resolve("air.svg");
        Supplier<String> title = () -> text(picture).lines().filter(line -> line.startsWith("<title>The air"))
                .findFirst().orElse("");
        String said = said(() -> Main.run("--trace", write(), "--picture", picture.toString()), 0);
        assertTrue(said.contains("shows only"), said);
        assertTrue(title.get().matches(".*from 5[0-9].*"), title.get());
        said(() -> Main.run("--trace", write(), "--picture", picture.toString(), "--from", "3", "--to", "4.5"), 0);
        assertEquals("<title>The air from 3.000 s to 4.500 s</title>", title.get());
    }

    @Test
    void misuse_isOneClearLine() throws IOException {
        send("a", 1, "b");
        assertWrong("there is no such file", "--trace", folder.resolve("none").toString());
        assertWrong("nothing lies between 5.0 s and 1.1855 s", "--trace", write(), "--from", "5");
        assertWrong("nothing lies between NaN s", "--trace", write(), "--from", "NaN");
        assertWrong("nothing lies between 1.0E300 s", "--trace", write(), "--from", "1e300", "--to", "2e300");
        assertWrong("-Ptrace=FILE");
        assertWrong("-Pfrom=SECONDS", "--trace", write(), "--from", "x");
        String good = lines.get(1);
        for (String garbage : List.of("garbage", "[]", "7", "{}", "{\"t\":1}", "{\"t\":1,\"event\":\"rf-tx\"}",
                "\u0000",
                "{\"t\":1,\"event\":\"rf-collision\",\"boards\":3}",
                "{\"t\":1,\"event\":\"rf-collision\",\"boards\":[[]]}",
                good.replace("\"bits\":372", "\"bits\":0"), good.replaceAll("\"end\":[0-9.]+", "\"end\":0.5"),
                good.replaceAll("\"end\":[0-9.]+", "\"end\":\"NaN\""),
                good.replaceAll("\"end\":[0-9.]+", "\"end\":2e9"), good.substring(0, good.length() / 2))) {
            lines.add(1, garbage);
            assertWrong("trace.jsonl, line 2 is no line of a trace", "--trace", write());
            lines.remove(1);
        }
        lines.clear();
        assertWrong("trace.jsonl: it has no event", "--trace", write());
        line("\"t\":1,\"event\":\"note\"");
        assertWrong("has no packet", "--trace", write());
    }

    private void assertWrong(String words, String... options) {
        List<String> all = new ArrayList<>(List.of(options));
        all.addAll(List.of("--picture", folder.resolve("wrong.svg").toString()));
        String said = said(() -> Main.run(all.toArray(String[]::new)), 2);
        assertTrue(said.startsWith("air: ") && said.contains(words), said);
        assertEquals(1, said.lines().count(), said);
    }

    private String write() {
        try {
            return file().toString();
        } catch (IOException failed) {
            throw new AssertionError(failed);
        }
    }

    private static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException failed) {
            throw new AssertionError(failed);
        }
    }

    /** The text that it wrote on the screen, if it ended with this status. */
    private static String said(Supplier<Integer> program, int status) {
        PrintStream out = System.out;
        PrintStream err = System.err;
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        try (PrintStream screen = new PrintStream(said, true, StandardCharsets.UTF_8)) {
            System.setOut(screen);
            System.setErr(screen);
            assertEquals(status, program.get().intValue(), () -> said.toString(StandardCharsets.UTF_8));
        } finally {
            System.setOut(out);
            System.setErr(err);
        }
        return said.toString(StandardCharsets.UTF_8);
    }
}
