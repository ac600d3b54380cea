package uppaal.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import uppaal.ModelException;

class DocumentReaderTest {
    private static final String LOCATIONS =
            "<location id='a'><name>A1</name></location><location id='b'/><init ref='a'/>";

    private static Document read(String xml) throws IOException {
        return DocumentReader.read("m.xml", new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)));
    }

    private static Document template(String body) throws IOException {
        return read("<nta><template><name>T</name>" + body + "</template><system>system T;</system></nta>");
    }

    @Test
    void read_everythingOfTheSubset_isThere() throws IOException {
        Document document = read("<nta><declaration>int x;</declaration><template><name x='1'> T </name>"
                + "<parameter>const int n</parameter><declaration>int y;</declaration>"
                + "<location id='a' x='0' y='0'><name>First</name><label kind='comments'>c</label></location>"
                + "<location id='b'><committed/></location><location id='c'><urgent/></location><init ref='b'/>"
                + "<transition><source ref='a'/><target ref='b'/><label kind='guard'> x &lt; 1 </label>"
                + "<label kind='synchronisation'>c!</label><label kind='assignment'>x++</label>"
                + "<label kind='testcode'>POINT</label><nail x='1' y='2'/></transition>"
                + "</template><system>system T;</system><queries/></nta>");

        Template template = document.template("T");
        assertEquals("int x;", document.declarations());
        assertEquals("system T;", document.system());
        assertEquals("const int n", template.parameters());
        assertEquals("int y;", template.declarations());
        assertEquals("b", template.initial());
        assertEquals(new Location("First", false, ""), template.locations().get(0));
        assertEquals(new Location("b", true, ""), template.locations().get(1));
        assertEquals(new Location("c", Location.Haste.URGENT, ""), template.locations().get(2));
        assertTrue(template.locations().get(2).urgent() && template.locations().get(1).urgent());
        assertFalse(template.locations().get(2).committed() || template.locations().get(0).urgent());
        assertEquals(new Edge("First", "b", "x < 1", "c!", "x++", "POINT"), template.edges().get(0));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "<location id='a'><label kind='exponentialrate'>1</label></location> | location a: a label of kind "
                    + "'exponentialrate'",
            "<location id='a'/><branchpoint id='p'/>       | <branchpoint>"})
    void read_locationOutsideTheSubset_isRefusedByName(String body, String what) {
        String where = what.startsWith("<") ? "m.xml, template T: " : "m.xml, template T, ";
        assertEquals(where + what + " is outside the subset that this checker reads",
                assertThrows(ModelException.class, () -> template(body)).getMessage());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "<label kind='select'>i : int[0,1]</label>     | a label of kind 'select'",
            "<label kind='probability'>1</label>           | a label of kind 'probability'"})
    void read_edgeOutsideTheSubset_isRefusedByName(String label, String what) {
        String body = LOCATIONS + "<transition><source ref='a'/><target ref='b'/>" + label + "</transition>";
        assertEquals("m.xml, template T, edge A1 -> b: " + what + " is outside the subset that this checker reads",
                assertThrows(ModelException.class, () -> template(body)).getMessage());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "<location id='a'><urgent/><committed/></location>            | location a: it is both urgent and "
                    + "committed",
            "<location id='a'/>                                           | it has no initial location",
            "<location id='a'/><init ref='x'/>                            | <init> points to 'x', which is no "
                    + "location of this template",
            "<location id='a'/><init ref='a'/><transition><source ref='a'/></transition> | a transition has no "
                    + "<target>",
            "<location id='a'/><location id='a'/><init ref='a'/>          | the id 'a' is given twice",
            "<location id='a'/><init ref='a'/><init ref='a'/>             | there is a second <init>",
            "<location id='a'><name>b</name></location><location id='b'/><init ref='a'/> | the name 'b' is given "
                    + "twice"})
    void read_brokenTemplate_saysWhat(String body, String message) {
        assertEquals("m.xml, template T" + (message.startsWith("location ") ? ", " : ": ") + message,
                assertThrows(ModelException.class, () -> template(body)).getMessage());
    }

    @Test
    void read_twoGuards_areRefused() {
        String body = LOCATIONS + "<transition><source ref='a'/><target ref='b'/>"
                + "<label kind='guard'>x</label><label kind='guard'>y</label></transition>";
        assertEquals("m.xml, template T, edge A1 -> b: there is a second label of kind 'guard'",
                assertThrows(ModelException.class, () -> template(body)).getMessage());
    }

    @Test
    void read_queriesOrOtherRoots_areRefused() {
        assertEquals("m.xml: <queries>, which belong into the .q file, is outside the subset that this checker reads",
                assertThrows(ModelException.class, () -> read("<nta><system/><queries><query/></queries></nta>"))
                        .getMessage());
        assertEquals("m.xml: its root is <project>, not <nta>",
                assertThrows(ModelException.class, () -> read("<project/>")).getMessage());
        assertTrue(assertThrows(ModelException.class, () -> read("<nta>")).getMessage().startsWith("m.xml, line 1: "));
    }

    @Test
    void read_doctypeWithAddress_asksNobody() throws IOException {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            read("<!DOCTYPE nta PUBLIC 'x' 'http://127.0.0.1:" + server.getLocalPort()
                    + "/flat.dtd'><nta><system/></nta>");
            server.setSoTimeout(1);
            assertThrows(SocketTimeoutException.class, server::accept);
        }
    }

    @Test
    void read_externalEntity_isNotOpened(@TempDir Path folder) throws IOException {
        Path secret = Files.writeString(folder.resolve("secret"), "int leaked;");
        Document document = read("<!DOCTYPE nta [<!ENTITY e SYSTEM '" + secret.toUri() + "'>]>"
                + "<nta><declaration>&e;</declaration><system/></nta>");
        assertFalse(document.declarations().contains("leaked"));
    }

    @Test
    void read_entitiesThatGrow_areRefused() {
        StringBuilder xml = new StringBuilder("<!DOCTYPE nta [<!ENTITY e0 'xxxxxxxxxx'>");
        for (int i = 1; i < 12; i++) {
            xml.append("<!ENTITY e").append(i).append(" '").append(("&e" + (i - 1) + ";").repeat(10)).append("'>");
        }
        assertThrows(ModelException.class, () -> read(xml + "]><nta><declaration>&e11;</declaration></nta>"));
    }

    @Test
    void read_damagedModel_isReadOrRefused() throws IOException {
        byte[] sound = Files.readAllBytes(Path.of("../models/paper.xml"));
        Random random = new Random(5);
        for (int i = 0; i < 300; i++) {
            byte[] damaged = sound.clone();
            damaged[random.nextInt(damaged.length)] = (byte) random.nextInt(256);
            try {
                DocumentReader.read("m.xml", new ByteArrayInputStream(damaged));
            } catch (ModelException expected) {
                assertTrue(expected.getMessage().startsWith("m.xml"));
            }
        }
    }

    @Test
    void read_idOfAnotherTemplate_isRefused() {
        String one = "<location id='a'/><init ref='a'/></template>";
        assertEquals("m.xml, template U: the id 'a' is given in another template too",
                assertThrows(ModelException.class, () -> read("<nta><template><name>T</name>" + one
                        + "<template><name>U</name>" + one + "<system/></nta>")).getMessage());
    }

    @Test
    void read_noFile_saysWhich() {
        assertEquals("../models/none.xml: there is no such file",
                assertThrows(ModelException.class, () -> DocumentReader.read(Path.of("../models/none.xml")))
                        .getMessage());
    }
}
