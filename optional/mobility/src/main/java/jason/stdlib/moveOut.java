package jason.stdlib;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

import jason.JasonException;
import jason.asSemantics.DefaultInternalAction;
import jason.asSemantics.TransitionSystem;
import jason.asSemantics.Unifier;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Term;

import diffuser.gate.Names;
import diffuser.mind.Destinations;

import mobility.Departures;
import mobility.Protocol;

/**
 * <p>Internal action: <b><code>.moveOut(<i>To</i>,<i>Protocol</i>[,<i>Agents</i>])</code></b>.
 *
 * <p>Description: moves the agent, or the named agents of its MAS, by radio to the MAS of another device, with their
 * beliefs, rules, plans and intentions. The intention goes on <em>there</em> behind this step. If others are moved, it
 * goes on here when all have arrived. If an agent stays, the intention fails here, with the agent as it was: among
 * others with the errors <code>refused</code> (no plan for <code>+!moveIn(Agent,Protocol)</code> there admits it,
 * or it goes home by another way than it went), <code>guest</code> (a guest moves on only as a guest or to its home),
 * <code>undelivered</code> (the other device was not heard for a minute), <code>too_large</code>,
 * <code>no_key</code>, <code>cannot_travel</code> (something in the agent has no text),
 * <code>not_mobile</code>, <code>lacks</code> (the other side lacks an internal action).
 *
 * <p>Parameters:<ul>
 * <li>+ To (string, atom or the name of a variable without value): a device such as <code>"ROMA"</code>.
 * <li>+ Protocol (atom): <code>mutualism</code>, <code>inquilinism</code> (there it cannot reach the board),
 * <code>cloning</code> (the original stays) or <code>predation</code> (it takes the other MAS over).
 * <li>+ Agents (atom, string, or a list of such): the agents that move; by default the one that says this.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.moveOut("SUBB",inquilinism)</code>
 * <li> <code>.moveOut("SUBB",mutualism,[doctor,nurse])</code>
 * </ul>
 *
 * @see deliver
 */
public class moveOut extends DefaultInternalAction {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMinArgs() {
        return 2;
    }

    @Override
    public int getMaxArgs() {
        return 3;
    }

    @Override
    public boolean canBeUsedInContext() {
        return false;
    }

    @Override
    public boolean suspendIntention() {
        return true;
    }

    @Override
    protected void checkArguments(Term[] args) throws JasonException {
        super.checkArguments(args);
        if (!args[1].isAtom() || Protocol.of(args[1].toString()).isEmpty()) {
            throw JasonException.createWrongArgument(this, "mutualism, inquilinism, cloning or predation was expected,"
                    + " not '" + args[1] + "'.");
        }
    }

    @Override
    public Object execute(TransitionSystem ts, Unifier un, Term[] args) throws JasonException {
        checkArguments(args);
        List<String> agents = args.length == 2 ? List.of(ts.getAgArch().getAgName()) : names(args[2]);
        Departures.begin(ts, Destinations.device(args[0]), Protocol.of(args[1].toString()).orElseThrow(),
                agents);
        return true;
    }

    private List<String> names(Term argument) throws JasonException {
        Set<String> names = new LinkedHashSet<>();
        for (Term single : argument.isList() && !argument.isVar() ? (ListTerm) argument : List.of(argument)) {
            names.add(Names.of(single).orElseThrow(() -> JasonException.createWrongArgument(this,
                    "the names of agents were expected, not '" + argument + "'.")));
        }
        if (names.isEmpty()) {
            throw JasonException.createWrongArgument(this, "the names of agents were expected, not an empty list.");
        }
        return List.copyOf(names);
    }
}
