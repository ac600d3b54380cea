package javino.link;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import javino.JavinoException;

/** A serial port: 8 data bits, no parity, one stop bit, no flow control (SPEC 4). */
public final class SerialLink implements Link {

    /** The default baud rate of boards. */
    public static final int DEFAULT_BAUD = 115_200;

    /** A start bit, eight of data, a stop bit. */
    private static final int BITS_A_BYTE = 10;
    private static final int TIMEOUT_STEP_MILLIS = 100;
    /** ENOTTY of Linux, macOS and the BSDs. */
    private static final int NOT_A_TERMINAL = 25;
    /** EACCES of the same. */
    private static final int FORBIDDEN = 13;
    /** EBUSY of the same, and EWOULDBLOCK, with which a port that is locked is refused, of Linux and of the others. */
    private static final Set<Integer> BUSY = Set.of(16, 11, 35);
    private static final String NO_PORT = "there is no such port; is the board plugged in?";

    private final String name;
    private final SerialPort port;
    private int baud;
    private int timeoutMillis = -1;

    private SerialLink(String name, SerialPort port, int baud) {
        this.name = name;
        this.port = port;
        this.baud = baud;
    }

    /** An opener at {@link #DEFAULT_BAUD}; see {@link #opener(String, int)}. */
    public static LinkOpener opener(String name) {
        return opener(name, DEFAULT_BAUD);
    }

    /**
     * An opener of a port.
     *
     * @param name a path that exists when the port is opened, whose symbolic links are followed anew each time;
     *             or else the system's name of a port, such as {@code COM5} or {@code ttyACM0}.
     * @param baud bits a second.
     */
    public static LinkOpener opener(String name, int baud) {
        return new LinkOpener() {
            @Override
            public Link open() throws LinkException {
                return SerialLink.open(name, baud);
            }

            @Override
            public String name() {
                return name;
            }
        };
    }

    /**
     * The serial ports of this computer; none is opened.
     *
     * @return for each path that opens a port, the system's description of the device; in the order of the paths.
     * @throws JavinoException if serial ports cannot be used at all on this computer.
     */
    public static SortedMap<String, String> ports() throws JavinoException {
        NativeLibrary.load();
        SortedMap<String, String> ports = new TreeMap<>();
        for (SerialPort port : SerialPort.getCommPorts()) {
            ports.put(port.getSystemPortPath(), port.getPortDescription());
        }
        return ports;
    }

    private static SerialLink open(String name, int baud) throws LinkException {
        try {
            NativeLibrary.load();
        } catch (JavinoException e) {
            throw new LinkException(name, e.getMessage());
        }
        SerialPort port = find(name);
        port.setComPortParameters(baud, 8, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
        port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED);
        // 0: jSerialComm would otherwise sleep for 200 ms before it opens.
        if (!port.openPort(0)) {
            throw new LinkException(name, whyNotOpened(port.getLastErrorCode()));
        }
        return new SerialLink(name, port, baud);
    }

    private static SerialPort find(String name) throws LinkException {
        try {
            Path path = Path.of(name);
            if (Files.exists(path)) {
                return SerialPort.getCommPort(path.toRealPath().toString());
            }
            if (path.getNameCount() > 1) {
                // jSerialComm would take the last part of a path for a port in /dev.
                throw new LinkException(name, NO_PORT);
            }
            return SerialPort.getCommPort(name);
        } catch (SerialPortInvalidPortException | InvalidPathException e) {
            throw new LinkException(name, NO_PORT);
        } catch (IOException e) {
            throw new LinkException(name, "the link cannot be followed: " + e.getMessage());
        }
    }

    /** @param code the system's error, 0 where there is none. */
    static String whyNotOpened(int code) {
        if (code == NOT_A_TERMINAL) {
            return "is no serial port";
        }
        if (code == FORBIDDEN) {
            return "you may not read and write it; join its group (dialout on Debian) and log in anew";
        }
        if (BUSY.contains(code)) {
            return "another program is using it; end that first";
        }
        return "cannot be opened" + cause(code) + "; is another program using it, and may you read and write it?";
    }

    private static String cause(SerialPort port) {
        return cause(port.getLastErrorCode());
    }

    private static String cause(int code) {
        return code == 0 ? "" : " (system error " + code + ")";
    }

    @Override
    public void write(byte[] bytes) throws LinkException {
        int written = 0;
        while (written < bytes.length) {
            int count = port.writeBytes(bytes, bytes.length - written, written);
            if (count <= 0) {
                throw new LinkException(name, "cannot be written" + cause(port) + "; was the board unplugged?");
            }
            written += count;
        }
    }

    @Override
    public int read(byte[] into, Duration timeout) throws LinkException {
        int millis = roundedUp(timeout);
        if (millis != timeoutMillis) {
            port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, millis, 0);
            timeoutMillis = millis;
        }
        int count = port.readBytes(into, into.length);
        if (count < 0) {
            throw new LinkException(name, "cannot be read" + cause(port) + "; was the board unplugged?");
        }
        return count;
    }

    /** In steps of 100 ms: POSIX counts in them, and each other value costs a system call or two. Never 0: for ever. */
    private static int roundedUp(Duration timeout) {
        return (int) (timeout.toMillis() / TIMEOUT_STEP_MILLIS + 1) * TIMEOUT_STEP_MILLIS;
    }

    @Override
    public Duration timeFor(int bytes) {
        return Duration.ofNanos(1_000_000_000L * BITS_A_BYTE * bytes / baud);
    }

    @Override
    public int baud() {
        return baud;
    }

    @Override
    public void setBaud(int speed) throws LinkException {
        if (speed != baud && !port.setBaudRate(speed)) {
            throw new LinkException(name, "cannot be set to " + speed + " baud" + cause(port)
                    + "; was the board unplugged?");
        }
        baud = speed;
    }

    @Override
    public void close() {
        port.closePort();
    }
}
