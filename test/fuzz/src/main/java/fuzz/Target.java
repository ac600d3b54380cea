package fuzz;

import diffuser.GateTarget;
import java.nio.file.Path;
import java.util.List;
import javino.keyring.KeyringTarget;
import keyagreement.KeyAgreementTarget;

/**
 * Something that takes any bytes and fails where it finds a fault.
 *
 * @param name    a single word; its corpus has the same name.
 * @param command the command that runs it, to be followed by libFuzzer's options and then the folders of its corpus.
 */
public record Target(String name, List<String> command) {

    private static final List<Class<?>> JAVA =
            List.of(FrameTarget.class, ContentTarget.class, PacketDecoderTarget.class,
                    ReplyTarget.class, RequestTarget.class, KeyringTarget.class, GateTarget.class,
                    KeyAgreementTarget.class);
    private static final List<String> FIRMWARE =
            List.of("packet_decoder", "arguments", "radio", "reed_solomon", "board");

    /** The decoders of the Java library, under Jazzer. */
    public static List<Target> ofJava() {
        return JAVA.stream().map(type -> new Target(type.getSimpleName(), jazzer(type))).toList();
    }

    /**
     * The parts of the firmware, under libFuzzer.
     *
     * @param built the folder in which CMake built native.
     */
    public static List<Target> ofFirmware(Path built) {
        return FIRMWARE.stream().map(name -> new Target(name, List.of(built.resolve("fuzz-" + name).toString())))
                .toList();
    }

    /** The command for any class that has {@code fuzzerTestOneInput(byte[])}. */
    public static List<String> jazzer(Class<?> type) {
        return List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx512m",
                "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1",  // half the time that it takes to start
                "-cp", System.getProperty("java.class.path"), "com.code_intelligence.jazzer.Jazzer",
                "--target_class=" + type.getName(),
                "--instrumentation_includes=javino.**:diffuser.**:keyagreement.**:fuzz.**");
    }
}
