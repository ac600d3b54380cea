/** Jason in the time of a simulation. One program has it, loaded anew. */
package lockstep.agents;
