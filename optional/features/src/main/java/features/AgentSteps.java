package features;

import io.cucumber.java.en.Given;
import io.cucumber.java.en.When;
import java.nio.file.Path;

/** The agents, and what they are given. */
public final class AgentSteps {

    /** Another {@code .mas2j} or {@code .jcm} than the project's. */
    @Given("the agents of {string}")
    public void agents(String file) {
        Run.before().agentsFile = Path.of(file);
    }

    @When("{agent} gets the goal {term}")
    public void goal(String agent, String goal) {
        Run.now().give(agent, "+!" + goal);
    }

    @When("{agent} gets the belief {term}")
    public void belief(String agent, String belief) {
        Run.now().give(agent, "+" + belief);
    }

    @When("{agent} loses the belief {term}")
    public void noBelief(String agent, String belief) {
        Run.now().give(agent, "-" + belief);
    }
}
