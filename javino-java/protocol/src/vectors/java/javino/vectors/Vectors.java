package javino.vectors;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Writes the vectors as JSON files, one vector a line. */
public final class Vectors {

    private static final Gson GSON = new GsonBuilder().disableHtmlEscaping().serializeNulls().create();

    private Vectors() {
    }

    /** @param args the folder to write to. */
    public static void main(String[] args) throws IOException {
        Path folder = Path.of(args[0]);
        Files.createDirectories(folder);
        for (Map.Entry<String, String> file : files().entrySet()) {
            Files.writeString(folder.resolve(file.getKey()), file.getValue());
        }
    }

    /** The text of each file, by its name. */
    public static Map<String, String> files() {
        Map<String, String> files = new LinkedHashMap<>();
        files.put("addresses.json", format(AddressVectors.all()));
        files.put("frames.json", format(FrameVectors.all()));
        files.put("contents.json", format(ContentVectors.all()));
        files.put("host-messages.json", format(HostMessageVectors.all()));
        files.put("packets.json", format(PacketVectors.all()));
        files.put("commands.json", format(CommandVectors.all()));
        files.put("radio.json", format(RadioVectors.all()));
        files.put("parity.json", format(ParityVectors.all()));
        files.put("modules.json", format(ModuleVectors.all()));
        files.put("envelopes.json", format(EnvelopeVectors.all()));
        files.put("fragments.json", format(FragmentVectors.all()));
        files.put("acknowledgements.json", format(AcknowledgementVectors.all()));
        files.put("keys.json", format(KeyVectors.all()));
        files.put("key-agreement.json", format(KeyAgreementVectors.all()));
        files.put("nist.json", format(NistVectors.all()));
        return files;
    }

    /** One vector: names and values by turns, in the order of the file. */
    static Map<String, Object> vector(Object... namesAndValues) {
        Map<String, Object> vector = new LinkedHashMap<>();
        for (int i = 0; i < namesAndValues.length; i += 2) {
            vector.put((String) namesAndValues[i], namesAndValues[i + 1]);
        }
        return vector;
    }

    /** The lists of one file, by their names. */
    static Map<String, List<Map<String, Object>>> lists(String name, List<Map<String, Object>> list) {
        Map<String, List<Map<String, Object>>> lists = new LinkedHashMap<>();
        lists.put(name, list);
        return lists;
    }

    private static String format(Map<String, List<Map<String, Object>>> lists) {
        return lists.entrySet().stream()
                .map(list -> "\"" + list.getKey() + "\": [\n" + list.getValue().stream()
                        .map(vector -> "  " + GSON.toJson(vector)).collect(Collectors.joining(",\n")) + "\n]")
                .collect(Collectors.joining(",\n", "{\n", "\n}\n"));
    }
}
