package keyagreement.edhoc;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import keyagreement.edhoc.KeySchedule.Proof;
import keyagreement.edhoc.KeySchedule.Second;
import keyagreement.edhoc.KeySchedule.Third;
import verdict.Judge;

/** Cases of the working groups whose standards are built here. */
@Tag("verdict")
@Tag("newerJava")
class StandardsTest {

    private static final String METHOD = "03";

    /**
     * Method 0 is refused, by its number. The draft made the hashes TH otherwise than RFC 9528, sent C_R beside message
     * 2, and had a kid be a number: runs of method 3 are computed from its hashes and with its ID_CRED.
     */
    @Test
    void handshake_isAsTheWorkingGroupSays() throws HandshakeException {
        JsonObject all = Others.read("edhoc/vectors-p256.json").getAsJsonObject();
        try (Judge judge = new Judge("lake-wg/edhoc", "test-vectors-15, P-256", "`KeySchedule`, `Responder`")) {
            for (Map.Entry<String, JsonElement> vector : all.entrySet()) {
                JsonObject trace = vector.getValue().getAsJsonObject();
                judge.judge(vector.getKey(), trace.get("method").getAsString().equals(METHOD) ? computes(trace)
                        : isRefused(trace));
            }
        }
    }

    private static boolean isRefused(JsonObject trace) throws HandshakeException {
        P256.Pair y = pair(trace, "y_raw");
        try {
            new Responder(Named.of(Bytes.of(0), Bytes.EMPTY, "1"), Others.bytes(trace, "message_1"), y, Bytes.of(0));
            return false;
        } catch (HandshakeException e) {
            return e.getMessage().contains("its method is 0, not 3");
        }
    }

    private static boolean computes(JsonObject trace) throws HandshakeException {
        Named initiator = party(trace, "i");
        Named responder = party(trace, "r");
        P256.Pair x = pair(trace, "x_raw");
        P256.Pair y = pair(trace, "y_raw");
        Bytes gXY = P256.agree(x.secret(), y.key());
        Bytes th2 = Others.bytes(trace, "th_2_raw");
        Second second = new Second(th2, Kdf.extract(Bytes.EMPTY, gXY));
        Bytes prk3e2m = second.prk3e2m(P256.agree(x.secret(), responder.own().key()));
        Bytes plaintext2 = Others.bytes(trace, "plaintext_2");
        Third third = new Third(Others.bytes(trace, "th_3_raw"), prk3e2m);
        Bytes prk4e3m = third.prk4e3m(P256.agree(y.secret(), initiator.own().key()));
        Bytes mac3 = Kdf.derive(prk4e3m, 6, Bytes.join(Others.bytes(trace, "id_cred_i"), Others.bytes(trace, "th_3"),
                initiator.own().encoded()), KeySchedule.MAC_LENGTH);
        Bytes plaintext3 = new Proof(initiator.own().kid(), mac3, Bytes.EMPTY).encode();
        Secret secret = new Secret(Kdf.derive(prk4e3m, 7, Others.bytes(trace, "th_4_raw"), Kdf.HASH_LENGTH));
        return List.of(gXY, second.prk2e(), prk3e2m, second.crypt(plaintext2), prk4e3m, mac3,
                Cbor.bytes(third.seal(plaintext3)), secret.export(0, Bytes.EMPTY, 16),
                secret.export(1, Bytes.EMPTY, 8))
                .equals(Stream.of("g_xy_raw", "prk_2e_raw", "prk_3e2m_raw", "ciphertext_2_raw",
                        "prk_4e3m_raw", "mac_3_raw", "message_3", "oscore_secret_raw", "oscore_salt_raw")
                        .map(name -> Others.bytes(trace, name)).toList())
                && secret.equals(new Secret(Others.bytes(trace, "prk_out")));
    }

    private static P256.Pair pair(JsonObject trace, String secret) throws HandshakeException {
        var number = P256.secret(P256.number(Others.bytes(trace, secret)));
        return new P256.Pair(number, P256.withX(P256.publicX(number)));
    }

    /** The name is the last byte of ID_CRED, a map with a kid of one byte. */
    private static Named party(JsonObject trace, String name) throws HandshakeException {
        return Named.of(Others.bytes(trace, "id_cred_" + name).from(2), Others.bytes(trace, "cred_" + name),
                trace.get(name + "_raw").getAsString());
    }

    /** What ours can read it reads, and refuses the rest. */
    @Test
    void cbor_isAsTheStandardSays() {
        JsonArray all = Others.read("cbor/appendix_a.json").getAsJsonArray();
        try (Judge judge = new Judge("RFC 8949 appendix A", "cbor/test-vectors of 2014", "`CborReader`")) {
            for (JsonElement element : all) {
                JsonObject example = element.getAsJsonObject();
                Bytes encoded = Others.bytes(example, "hex");
                judge.judge(encoded.hex(), expected(example).equals(read(encoded)));
            }
        }
    }

    private static Optional<JsonElement> read(Bytes encoded) {
        CborReader reader = new CborReader(encoded);
        try {
            JsonElement read = item(reader, encoded.at(0) >> 5);
            reader.end();
            return Optional.of(read);
        } catch (HandshakeException e) {
            return Optional.empty();
        }
    }

    private static JsonElement item(CborReader reader, int major) throws HandshakeException {
        if (major == Cbor.BYTES) {
            return new JsonPrimitive("h'" + reader.bytes().hex() + "'");
        }
        if (major != Cbor.ARRAY) {
            return new JsonPrimitive((long) reader.integer());
        }
        JsonArray items = new JsonArray();
        for (int rest = reader.array(); rest > 0; rest--) {
            items.add(item(reader, Cbor.UNSIGNED));
        }
        return items;
    }

    /** Numbers of 31 bits, byte strings, arrays of numbers, in their shortest form. */
    private static Optional<JsonElement> expected(JsonObject example) {
        JsonElement value = example.has("decoded") ? example.get("decoded") : example.get("diagnostic");
        boolean isRead = example.get("roundtrip").getAsBoolean() && (example.has("decoded") ? isRead(value)
                : value.getAsString().startsWith("h'"));
        return isRead ? Optional.of(value) : Optional.empty();
    }

    private static boolean isRead(JsonElement value) {
        if (value.isJsonArray()) {
            for (JsonElement item : value.getAsJsonArray()) {
                if (item.isJsonArray() || !isRead(item)) {
                    return false;
                }
            }
            return true;
        }
        return value.isJsonPrimitive() && value.getAsString().matches("-?\\d{1,9}")
                && !value.getAsJsonPrimitive().isString();
    }
}
