/** A session with one board: hello, requests, polls, and finding the board again when it was lost (SPEC 4.2, 4.3). */
package javino.board;
