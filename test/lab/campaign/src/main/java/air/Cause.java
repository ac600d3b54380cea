package air;

/** Why a packet began while another was on the air, or why it was damaged where none was. */
enum Cause {

    SAME_SLOT("S", "same slot", "both began within a slot, so that neither could hear the other"),
    HIDDEN("H", "hidden", "its sender is out of the other's range"),
    OWN("O", "sent itself", "its sender was sending when the other began, and so did not hear that"),
    BURIED("B", "began in a collision", "the other began among others, or in a jam, and was not to be made out"),
    MISSED("M", "carrier missed", "its sender could have heard the other for a slot or more"),
    JAM("J", "jam", "no packet of another board, but a jam"),
    UNFINISHED("U", "unfinished packet",
            "another was on the air that was never whole: its sender was reset, or the trace ends"),
    NOISE("N", "bit errors", "nothing else was on the air in range");

    /** The mark in the picture. */
    final String mark;
    final String title;
    final String meaning;

    Cause(String mark, String title, String meaning) {
        this.mark = mark;
        this.title = title;
        this.meaning = meaning;
    }
}
