package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import trace.TraceEvent;
import uppaal.ModelException;
import uppaal.document.DocumentReader;

class InstanceTest {
    private static final String MODEL = """
            <nta><declaration>const int MOST = 2; int[0,3] kind;</declaration><template><name>T</name>
            <declaration>clock x; int[0,MOST] n;</declaration>
            <location id='a'><name>A</name></location><location id='b'><name>B</name><committed/></location>
            <location id='c'><name>C</name></location><init ref='a'/>
            <transition><source ref='a'/><target ref='a'/><label kind='guard'>n &lt; MOST</label>
            <label kind='assignment'>n++</label><label kind='testcode'>COUNT MORE</label></transition>
            <transition><source ref='a'/><target ref='b'/><label kind='guard'>x &lt;= 5</label>
            <label kind='testcode'>GO</label></transition>
            <transition><source ref='b'/><target ref='c'/><label kind='guard'>kind == 1</label>
            <label kind='assignment'>n = 0</label></transition>
            <transition><source ref='b'/><target ref='a'/><label kind='guard'>kind == 2</label>
            <label kind='testcode'>GO</label></transition>
            <transition><source ref='c'/><target ref='c'/><label kind='testcode'>STAY</label></transition>
            <transition><source ref='c'/><target ref='a'/><label kind='testcode'>STAY BACK</label></transition>
            </template><system>system T;</system></nta>""";

    private final Model model = model(Map.of());
    private final Instance instance = model.instance("of a test");

    private static Model model(Map<String, Integer> constants) {
        try {
            return new Model(DocumentReader.read("m.xml", new ByteArrayInputStream(
                    MODEL.getBytes(StandardCharsets.UTF_8))), "T", constants);
        } catch (IOException impossible) {
            throw new AssertionError(impossible);
        }
    }

    private static Point point(String name) {
        return new Point(TraceEvent.parse(1, "{\"t\":1,\"board\":\"b\",\"event\":\"point\"}"), name, 0, List.of());
    }

    @Test
    void take_edgeOfPoint_assigns() throws RefusedException {
        instance.take(point("COUNT"));
        instance.take(point("MORE"));

        assertEquals(2, instance.get("n"));
        assertEquals(Set.of("T: A -> A (COUNT MORE)"), Set.copyOf(model.covered().stream()
                .map(name -> name.replace("MORE COUNT", "COUNT MORE")).toList()));
    }

    @Test
    void take_guardIsFalse_isRefusedByName() {
        instance.set("n", 2);
        instance.set("x", 5);

        RefusedException refused = assertThrows(RefusedException.class, () -> instance.take(point("COUNT")));

        assertEquals("b declares COUNT, but its T of a test is A; expected GO", refused.getMessage());
    }

    @Test
    void take_otherConstant_changesGuards() {
        Instance other = model(Map.of("MOST", 0)).instance("");

        assertThrows(RefusedException.class, () -> other.take(point("COUNT")));
    }

    @Test
    void take_throughCommittedLocation_passesEdgesWithoutPoints() throws RefusedException {
        instance.take(point("GO"));
        instance.take(point("BACK"), "BACK", Map.of("kind", 1));

        assertTrue(instance.isAt("A"));
        assertEquals(0, instance.get("n"));
    }

    @Test
    void take_twoEdgesOfOneName_takesBoth() throws RefusedException {
        instance.take(point("GO"), "GO", Map.of("kind", 2));

        assertTrue(instance.isAt("A"));
    }

    @Test
    void take_ambiguousPoint_isModelsFault() throws RefusedException {
        instance.take(point("GO"), "GO", Map.of("kind", 1));

        assertThrows(ModelException.class, () -> instance.take(point("STAY")));
    }

    @Test
    void set_clockPastAll_staysThere() {
        instance.set("x", 1000);

        assertTrue(instance.get("x") > 5);
        assertThrows(ModelException.class, () -> instance.set("n", 1000));
    }
}
