package features;

import features.Seen.Kind;
import io.cucumber.java.en.Given;
import io.cucumber.java.en.Then;
import io.cucumber.java.en.When;
import java.util.function.Function;
import javino.protocol.Address;
import javino.protocol.Content;

/** Devices that are only played, their keys and messages, the radio, and an attacker. */
public final class RadioSteps {

    /** A device of that address (four letters or digits), which sends, receives and acknowledges as any other. */
    @Given("the device {word}")
    public void device(String name) {
        Run.before().others.device(name);
    }

    /** A key, made for this scenario, is on both boards before the agents start; the agent gives its board the id. */
    @Given("{peer} and the device {word} share a key")
    public void key(Parameters.Peer peer, String device) {
        Run.before().others.key(peer, device, true);
    }

    /** Each has a key for the other, and they differ. */
    @Given("{peer} and the device {word} have different keys")
    public void otherKey(Parameters.Peer peer, String device) {
        Run.before().others.key(peer, device, false);
    }

    /** In metres. */
    @Given("the radio reaches {int} m")
    public void range(int metres) {
        Run.before().radio.put("range", metres);
    }

    /** The probability that a receiver gets a bit slot inverted, 0 to 1. */
    @Given("the radio's bit error rate is {double}")
    public void errors(double rate) {
        Run.before().radio.put("bitErrorRate", rate);
    }

    /** The chance that the receiver of a serial module misses a piece, 0 to 1; {@code board.json} names the module. */
    @Given("the radio loses a share of {double}")
    public void loss(double share) {
        Run.before().radio.put("loss", share);
    }

    /** By a performative such as tell; sealed, if there is a key. */
    @When("the device {word} sends {word} {term} to {word}")
    public void sends(String device, String performative, String term, String to) {
        Run.now().others.send(device, address(to), content(performative, term));
    }

    @When("the device {word} sends {word} {term} by broadcast")
    public void broadcasts(String device, String performative, String term) {
        Run.now().others.send(device, Address.BROADCAST, content(performative, term));
    }

    /** Without a key, in the name of another, by a broadcast. */
    @When("an attacker sends {word} {term} as {word}")
    public void forges(String performative, String term, String as) {
        Run.now().others.forge(address(as), content(performative, term));
    }

    /** The bytes of the last packet of that board or device, once more. */
    @When("an attacker repeats the last packet of {word}")
    public void repeats(String who) {
        Run.now().others.repeat(who);
    }

    /** Each packet on the air counts, also one that is sent once more; nobody sees what is in it. */
    @Then("{window}{board} board sends a sealed message to {word}{often}")
    public void sendsSealed(Window window, String board, String to, Window.Count count) {
        sends(window, board, "to " + address(to) + ", sealed", count);
    }

    /** Each packet on the air counts. */
    @Then("{window}{board} board broadcasts {word} {term}{often}")
    public void sendsPlain(Window window, String board, String performative, String term, Window.Count count) {
        sends(window, board, "to " + Address.BROADCAST + " " + content(performative, term), count);
    }

    private static void sends(Window window, String board, String packet, Window.Count count) {
        if (!Run.now().isUnseen(window)) {
            Run.now().expected.event(window, count, each -> each.is(Kind.PACKET, board) && each.more().equals(packet),
                    board + "'s board sends no packet " + packet);
        }
    }

    @Then("{window}the device {word} gets {word} {term}{often}")
    public void gets(Window window, String device, String performative, String term, Window.Count count) {
        String content = "" + content(performative, term);
        Run.now().expected.event(window, count, each -> each.is(Kind.GETS, device) && each.what().equals(content),
                "the device " + device + " does not get " + content);
    }

    /** Of the device's messages: acknowledged with a proof, or not. */
    @Then("{window}the message of the device {word} is {outcome}")
    public void outcome(Window window, String device, String outcome) {
        Run.now().expected.event(window, null, each -> each.is(Kind.OUTCOME, device) && each.more().equals(outcome),
                "no message of the device " + device + " is " + outcome);
    }

    /** A counter of the board of that agent (SPEC 4.5), such as radioBadTag; since the scenario began. */
    @Then("{window}the counter {word} of {agent} rises")
    public void rises(Window window, String counter, String agent) {
        Run.now().expected.counter(window, agent, counter);
    }

    private static Address address(String text) {
        return parsed(Address::parse, text);
    }

    private static Content content(String performative, String term) {
        return parsed(Content::parse, performative + ";" + term);
    }

    private static <T> T parsed(Function<String, T> parser, String text) {
        try {
            return parser.apply(text);
        } catch (IllegalArgumentException e) {
            throw Run.now().wrong(e.getMessage());
        }
    }
}
