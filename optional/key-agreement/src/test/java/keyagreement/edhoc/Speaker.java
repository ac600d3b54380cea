package keyagreement.edhoc;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import javino.protocol.Bytes;

/**
 * EDHOC with the parties of RFC 9529, for {@code interop/agree.py}: a role on standard input, then each message in
 * hexadecimal as a line on standard input or output; at the end what both sides must have alike.
 */
final class Speaker {

    private static final SecureRandom RANDOM = new SecureRandom();

    private final BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));

    private Speaker() {
    }

    public static void main(String[] args) throws IOException, HandshakeException {
        Speaker speaker = new Speaker();
        for (String role = speaker.in.readLine(); role != null; role = speaker.in.readLine()) {
            Secret secret = role.equals("initiator") ? speaker.initiate() : speaker.respond();
            print(Bytes.join(secret.export(0, Bytes.EMPTY, 16), secret.export(23, Bytes.of(1, 2, 3), 100)));
            print(secret.updated(Rfc9529.of("update")).export(0, Bytes.EMPTY, 16));
        }
    }

    private Secret initiate() throws IOException, HandshakeException {
        Initiator initiator = new Initiator(Rfc9529.initiator(), RANDOM);
        print(initiator.opening());
        Role.Agreed agreed = initiator.take(hear());
        print(agreed.answer());
        return agreed.secret();
    }

    private Secret respond() throws IOException, HandshakeException {
        Responder responder = new Responder(Rfc9529.responder(), hear(), RANDOM);
        print(responder.opening());
        return responder.take(hear()).secret();
    }

    private Bytes hear() throws IOException {
        return Bytes.ofHex(in.readLine());
    }

    private static void print(Bytes line) {
        System.out.println(line);
        System.out.flush();
    }
}
