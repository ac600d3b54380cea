/** The board on one port: its percepts, keys and radio, and the libraries that use it. */
package diffuser.board;
