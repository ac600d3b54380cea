/** The page on which one watches a run, a trace or a board, and interferes: {@code javino watch}. */
package live;
