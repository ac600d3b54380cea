/** A session with one board: greeted, asked, polled, and found again when it was gone (SPEC 4.2, 4.3). */
package javino.board;
