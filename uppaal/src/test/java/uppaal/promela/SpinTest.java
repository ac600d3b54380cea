package uppaal.promela;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import uppaal.RandomNetworks;
import uppaal.Sketch;
import uppaal.TinyNetworks;
import uppaal.check.Exploration;
import uppaal.check.Property;
import uppaal.network.Network;

/** SPIN and our checker must agree on every network: in the number of states, in deadlocks, in verdicts. */
@Tag("verify")
class SpinTest {
    @TempDir
    private Path folder;

    @BeforeAll
    static void spinIsInstalled() {
        assumeTrue(Spin.available(), "spin or gcc is not on the path");
    }

    private void assertAgreed(Network network, List<Property> properties) throws IOException {
        Exploration own = Exploration.of(network, properties);
        Spin.Result spin = Spin.check(network, properties, folder);
        assertEquals(own.states(), spin.states());
        assertEquals(own.deadlocks() > 0, spin.deadlock());
        for (int i = 0; i < properties.size(); i++) {
            assertEquals(own.holds(i), spin.holds().get(i), properties.get(i).text());
        }
    }

    @ParameterizedTest
    @MethodSource("uppaal.TinyNetworks#all")
    void check_tinyNetwork_agreesWithOurChecker(TinyNetworks.Tiny tiny) throws IOException {
        Network network = tiny.sketch().network();
        assertAgreed(network, List.of(Property.parse(tiny.property(), network, "here")));
    }

    @ParameterizedTest
    @ValueSource(longs = {2, 4, 9, 10, 11, 12})
    void check_randomNetwork_agreesWithOurChecker(long seed) throws IOException {
        Network network = RandomNetworks.network(seed);
        assertAgreed(network, List.of(Property.parse("A[] not deadlock", network, "here"),
                Property.parse("E<> x == 0 && y == 2", network, "here"),
                Property.parse("A[] x + y < 4", network, "here")));
    }

    @Test
    void check_variableLeavesItsRange_isSaid() {
        Network network = Sketch.of("int[0,255] x = 250;").template("P", "a -> a; set x = x + 1").network();
        assertTrue(assertThrows(IOException.class, () -> Spin.check(network, List.of(), folder))
                .getMessage().contains("a variable leaves its range"));
    }
}
