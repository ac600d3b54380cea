package jason.stdlib;

import java.util.EnumSet;
import java.util.Set;

import jason.JasonException;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Term;

import diffuser.Diffuser;
import diffuser.DiffuserAction;
import diffuser.gate.Names;
import diffuser.mind.Ability;

/**
 * <p>Internal action: <b><code>.infrastructure(<i>Name</i>,<i>Abilities</i>)</code></b>.
 *
 * <p>Description: tells which abilities an infrastructure other than the board's radio, such as the telephone network,
 * gives from now on, for the belief <code>openness(S)</code>. The action neither checks nor uses the infrastructure. An
 * ability is lost with the last infrastructure that gives it.
 *
 * <p>Parameters:<ul>
 * <li>+ Name (atom or string): any name for it; a new call with the same name replaces the last one.
 * <li>+ Abilities (list): of <code>com</code>, if agents of this MAS and another can exchange messages by it, and
 * <code>mob</code>, if agents can move by it from one MAS to another; <code>[]</code> if it does not work.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.infrastructure(lte,[com,mob])</code>
 * <li> <code>.infrastructure(lte,[])</code>: it does not work now.
 * </ul>
 */
public class infrastructure extends DiffuserAction {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMinArgs() {
        return 2;
    }

    @Override
    protected void perform(Diffuser diffuser, Term[] args) throws JasonException {
        String name = Names.of(args[0]).orElseThrow(() -> JasonException.createWrongArgument(this,
                "a name for the infrastructure was expected, not '" + args[0] + "'."));
        diffuser.setInfrastructure(name, abilities(args[1]));
    }

    private Set<Ability> abilities(Term argument) throws JasonException {
        if (!argument.isList() || !argument.isGround()) {
            throw wrong(argument);
        }
        Set<Ability> abilities = EnumSet.noneOf(Ability.class);
        for (Term term : (ListTerm) argument) {
            abilities.add(switch (term.toString()) {
                case "com" -> Ability.COM;
                case "mob" -> Ability.MOB;
                default -> throw wrong(argument);
            });
        }
        return abilities;
    }

    private JasonException wrong(Term found) {
        return JasonException.createWrongArgument(this,
                "a list of com and mob, or [], was expected, not '" + found + "'.");
    }
}
