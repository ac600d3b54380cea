/** The gate for input from outside an agent: it reads texts, and asks {@link diffuser.gate.Policy} for each act. */
package diffuser.gate;
