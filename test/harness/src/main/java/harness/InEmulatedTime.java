package harness;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.ClassTemplate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Has the tests of a class run in the emulated time of their boards, by a seed: the same run each time. The one that is
 * tagged {@code verify} runs in real time, too, where threads race. What they wait for must come by {@link Host} or
 * {@link Emulator}.
 */
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.RUNTIME)
@ClassTemplate
@ExtendWith(SeededRuns.class)
@Tag("emulated")
public @interface InEmulatedTime {}
