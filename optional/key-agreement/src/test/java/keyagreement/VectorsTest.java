package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.LocalDate;
import java.util.List;
import java.util.stream.StreamSupport;
import javino.protocol.Address;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.P256;
import keyagreement.edhoc.Role;
import keyagreement.edhoc.Secret;
import keyagreement.edhoc.Secrets;

/** SPEC 11, by vectors that another implementation has made. */
@Tag("newerJava")
class VectorsTest {

    static List<JsonObject> certificates() throws IOException {
        return vectors("certificates");
    }

    static List<JsonObject> revocationLists() throws IOException {
        return vectors("revocationLists");
    }

    static List<JsonObject> renewals() throws IOException {
        return vectors("renewals");
    }

    private static List<JsonObject> vectors(String list) throws IOException {
        Path file = Path.of(System.getProperty("javino.vectors"), "key-agreement.json");
        return all(JsonParser.parseString(Files.readString(file)).getAsJsonObject(), list).stream()
                .map(JsonElement::getAsJsonObject).toList();
    }

    private static List<JsonElement> all(JsonObject of, String list) {
        return StreamSupport.stream(of.getAsJsonArray(list).spliterator(), false).toList();
    }

    private static String text(JsonObject vector, String name) {
        return vector.get(name).getAsString();
    }

    private static Bytes bytes(JsonObject vector, String name) {
        return Bytes.ofHex(text(vector, name));
    }

    private static LocalDate day(JsonObject vector, String name) {
        return LocalDate.parse(text(vector, name));
    }

    private static Address address(JsonObject vector, String name) {
        return Address.parse(text(vector, name));
    }

    @ParameterizedTest
    @MethodSource("certificates")
    void certificate_isReadWrittenAndGivesTheKey(JsonObject vector) throws HandshakeException {
        AuthorityKeys keys = AuthorityKeys.decode(bytes(vector, "authority"));
        Certificate certificate = Certificate.decode(bytes(vector, "certificate"));
        assertEquals(new Certificate(address(vector, "address"), vector.get("serial").getAsInt(),
                vector.get("groupKeyServer").getAsBoolean(), day(vector, "until"), keys.id(), certificate.point()),
                certificate);
        assertEquals(bytes(vector, "certificate"), certificate.toBytes());
        assertEquals(bytes(vector, "publicKey"), P256.compress(certificate.key(keys)));
        assertEquals(bytes(vector, "cred"), certificate.credential(keys).encoded());
    }

    @ParameterizedTest
    @MethodSource("certificates")
    void device_hasTheSecretOfItsCertificate(JsonObject vector) throws HandshakeException {
        Certificate certificate = Certificate.decode(bytes(vector, "certificate"));
        BigInteger secret = certificate.hash().multiply(P256.number(bytes(vector, "requestSecret")))
                .add(P256.number(bytes(vector, "contribution"))).mod(P256.ORDER);
        assertEquals(bytes(vector, "secret"), P256.bytes(secret));
        assertEquals(bytes(vector, "publicKey").from(1), P256.publicX(P256.secret(secret)));
        Request request = Request.decode(bytes(vector, "request"));
        assertEquals(certificate.address(), request.address());
        assertEquals(P256.publicX(P256.secret(P256.number(bytes(vector, "requestSecret")))), request.point().from(1));
    }

    @ParameterizedTest
    @MethodSource("revocationLists")
    void revocationList_isReadWrittenAndSigned(JsonObject vector) throws HandshakeException {
        AuthorityKeys keys = AuthorityKeys.decode(bytes(vector, "authority"));
        RevocationList revocationList = RevocationList.decode(bytes(vector, "revocationList"));
        assertEquals(bytes(vector, "revocationList"), revocationList.toBytes());
        assertEquals(vector.get("sequence").getAsInt(), revocationList.sequence());
        assertEquals(day(vector, "day"), revocationList.day());
        assertEquals(day(vector, "leastUntil"), revocationList.leastUntil());
        assertEquals(all(vector, "serials").stream().map(JsonElement::getAsInt).toList(), revocationList.serials());
        assertTrue(revocationList.isOf(keys));
    }

    @ParameterizedTest
    @MethodSource("renewals")
    void renewal_hasTheMessagesAndKeys(JsonObject vector) throws HandshakeException {
        Secret kept = Secrets.of(bytes(vector, "kept"));
        Address initiator = address(vector, "initiator");
        Address responder = address(vector, "responder");
        assertEquals(bytes(vector, "key").hex(), key(kept, initiator, responder));
        Role first = Renewal.begin(kept, initiator, responder, drawing(bytes(vector, "message1")));
        assertEquals(bytes(vector, "message1"), first.opening());
        Role second = Renewal.answer(kept, responder, initiator, first.opening(),
                drawing(bytes(vector, "message2")));
        assertEquals(bytes(vector, "message2"), second.opening());
        Role.Agreed agreed = first.take(second.opening());
        assertEquals(bytes(vector, "message3"), agreed.answer());
        assertEquals(Secrets.of(bytes(vector, "updated")), agreed.secret());
        assertEquals(agreed.secret(), second.take(agreed.answer()).secret());
        assertEquals(bytes(vector, "updatedKey").hex(), key(agreed.secret(), initiator, responder));
    }

    /** Draws the nonce with which a message begins. */
    private static SecureRandom drawing(Bytes message) {
        return new SecureRandom() {
            private static final long serialVersionUID = 1L;

            @Override
            public void nextBytes(byte[] bytes) {
                System.arraycopy(message.toArray(), 0, bytes, 0, bytes.length);
            }
        };
    }

    private static String key(Secret secret, Address initiator, Address responder) {
        return Identity.key(secret, initiator, responder).bytes().hex();
    }
}
