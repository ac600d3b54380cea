/**
 * Agents that travel: a move brings an agent from one MAS to another by radio (SPEC 9), with what it believed and
 * intended, and there is never more than one of it awake.
 */
package mobility;
