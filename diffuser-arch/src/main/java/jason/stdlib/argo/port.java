package jason.stdlib.argo;

import java.util.concurrent.CompletableFuture;

import jason.JasonException;
import jason.asSyntax.Term;

import diffuser.Diffuser;

/**
 * {@code .argo.port}, as agents for Argo write {@link jason.stdlib.port}. It accepts a second argument, whether the
 * agent may sleep, and ignores it: the agent always sleeps until something arrives.
 */
public class port extends jason.stdlib.port {

    private static final long serialVersionUID = 1L;

    @Override
    protected CompletableFuture<?> start(Diffuser diffuser, Term[] args) throws JasonException {
        return super.start(diffuser, new Term[] {args[0]});
    }
}
