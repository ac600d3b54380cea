package systemtest;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import harness.Platform;
import java.io.File;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** JaCaMo, where -Pjacamo has named its Maven repository. */
final class JaCaMo {

    /** The lines by which an agent's program includes artifacts and organisations. */
    static final String TEMPLATES = """
            { include("$jacamo/templates/common-cartago.asl") }
            { include("$jacamo/templates/common-moise.asl") }
            { include("$moise/asl/org-obedient.asl") }
            """;

    private static final String SKIPPED = "skipped: what runs under JaCaMo needs -Pjacamo=URL of its Maven repository";
    private static final boolean IS_HERE = System.getProperty("javino.jacamoRepository") != null;

    static {
        if (!IS_HERE) {
            System.out.println(SKIPPED);
        }
    }

    private JaCaMo() {}

    /** A test under each version, which is its argument. */
    @Target(ElementType.METHOD)
    @Retention(RetentionPolicy.RUNTIME)
    @Tag("verify")
    @ParameterizedTest
    @ValueSource(strings = {"jacamo", "newerJacamo"})
    @interface EachVersion {
    }

    /** A version, with the classes of the MAS's folder; who asks is skipped, and says so, where there is none. */
    static Platform platform(String version) throws Exception {
        assumeTrue(IS_HERE, SKIPPED);
        String classPath = "." + File.pathSeparator + System.getProperty("javino." + version);
        Platform platform = version.startsWith("newer") ? NewerJava.with(classPath, "JaCaMo 1.3")
                : Platform.USUAL.with(Platform.USUAL.java(), classPath);
        return platform.launchedBy("jacamo.infra.JaCaMoLauncher", ".jcm");
    }
}
