package house;

import cartago.Artifact;
import cartago.OPERATION;

/** An artifact: who focuses on it believes its entries, and who can reach it may write one. */
public class Diary extends Artifact {

    private int entries;

    @OPERATION
    void write(String text) {
        entries++;
        defineObsProperty("entry", entries, text);
    }
}
