package jason.asSemantics;

import java.util.Map;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.PlanBodyImpl;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.VarTerm;

/** The parts of an {@link IntendedMeans}, a plan that is being carried out, that Jason keeps to its own package. */
public final class Frames {

    /** Jason computes what is in a trigger that it is given; in this one there is nothing. */
    private static final Trigger NOTHING =
            new Trigger(Trigger.TEOperator.add, Trigger.TEType.belief, ASSyntax.createLiteral("nothing"));

    private Frames() {
    }

    /**
     * A plan that is being carried out.
     *
     * @param toDo    its steps that are still to be done; null if none.
     * @param values  the values of its variables.
     * @param renamed names of its variables in the goal that it waits for; null if it has not waited.
     * @param atFirst the values when it began, which its goal's condition and its plans within have.
     */
    public static IntendedMeans of(Plan plan, Trigger trigger, PlanBody toDo, Map<VarTerm, Term> values,
            Map<VarTerm, Term> renamed, Map<VarTerm, Term> atFirst) {
        IntendedMeans frame = new IntendedMeans(new Option(plan, new Unifier()), NOTHING);
        frame.setTrigger(trigger);
        frame.planBody = toDo;
        frame.unif = unifier(values);
        frame.renamedVars = renamed == null ? null : unifier(renamed);
        frame.triggerUnif = unifier(atFirst);
        return frame;
    }

    /** Puts a step before those that are still to be done: Jason tells why a plan has failed only where it has one. */
    public static void standAt(IntendedMeans frame, InternalActionLiteral step) {
        PlanBody body = new PlanBodyImpl(PlanBody.BodyType.internalAction, step);
        body.setBodyNext(frame.planBody);
        frame.planBody = body;
    }

    /** With these values, as Jason may change them. */
    public static Unifier unifier(Map<VarTerm, Term> values) {
        Unifier unifier = new Unifier();
        unifier.function.putAll(values);
        return unifier;
    }

    /** The values in a unifier, which may be null. */
    public static Map<VarTerm, Term> values(Unifier unifier) {
        return unifier == null ? Map.of() : unifier.function;
    }

    /** Names of a plan's variables in the goal that it waits for. */
    public static Map<VarTerm, Term> renamed(IntendedMeans frame) {
        return values(frame.renamedVars);
    }

    /** The values when the plan began. */
    public static Map<VarTerm, Term> atFirst(IntendedMeans frame) {
        return values(frame.triggerUnif);
    }
}
