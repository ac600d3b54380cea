package gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A broker that says at once that another client has taken over the session, as often as one comes. */
@Timeout(120)
class BrokerTest {

    private static final int CONNECT = 1;
    private static final int SUBSCRIBE = 8;
    private static final byte[] CONNACK = {0x20, 3, 0, 0, 0};
    private static final byte[] TAKEN_OVER = {(byte) 0xE0, 1, (byte) 0x8E};
    private static final String TOPIC = "javino/west/gateway/f00";

    private final BlockingQueue<String> ids = new LinkedBlockingQueue<>();
    private final BlockingQueue<Boolean> takeovers = new LinkedBlockingQueue<>();

    private final class Told implements Broker.Listener {

        @Override
        public void connected() {
            // Not for long.
        }

        @Override
        public void disconnected(BrokerException why) {
            takeovers.add(why.isTakeover());
        }

        @Override
        public void arrived(Broker.Message message) {
            throw new AssertionError("nothing was published");
        }
    }

    private void serve(ServerSocket server) {
        try {
            while (true) {
                try (Socket client = server.accept()) {
                    answer(client);
                }
            }
        } catch (IOException closed) {
            // The test is over.
        }
    }

    private void answer(Socket client) throws IOException {
        DataInputStream in = new DataInputStream(client.getInputStream());
        for (int first = in.read(); first >= 0; first = in.read()) {
            byte[] body = in.readNBytes(in.read());
            if (first >> 4 == CONNECT) {
                int length = body[12 + body[10]];
                ids.add(new String(body, 13 + body[10], length, StandardCharsets.UTF_8));
                client.getOutputStream().write(CONNACK);
            } else if (first >> 4 == SUBSCRIBE) {
                client.getOutputStream().write(new byte[] {(byte) 0x90, 4, body[0], body[1], 0, 1});
                client.getOutputStream().write(TAKEN_OVER);
                return;
            }
        }
    }

    @Test
    void session_takenOver_comesAgainByAnotherIdEachTime() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
            new Thread(() -> serve(server), "broker").start();
            BrokerConfig config = BrokerConfig.parse("mqtt://127.0.0.1:" + server.getLocalPort());
            Broker broker =
                    new Broker(config, Map.of("javino/+/air", true), Broker.Message.none(TOPIC), new Told());
            broker.connect();
            List<String> came = List.of(ids.take(), ids.take(), ids.take());
            assertTrue(takeovers.take() && takeovers.take());
            broker.close();
            assertEquals(3, Set.copyOf(came).size());
            assertTrue(came.stream().allMatch(id -> id.matches("[0-9a-f]{22}")), "" + came);
        }
    }
}
