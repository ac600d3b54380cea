package mutation;

/**
 * One small change of a text.
 *
 * @param what in a few words
 * @param text the text with it
 */
record Change(String what, String text) {}
