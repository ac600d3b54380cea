/** Internal actions as agents for the public Difuser architecture write them: {@code .difuser.transmit(X)}. */
package jason.stdlib.difuser;
