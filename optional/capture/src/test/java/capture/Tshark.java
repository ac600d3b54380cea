package capture;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import javax.xml.parsers.DocumentBuilderFactory;
import javino.protocol.Bytes;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** Debian's tshark with the dissector, in a process of its own. */
public final class Tshark {

    /** LINKTYPE_USER1: packets of the serial line. */
    static final int SERIAL = 148;

    private static final Path LUA =
            Path.of(System.getProperty("javino.root"), "optional/capture/build/wireshark/javino.lua");
    private static final String NOBODY = "65534";

    /** @param linkType {@link Pcapng#AIR} or {@link #SERIAL}. */
    record Packet(int linkType, long micros, Bytes record) {
    }

    /** A field: as it is shown, and the bytes that it stands for, in hexadecimal; empty where it stands for none. */
    record Field(String shown, String hex) {
    }

    /** A dissected packet: its fields by their names, in their order. */
    public record Dissected(Map<String, List<Field>> fields) {

        /** The text of all fields of a name. */
        public List<String> shown(String name) {
            return fields.getOrDefault(name, List.of()).stream().map(Field::shown).toList();
        }

        /** The bytes of the fields of a name. */
        public List<String> hex(String name) {
            return fields.getOrDefault(name, List.of()).stream().map(Field::hex).toList();
        }

        /** The names of the errors that were found. */
        public List<String> errors() {
            return shown("javino.error");
        }
    }

    private Tshark() {
    }

    /** A capture of these packets. */
    static byte[] file(List<Packet> packets) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Pcapng file = new Pcapng(bytes, "test");
        file.addInterface(Pcapng.AIR, "air", "test");
        file.addInterface(SERIAL, "serial", "test");
        for (Packet packet : packets) {
            file.packet(packet.linkType() - Pcapng.AIR, packet.micros(), packet.record());
        }
        return bytes.toByteArray();
    }

    /**
     * Dissects a capture in two passes, as Wireshark does.
     *
     * @param keyring the text of a keyring; empty for none.
     * @throws AssertionError if a packet is malformed, or the dissector has failed.
     */
    public static List<Dissected> dissect(byte[] capture, String keyring) throws Exception {
        Path folder = Files.createTempDirectory("capture");
        try {
            Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
            Files.copy(LUA, folder.resolve("javino.lua"), StandardCopyOption.REPLACE_EXISTING);
            Files.write(folder.resolve("capture.pcapng"), capture);
            Files.writeString(folder.resolve("keyring"), keyring);
            return read(run(folder, keyring.isEmpty()));
        } finally {
            for (String name : List.of("javino.lua", "capture.pcapng", "keyring", "out", "err")) {
                Files.deleteIfExists(folder.resolve(name));
            }
            Files.delete(folder);
        }
    }

    private static byte[] run(Path folder, boolean withoutKeys) throws Exception {
        List<String> words = new ArrayList<>();
        if (Files.getOwner(folder).getName().equals("root")) {
            // To root, Wireshark 4.4 runs no Lua.
            words.addAll(List.of("setpriv", "--reuid", NOBODY, "--regid", NOBODY, "--clear-groups"));
        }
        words.addAll(List.of("tshark", "-2", "-r", "capture.pcapng", "-X", "lua_script:javino.lua", "-T", "pdml"));
        if (!withoutKeys) {
            words.addAll(List.of("-o", "javino.keyring:keyring"));
        }
        ProcessBuilder builder = new ProcessBuilder(words).directory(folder.toFile());
        builder.environment().put("HOME", folder.toString());
        Path out = folder.resolve("out");
        Path err = folder.resolve("err");
        Process process = builder.redirectOutput(out.toFile()).redirectError(err.toFile()).start();
        if (!process.waitFor(5, TimeUnit.MINUTES)) {
            process.destroyForcibly();
            throw new AssertionError("tshark has not ended");
        }
        String said = Files.readString(err);
        if (process.exitValue() != 0 || !said.isEmpty()) {
            throw new AssertionError("tshark has ended with " + process.exitValue() + ": " + said);
        }
        return Files.readAllBytes(out);
    }

    private static List<Dissected> read(byte[] pdml) throws Exception {
        String all = new String(pdml, StandardCharsets.UTF_8);
        for (String bad : List.of("_ws.malformed", "_ws.lua.error", "Lua Error")) {
            if (all.contains(bad)) {
                throw new AssertionError(bad + all.substring(all.indexOf(bad)).lines().findFirst().orElse(""));
            }
        }
        NodeList packets = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                .parse(new ByteArrayInputStream(pdml)).getElementsByTagName("packet");
        List<Dissected> read = new ArrayList<>();
        for (int i = 0; i < packets.getLength(); i++) {
            Element packet = (Element) packets.item(i);
            Map<String, List<Field>> fields = new TreeMap<>();
            NodeList found = packet.getElementsByTagName("field");
            for (int k = 0; k < found.getLength(); k++) {
                Element field = (Element) found.item(k);
                fields.computeIfAbsent(field.getAttribute("name"), name -> new ArrayList<>())
                        .add(new Field(shown(field), field.getAttribute("value")));
            }
            read.add(new Dissected(fields));
        }
        return read;
    }

    /** A field's text, on Debian 12 and 13 alike: the one shows a bool as 1, the other as True. */
    private static String shown(Element field) {
        String shown = field.getAttribute("show");
        return shown.equals("True") ? "1" : shown.equals("False") ? "0" : shown;
    }
}
