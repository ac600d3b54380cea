package diffuser;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

import jason.architecture.AgArch;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;

/** An architecture that perceives {@code other(1)} once and for all, and says so only once. */
public class PerceivingArch extends AgArch {

    private static final long serialVersionUID = 1L;

    private boolean told;

    @Override
    public Collection<Literal> perceive() {
        super.perceive();
        if (told) {
            return null;
        }
        told = true;
        return new ArrayList<>(List.of(ASSyntax.createLiteral("other", ASSyntax.createNumber(1))));
    }
}
