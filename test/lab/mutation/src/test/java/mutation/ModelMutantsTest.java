package mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import uppaal.check.Query;
import uppaal.report.Firmware;

class ModelMutantsTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final Firmware NO_NUMBERS = new Firmware(List.of());
    private static final String LAMP = """
            <nta><declaration>const int MOST = 2; // model: 3 are too many
            int[0,MOST] on; chan press, hold;</declaration>
            <template><name>Lamp</name>
            <location id="id0"><name>Off</name></location>
            <location id="id1"><name>On</name><committed/></location>
            <init ref="id0"/>
            <transition><source ref="id0"/><target ref="id1"/><label kind="guard">on &lt; MOST</label>\
            <label kind="assignment">on++</label></transition>
            <transition><source ref="id1"/><target ref="id0"/></transition>
            </template>
            <system>system Lamp;</system></nta>
            """;
    private static final Model MODEL = new Model("lamp.xml", LAMP, List.of(new Model.Setting(xml -> xml,
            List.of(new Query("L1", true, "", "A[] on <= MOST", ""), new Query("L2", true, "", "E<> on == 2", "")))),
            NO_NUMBERS);

    private static ModelMutant mutant(String named) {
        return ModelMutants.of(LAMP).stream().filter(mutant -> mutant.toString().equals(named)).findFirst()
                .orElseThrow(() -> new AssertionError(named + " is none of " + ModelMutants.of(LAMP)));
    }

    private static Model.Fate fate(String named) {
        return MODEL.judge(mutant(named), MODEL.sound()).fate();
    }

    @Test
    void of_model_namesPlaceAndChangeOfEach() {
        assertEquals(List.of("declaration: 'MOST = 3' for '2'", "declaration: 'MOST = 1' for '2'",
                "Lamp, On: no longer committed",
                "Lamp, Off -> On [on < MOST; on++], guard: without 'on < MOST'",
                "Lamp, Off -> On [on < MOST; on++], guard: 'on >= MOST' for 'on < MOST'",
                "Lamp, Off -> On [on < MOST; on++], guard: '<=' for '<' in 'on < MOST'",
                "Lamp, Off -> On [on < MOST; on++], guard: '!=' for '<' in 'on < MOST'",
                "Lamp, Off -> On [on < MOST; on++], guard: '(MOST + 1)' for 'MOST' in 'on < MOST'",
                "Lamp, Off -> On [on < MOST; on++], guard: '(MOST - 1)' for 'MOST' in 'on < MOST'",
                "Lamp, Off -> On [on < MOST; on++], update: without 'on++'",
                "Lamp, Off -> On [on < MOST; on++], update: 'on--' for 'on++'",
                "Lamp, Off -> On [on < MOST; on++]: leads to Off", "Lamp, Off -> On [on < MOST; on++]: removed",
                "Lamp, On -> Off []: leads to On", "Lamp, On -> Off []: removed"),
                ModelMutants.of(LAMP).stream().map(ModelMutant::toString).toList());
    }

    @Test
    @Tag("soak")
    void of_everyModel_givesMutantsThatDifferFromItAndFromEachOther() throws IOException {
        for (Model model : Model.all(ROOT)) {
            List<String> files = ModelMutants.of(model.xml()).stream().map(ModelMutant::xml).toList();
            assertTrue(files.size() > 100, model.name());
            assertEquals(files.size(), new HashSet<>(files).size());
            assertFalse(files.contains(ModelMutants.with(model.xml(), "system", same -> same)));
        }
    }

    @Test
    void of_twice_isTheSame() {
        assertEquals(ModelMutants.of(LAMP), ModelMutants.of(LAMP));
    }

    @Test
    void judge_verdictThatChanges_isKilled() {
        assertEquals(Model.Fate.KILLED, fate("Lamp, Off -> On [on < MOST; on++]: removed"));
    }

    @Test
    void judge_variableOutOfItsRange_isKilled() {
        Model.Verdict verdict = MODEL.judge(mutant("Lamp, Off -> On [on < MOST; on++], guard: without 'on < MOST'"),
                MODEL.sound());
        assertEquals(new Model.Verdict(Model.Fate.KILLED, Behaviour.RANGE), verdict);
    }

    @Test
    void judge_sameStatesAndMoves_isEquivalent() {
        assertEquals(Model.Fate.EQUIVALENT,
                fate("Lamp, Off -> On [on < MOST; on++], guard: '!=' for '<' in 'on < MOST'"));
    }

    @Test
    void judge_otherMovesThatNoQueryNotices_survives() {
        assertEquals(Model.Fate.SURVIVED, fate("Lamp, Off -> On [on < MOST; on++]: leads to Off"));
    }

    @Test
    void judge_committedOrNotWhereNobodyElseMoves_isEquivalent() {
        assertEquals(Model.Fate.EQUIVALENT, fate("Lamp, On: no longer committed"));
    }

    @Test
    void judge_whatUppaalDoesNotRead_isInvalid() {
        ModelMutant negative = new ModelMutant("declaration", "no range",
                LAMP.replace("const int MOST = 2;", "const int MOST = -1;"));
        assertEquals(Model.Fate.INVALID, MODEL.judge(negative, MODEL.sound()).fate());
    }

    @Test
    void judge_sameStatesButOtherMoves_survives() {
        String back = "<transition><source ref=\"id1\"/><target ref=\"id0\"/></transition>";
        String twoWays = LAMP.replace("on &lt; MOST", "").replace("on++", "").replace("<committed/>", "");
        Model model = new Model("two.xml", twoWays, List.of(new Model.Setting(xml -> xml,
                List.of(new Query("T1", true, "", "E<> Lamp.On", "")))), NO_NUMBERS);
        ModelMutant oneWay = new ModelMutant("", "", twoWays.replace(back, ""));
        assertEquals(Model.Fate.SURVIVED, model.judge(oneWay, model.sound()).fate());
    }

    @Test
    void judge_listenerThatChangesNothing_isEquivalentWithoutIt() {
        String listens = "<transition><source ref=\"id1\"/><target ref=\"id1\"/>"
                + "<label kind=\"synchronisation\">hold?</label></transition>";
        String two = LAMP.replace("chan press, hold", "broadcast chan hold").replace("<committed/>", "")
                .replace("</template>", listens + """
                        </template><template><name>Hand</name><location id="id2"/><init ref="id2"/>
                        <transition><source ref="id2"/><target ref="id2"/>
                        <label kind="synchronisation">hold!</label></transition></template>
                        """).replace("system Lamp", "system Lamp, Hand");
        Model model = new Model("two.xml", two, MODEL.settings(), NO_NUMBERS);
        ModelMutant deaf = new ModelMutant("", "", two.replace(listens, ""));
        assertEquals(Model.Fate.EQUIVALENT, model.judge(deaf, model.sound()).fate());
    }

    @Test
    void of_lastMutant_hasNothingOfThoseBeforeIt() {
        String back = "<transition><source ref=\"id1\"/><target ref=\"id0\"/></transition>";
        assertEquals(ModelMutants.with(LAMP.replace(back, ""), "system", same -> same),
                mutant("Lamp, On -> Off []: removed").xml());
    }

    @Test
    void judge_numberThatIsNotTheFirmwares_isKilled() {
        String named = LAMP.replace("// model: 3 are too many", "// = LAMPS");
        Model model = new Model("lamp.xml", named, MODEL.settings(),
                new Firmware(List.of("static const uint8_t LAMPS = 2;")));
        assertEquals(new Model.Verdict(Model.Fate.KILLED, Model.FIRMWARE),
                model.judge(ModelMutants.of(named).get(0), model.sound()));
    }
}
