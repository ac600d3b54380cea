package javino.board;

/** For people: that another part of a sketch uses the radio's timer too (SPEC 4.3). */
public final class RadioTimer {

    private static final String OTHER_PART = "another part of the sketch uses the radio's timer ";

    private RadioTimer() {
    }

    /** The line that says what to do about it. */
    static String ofTaken(int timer) {
        return OTHER_PART + timer + ", by analogWrite() or a library: write #define JAVINO_RADIO_TIMER "
                + (timer == 0 ? 1 : 0) + " before you include JavinoBDI.h";
    }

    /** Whether a board's warning is that. */
    public static boolean isOfTaken(String warning) {
        return warning.startsWith(OTHER_PART);
    }
}
