package javino.board;

/** For people: that another part of a sketch uses the radio's timer too (SPEC 4.3). */
final class RadioTimer {

    private RadioTimer() {
    }

    /** The line that says what to do about it. */
    static String ofTaken(int timer) {
        return "another part of the sketch uses the radio's timer " + timer + ", by analogWrite() or a library: write "
                + "#define JAVINO_RADIO_TIMER " + (timer == 0 ? 1 : 0) + " before you include JavinoBDI.h";
    }
}
