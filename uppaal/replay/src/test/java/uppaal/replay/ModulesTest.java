package uppaal.replay;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** What {@code gradle highway -Pradio=hc-12} has left in its build folder, and the same spoilt. */
class ModulesTest {

    private final Lines lines = Lines.of("modules");

    private int unicast() {
        return lines.where(line -> lines.is(line, "support", "rf-tx") && lines.text(line, "kind").equals("unicast"))
                .get(0);
    }

    private void assertRefused(int at, String words) {
        String refusal = lines.replayWithKeys("modules").refusal().orElse("accepted");
        assertTrue(refusal.startsWith("event " + at + " (") && refusal.contains(words), refusal);
    }

    @Test
    void replay_genuineTrace_isAccepted() {
        String verdict = lines.replayWithKeys("modules").verdict();
        assertTrue(verdict.startsWith("model: trace accepted") && verdict.contains("7 messages opened"), verdict);
    }

    @Test
    void replay_packetOfOtherLength_isRefused() {
        lines.get(unicast()).addProperty("bits", 8 + lines.get(unicast()).get("bits").getAsInt());
        assertRefused(unicast(), "bits; expected");
    }

    @Test
    void replay_otherBytesThanWereSealed_isRefused() {
        int sent = unicast();
        String payload = lines.text(sent, "payload");
        String spoilt = payload.substring(0, payload.length() - 2) + (payload.endsWith("00") ? "01" : "00");
        for (int line : lines.where(each -> lines.text(each, "payload").equals(payload))) {
            lines.get(line).addProperty("payload", spoilt);
        }
        assertRefused(sent, "support");
    }

    @Test
    void replay_messageThatNobodySent_isRefused() {
        int handed = lines.where(line -> lines.is(line, "hospital", "host-handed")
                && lines.text(line, "origin").equals("SUPP")).get(0);
        List<Integer> received = lines.where(line -> lines.is(line, "hospital", "rf-rx")
                && lines.text(line, "payload").equals(lines.text(unicast(), "payload")));
        Lines without = lines.without(received::contains);
        String refusal = without.replayWithKeys("modules").refusal().orElse("accepted");
        assertTrue(refusal.startsWith("event " + (handed - received.size()) + " ("), refusal);
    }
}
