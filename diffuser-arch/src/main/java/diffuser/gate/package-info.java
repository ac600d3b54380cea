/** What may come from outside an agent: texts are read, and each act is decided by {@link diffuser.gate.Policy}. */
package diffuser.gate;
