package keyagreement.edhoc;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.math.BigInteger;
import java.util.Map;
import java.util.Optional;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import verdict.Judge;

/** Cases of Wycheproof (C2SP), which has what implementations got wrong. */
@Tag("verdict")
@Tag("newerJava")
class WycheproofTest {

    private static final Map<String, String[]> KNOWN =
            Map.of("ecdsa_secp256r1_sha256_p1363", new String[] {"115", "257"});

    /** A case that ours has no form to be asked. */
    private static final class NotAsked extends Exception {

        private static final long serialVersionUID = 1;

        NotAsked(String why) {
            super(why);
        }
    }

    /** How ours answers to one case. */
    private interface Case {

        /** @return whether it takes the case, and with the values that this has. */
        boolean takes(JsonObject group, JsonObject test) throws HandshakeException, NotAsked;
    }

    private static void judge(String file, String part, Case ours) {
        try (Judge judge = new Judge("Wycheproof " + file, "0.7.0", part)) {
            judge.know("Java 17 refuses a signature whose point has an x-coordinate above the order, one of 2^128",
                    KNOWN.getOrDefault(file, new String[0]));
            JsonObject all = Others.read("wycheproof/" + file + "_test.json").getAsJsonObject();
            for (JsonElement group : all.getAsJsonArray("testGroups")) {
                for (JsonElement test : group.getAsJsonObject().getAsJsonArray("tests")) {
                    judge(judge, ours, group.getAsJsonObject(), test.getAsJsonObject());
                }
            }
        }
    }

    private static void judge(Judge judge, Case ours, JsonObject group, JsonObject test) {
        String result = test.get("result").getAsString();
        boolean right;
        try {
            // What is "acceptable" is taken with the right values, or refused.
            right = ours.takes(group, test) != result.equals("invalid");
        } catch (NotAsked e) {
            judge.skip(e.getMessage());
            return;
        } catch (HandshakeException | IllegalArgumentException e) {
            right = !result.equals("valid");
        }
        judge.judge(test.get("tcId").getAsString(), right);
    }

    private static Bytes bytes(JsonObject test, String field) {
        return Others.bytes(test, field);
    }

    private static BigInteger number(JsonObject test, String field) {
        return new BigInteger(test.get(field).getAsString(), 16);
    }

    @Test
    void ccm_isAsWycheproofSays() {
        judge("aes_ccm", "`Ccm`", (group, test) -> {
            Ccm ccm = new Ccm(bytes(test, "key"), bytes(test, "iv"), group.get("tagSize").getAsInt() / 8);
            Bytes sealed = Bytes.join(bytes(test, "ct"), bytes(test, "tag"));
            boolean opens = ccm.open(sealed, bytes(test, "aad")).equals(Optional.of(bytes(test, "msg")));
            boolean seals = ccm.seal(bytes(test, "msg"), bytes(test, "aad")).equals(sealed);
            // Both ways: a wrong tag must neither be opened nor made.
            return opens && seals;
        });
    }

    @Test
    void hmac_isAsWycheproofSays() {
        judge("hmac_sha256", "`Kdf`", (group, test) -> Kdf.hmac(bytes(test, "key"), bytes(test, "msg"))
                .slice(0, group.get("tagSize").getAsInt() / 8).equals(bytes(test, "tag")));
    }

    @Test
    void hkdf_isAsWycheproofSays() {
        judge("hkdf_sha256", "`Kdf`", (group, test) -> Kdf.expand(Kdf.extract(bytes(test, "salt"), bytes(test, "ikm")),
                bytes(test, "info"), test.get("size").getAsInt()).equals(bytes(test, "okm")));
    }

    @Test
    void ecdsa_isAsWycheproofSays() {
        judge("ecdsa_secp256r1_sha256_p1363", "`P256`, signatures of lists", (group, test) -> P256.verify(
                P256.decompress(compressed(bytes(group.getAsJsonObject("publicKey"), "uncompressed"))),
                bytes(test, "msg"), bytes(test, "sig")));
    }

    @Test
    void ecdhWithPoints_isAsWycheproofSays() {
        judge("ecdh_secp256r1_ecpoint", "`P256`", (group, test) -> agrees(test, asked(bytes(test, "public"))));
    }

    @Test
    void ecdhInAsn1_isAsWycheproofSays() {
        Bytes head = Bytes.ofHex("3059301306072a8648ce3d020106082a8648ce3d030107034200");
        judge("ecdh_secp256r1", "`P256`", (group, test) -> {
            Bytes key = bytes(test, "public");
            if (key.length() <= head.length() || !key.slice(0, head.length()).equals(head)) {
                throw new NotAsked("ours reads no ASN.1, and these are no usual form of a point of P-256");
            }
            return agrees(test, asked(key.from(head.length())));
        });
    }

    private static boolean agrees(JsonObject test, Bytes point) throws HandshakeException {
        return P256.agree(P256.secret(number(test, "private")), P256.decompress(point)).equals(bytes(test, "shared"));
    }

    /** A point in our form; one with a wrong y-coordinate has none. */
    private static Bytes asked(Bytes point) throws NotAsked {
        if (point.length() != 1 + 2 * P256.COORDINATE_LENGTH || point.at(0) != 4) {
            return point;
        }
        try {
            Bytes y = P256.y(P256.decompress(compressed(point)));
            if (!y.equals(point.from(1 + P256.COORDINATE_LENGTH))) {
                throw new NotAsked("a wrong y-coordinate can't be said to ours, which takes x and a sign");
            }
        } catch (HandshakeException e) {
            // No point has this x: ours is asked, and is to refuse it again.
        }
        return compressed(point);
    }

    private static Bytes compressed(Bytes uncompressed) {
        boolean odd = (uncompressed.at(uncompressed.length() - 1) & 1) == 1;
        return Bytes.join(Bytes.of(odd ? 3 : 2), uncompressed.slice(1, 1 + P256.COORDINATE_LENGTH));
    }
}
