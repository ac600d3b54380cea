package capture;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.HashMap;
import java.util.Map;

/** Takes captured packets. */
interface Sink extends AutoCloseable {

    /** @throws IOException if it takes no more. */
    void packet(AirPacket packet) throws IOException;

    @Override
    default void close() throws IOException {
    }

    /** A line each. */
    static Sink lines(PrintWriter out, long start) {
        return packet -> {
            out.println(packet.line(start));
            if (out.checkError()) {
                throw new IOException("the output takes no more");
            }
        };
    }

    /** A file, with an interface for each board: of its name, and with its RF id if that is known. */
    static Sink file(Pcapng file, Map<String, String> ids) {
        Map<String, Integer> interfaces = new HashMap<>();
        return new Sink() {
            @Override
            public void packet(AirPacket packet) throws IOException {
                Integer number = interfaces.get(packet.board());
                if (number == null) {
                    number = file.addInterface(Pcapng.AIR, packet.board(),
                            ids.containsKey(packet.board()) ? "RF id " + ids.get(packet.board()) : "no RF id");
                    interfaces.put(packet.board(), number);
                }
                file.packet(number, packet.micros(), packet.record());
            }

            @Override
            public void close() throws IOException {
                file.close();
            }
        };
    }
}
