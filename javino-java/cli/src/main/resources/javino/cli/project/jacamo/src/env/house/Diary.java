package house;

import cartago.Artifact;
import cartago.OPERATION;

/** An artifact: agents that focus on it believe its entries, and any agent of the workspace may write one. */
public class Diary extends Artifact {

    private int entries;

    @OPERATION
    void write(String text) {
        entries++;
        defineObsProperty("entry", entries, text);
    }
}
