package mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class TraceMutantsTest {

    private static final String UNICAST = "42303031423030304256000001000000aabb0001020304050607";
    private static final String ACK = "2b4b41414230303142410001020304050607";
    /** A unicast of board a, its arrival, and the acknowledgement of board b. */
    private static final List<String> LINES = List.of(
            "{'t':0.100000,'board':'a','event':'host-transmit','number':0,'destination':'B001','asked':0.090000}",
            "{'t':0.400000,'board':'a','event':'rf-tx','packet':1,'payload':'" + UNICAST + "',"
                    + "'destination':'B001','origin':'B000','kind':'unicast','bits':600,"
                    + "'start':0.120000,'end':0.400000}",
            "{'t':0.400110,'board':'b','event':'rf-rx','from':'a','packet':1,"
                    + "'payload':'" + UNICAST + "','destination':'B001',"
                    + "'origin':'B000','kind':'unicast','bits':600,'start':0.120110,'end':0.400110}",
            "{'t':0.402000,'board':'b','event':'host-handed','number':0,'destination':'B001','origin':'B000'}",
            "{'t':0.600000,'board':'b','event':'rf-tx','packet':2,'payload':'" + ACK + "',"
                    + "'destination':'+KAA','origin':'B001','kind':'acknowledgement','answers':'delivered',"
                    + "'bits':300,'start':0.450000,'end':0.600000}",
            "{'t':0.602000,'board':'a','event':'host-outcome','number':0,'outcome':'delivered'}").stream()
            .map(line -> line.replace('\'', '"')).toList();

    private static List<String> mutant(String operator, int line) {
        return TraceMutants.of(LINES, 1).stream()
                .filter(mutant -> mutant.operator().equals(operator) && mutant.line() == line).findFirst()
                .orElseThrow(() -> new AssertionError(operator + " is none of " + TraceMutants.of(LINES, 1)))
                .lines().get();
    }

    /** The lines of a mutant that are not in the trace, and those of the trace that are not in the mutant. */
    private static List<Integer> changed(List<String> mutant) {
        List<Integer> changed = new ArrayList<>();
        for (int i = 0; i < LINES.size(); i++) {
            if (!mutant.contains(LINES.get(i))) {
                changed.add(i + 1);
            }
        }
        return changed;
    }

    private static String time(String line, String field) {
        return line.replaceAll(".*\"" + field + "\":([0-9.]+).*", "$1");
    }

    @Test
    void of_genuineTraces_givesMutantsThatDifferFromThem() throws IOException {
        for (Path file : Traces.files(Path.of(System.getProperty("javino.root")))) {
            List<String> lines = Files.readAllLines(file);
            List<TraceMutant> mutants = TraceMutants.of(lines, 1);
            assertFalse(mutants.isEmpty());
            for (TraceMutant mutant : mutants.subList(0, 50)) {
                assertFalse(lines.equals(mutant.lines().get()), mutant::toString);
            }
        }
    }

    @Test
    void dropped_event_isGone() {
        List<String> lines = mutant("dropped", 3);
        assertEquals(LINES.size() - 1, lines.size());
        assertEquals(List.of(3), changed(lines));
    }

    @Test
    void toldTwice_event_standsBehindItself() {
        List<String> lines = mutant("told twice", 3);
        assertEquals(lines.get(2), lines.get(3));
        assertEquals(List.of(), changed(lines));
    }

    @Test
    void of_whatAHostMayGetTwice_givesNone() {
        assertTrue(none("told twice", LINES, 4), "handed");
        assertTrue(none("told twice", LINES, 6), "outcome");
    }

    @Test
    void of_injectorsPacket_givesNone() {
        List<String> strange = LINES.stream().map(line -> line.replace("\"a\"", "\"injector\"")).toList();
        assertTrue(TraceMutants.of(strange, 1).stream().noneMatch(mutant -> mutant.line() < 4));
    }

    @Test
    void intoThePacketBefore_whereAResetIsNear_isNotTried() {
        List<String> disturbed = new ArrayList<>(LINES);
        disturbed.add("{'t':0.700000,'board':'c','event':'reset','why':'power'}".replace('\'', '"'));
        assertTrue(none("into the packet before", disturbed, 5));
        assertTrue(none("airtime a bit shorter", disturbed, 2));
    }

    private static boolean none(String operator, List<String> lines, int line) {
        return TraceMutants.of(lines, 1).stream()
                .noneMatch(mutant -> mutant.operator().equals(operator) && mutant.line() == line);
    }

    @Test
    void swapped_events_haveEachOthersTimes() {
        List<String> lines = mutant("swapped with the board's next event", 4);
        assertEquals(List.of(4, 5), changed(lines));
        assertTrue(lines.get(3).contains("rf-tx"));
        assertEquals(List.of("0.402000", "0.600000"), List.of(time(lines.get(3), "t"), time(lines.get(4), "t")));
        assertEquals("0.252000", time(lines.get(3), "start"));
    }

    @Test
    void anotherNumber_isOneHigher() {
        assertEquals(LINES.get(0).replace("\"number\":0", "\"number\":1"), mutant("another number", 1).get(0));
    }

    @Test
    void anotherOutcome_isToldInstead() {
        assertEquals(LINES.get(5).replace("delivered", "sent"), mutant("another outcome", 6).get(5));
    }

    @Test
    void beforeItsPacket_handed_comesBeforeThePacketBegins() {
        assertEquals("0.119000", time(mutant("before its packet", 4).get(1), "t"));
    }

    @Test
    void bitAsSent_packet_isChangedWhereItIsSentAndHeard() {
        List<String> lines = mutant("a bit changed as sent: tag", 2);
        assertEquals(List.of(2, 3), changed(lines));
        String payload = lines.get(1).replaceAll(".*payload\":\"(\\w+)\".*", "$1");
        assertTrue(lines.get(2).contains(payload), payload);
    }

    @Test
    void bitAsHeard_packet_isChangedForOneBoardAlone() {
        assertEquals(List.of(3), changed(mutant("a bit changed as heard: nonce", 3)));
    }

    @Test
    void zeros_region_isZeroAndTheRestStays() {
        assertTrue(mutant("zeros in each repeat: proof", 5).get(4)
                .contains(ACK.substring(0, 20) + "0000000000000000\""));
    }

    @Test
    void airtime_packet_endsABitLater() {
        String line = mutant("airtime a bit longer", 2).stream().filter(each -> each.contains("rf-tx")).findFirst()
                .orElseThrow();
        assertEquals(List.of("601", "0.120000", "0.400500"),
                List.of(time(line, "bits"), time(line, "start"), time(line, "end")));
    }

    @Test
    void quietSlots_acknowledgement_beginsHalfASlotAfterThePacket() {
        String line = mutant("after 0.5 quiet slots", 5).stream().filter(each -> each.contains(ACK)).findFirst()
                .orElseThrow();
        assertEquals(List.of("0.404000", "0.554000"), List.of(time(line, "start"), time(line, "end")));
    }

    @Test
    void intoThePacketBefore_acknowledgement_beginsInItsMiddle() {
        assertTrue(mutant("into the packet before", 5).stream()
                .anyMatch(line -> line.contains(ACK) && time(line, "start").equals("0.260000")));
    }
}
