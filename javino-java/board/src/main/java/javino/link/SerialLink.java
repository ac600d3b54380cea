package javino.link;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.locks.LockSupport;
import javino.JavinoException;

/** A serial port: 8 data bits, no parity, one stop bit, no flow control (SPEC 4). */
public final class SerialLink implements Link {

    /** The default baud rate of boards. */
    public static final int DEFAULT_BAUD = 115_200;

    /** A start bit, eight of data, a stop bit. */
    private static final int BITS_A_BYTE = 10;
    /** The shortest reply of a board (SPEC 4): a reader that waits for so many bytes delays none. */
    private static final int SHORTEST_REPLY = 17;
    /** How many further bytes are collected, so that the reader does not wake for each. */
    private static final int SOME_BYTES = 4;
    /** Milliseconds without a byte after which the next one begins a reply. */
    private static final int QUIET_MILLIS = 3;
    /** How long the end of the reader is waited for. */
    private static final int ENDING_MILLIS = 100;
    /** ENOTTY of Linux, macOS and the BSDs. */
    private static final int NOT_A_TERMINAL = 25;
    /** EACCES of the same. */
    private static final int FORBIDDEN = 13;
    /** EBUSY of the same, and EWOULDBLOCK, with which a port that is locked is refused, of Linux and of the others. */
    private static final Set<Integer> BUSY = Set.of(16, 11, 35);
    /** ENOENT, ENXIO and ENODEV of the same: the device has gone. */
    private static final Set<Integer> GONE = Set.of(2, 6, 19);
    /** EIO, and EBADF, of the same: it goes just now. */
    private static final Set<Integer> GOING = Set.of(5, 9);
    private static final String NO_PORT = "there is no such port; is the board plugged in?";
    private static final String NO_SERIAL_PORT = "is no serial port; javino ports lists them";

    private final String name;
    private final SerialPort port;
    private final Incoming incoming;
    private final Thread reader;
    private volatile int baud;
    private volatile boolean closed;

    private SerialLink(String name, SerialPort port, int baud) {
        this.name = name;
        this.port = port;
        this.baud = baud;
        incoming = new Incoming(name);
        // No virtual thread, as it waits in the system.
        reader = new Thread(this::read, "javino " + name + " reader");
        reader.setDaemon(true);
        reader.start();
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
        // A read ends when a byte comes, or the port is closed.
        port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, 0, 0);
        return new SerialLink(name, port, baud);
    }

    private static SerialPort find(String name) throws LinkException {
        try {
            Path path = Path.of(name);
            if (Files.isDirectory(path)) {
                throw new LinkException(name, "is a folder; javino ports lists serial ports");
            }
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
            return NO_SERIAL_PORT;
        }
        if (code == FORBIDDEN) {
            return "you may not read and write it; join its group (dialout on Debian) and log in anew";
        }
        if (GONE.contains(code)) {
            return NO_PORT;
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
        return code == 0 || GONE.contains(code) || GOING.contains(code) ? "" : " (errno " + code + ")";
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

    /** The reader: waits in the system until bytes come. */
    private void read() {
        byte[] buffer = new byte[1024];
        long last = System.nanoTime();
        while (true) {
            int count = port.readBytes(buffer, 1);
            if (count == 1) {
                // A serial line gives a few bytes at a time; being woken for each would be most of what a board costs.
                long now = System.nanoTime();
                boolean first = now - last > QUIET_MILLIS * 1_000_000L;
                LockSupport.parkNanos(timeFor(first ? SHORTEST_REPLY - 1 : SOME_BYTES).toNanos());
                count = readWhatIsThere(buffer);
                last = System.nanoTime();
            }
            // Nothing, from a read without end: the other side has gone.
            if (closed || count <= 0) {
                incoming.end("cannot be read" + cause(port) + "; was the board unplugged?");
                return;
            }
            incoming.add(Arrays.copyOf(buffer, count));
        }
    }

    /** Reads the bytes that are there, behind the one that was read already. */
    private int readWhatIsThere(byte[] buffer) {
        int there = port.bytesAvailable();
        int more = there <= 0 ? there : port.readBytes(buffer, Math.min(there, buffer.length - 1), 1);
        return more < 0 ? more : 1 + more;
    }

    @Override
    public int read(byte[] into, Duration timeout) throws LinkException {
        return incoming.read(into, timeout);
    }

    @Override
    public void wake() {
        incoming.wake();
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
        closed = true;
        port.closePort();
        try {
            reader.join(ENDING_MILLIS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
